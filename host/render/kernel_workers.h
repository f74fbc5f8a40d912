#pragma once
// Compiles kernels on all cores. PoCL compiles under one lock per process, so each worker is a process of its own: this program with
// the hidden command compile-kernels. Workers store their kernels in the cache, where the rendering process finds them. It compiles a
// kernel itself if a worker failed, and then reports the error.

#include "render/options.h"

namespace eikonal {

struct PackedScene;

/// Compiles the `missing` stages of a scene into the cache, with up to one process per core, and waits for them. Does nothing if there
/// are too few stages to be worth it.
void compileInWorkers(const DeviceOptions& options, const PackedScene& scene, int missing);

/// The worker's task: compiles its part of the stages, launches each once, and stores them in the cache.
void compileKernels(const DeviceOptions& options, const CompileRequest& request);

}  // namespace eikonal
