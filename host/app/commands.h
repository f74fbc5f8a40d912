#pragma once
// What the program can do. Each command returns the program's exit status, or throws an Error that carries it.

#include "app/options.h"

namespace eikonal {

/// Renders a scene into image files. 0: they are all on disk, with a sample in every pixel; 128 + the signal's number if one ended it early.
int renderCommand(const Options& options);
/// Prints what a scene holds, what it requires and why, and the memory that it would take.
int infoCommand(const Options& options);
/// Measures a scene, stage by stage.
int benchCommand(const Options& options);
/// Prints, warms or clears the cache of compiled kernels.
int cacheCommand(const Options& options);
/// Prints every OpenCL device.
int listDevicesCommand(const Options& options);
/// Prints how far an image is from another.
int compareCommand(const Options& options);

}  // namespace eikonal
