#pragma once
// Compiling kernels on all cores. PoCL holds one lock for a whole process while it compiles, so each worker is a process of its own:
// this program again, with the hidden command compile-kernels. What workers compile they leave in the cache of kernels, and the
// program that renders finds it there; what a worker fails at, it compiles itself, and says what is wrong.

#include "app/options.h"
#include "render/stages.h"

namespace eikonal {

/// Has `missing` stages of a scene compiled into the cache, by as many processes as there are cores and work for them; returns when
/// they are done. Does nothing if that would not pay.
void compileInWorkers(const DeviceOptions& options, const PackedScene& scene, int missing);

/// What a worker does: compiles its part of the stages, launches each once, and keeps them.
int compileKernelsCommand(const Options& options);

}  // namespace eikonal
