#pragma once
// Compiles kernels on all cores. PoCL compiles under one lock per process, so each worker is a process of its own: this program with
// the hidden command compile-kernels. Workers store their kernels in the cache, where the rendering process finds them. It compiles a
// kernel itself if a worker failed, and then reports the error.

#include "render/options.h"

#include <functional>

namespace eikonal {

struct PackedScene;

/// Compiles the `missing` stages of a scene into the cache, with up to one process per core, and waits for them. Does nothing if there
/// are too few stages to be worth it. stepDone: called by this thread each time that a worker has built or first launched a kernel.
void compileInWorkers(const DeviceOptions& options, const PackedScene& scene, int missing, const std::function<void()>& stepDone);

/// The worker's task: compiles its part of the stages, launches each once, and stores them in the cache. Prints a character for each step.
void compileKernels(const DeviceOptions& options, const CompileRequest& request);

}  // namespace eikonal
