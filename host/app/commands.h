#pragma once
// The commands of the program. Each returns the exit status, or throws an Error that carries it.

#include "app/options.h"

namespace eikonal {

/// Renders scenes into image files. Returns 0 if all files are written and every sample was taken, ExitCode::partialImage if the time
/// limit was reached before, and signalStatus plus the signal's number if a signal ended the render early. Of several scenes each is
/// rendered even if others fail, which is told; the worst status counts.
int renderCommand(const Options& options);
/// Prints the contents of a scene, the features that it requires with the reasons, and the memory that a render would take.
int infoCommand(const Options& options);
/// Measures a scene, stage by stage.
int benchCommand(const Options& options);
/// Measures the error and the time of a scene under many settings, and writes a page that compares them.
int tradeCommand(const Options& options);
/// Prints, warms or clears the cache of compiled kernels.
int cacheCommand(const Options& options);
/// Prints the OpenCL devices.
int listDevicesCommand(const Options& options);
/// Makes one image, or one larger part, of parts that were rendered apart. Returns ExitCode::partialImage if the image lacks samples.
int mergeCommand(const Options& options);
/// Writes the job that makes an image in parts on a render farm, and hands it over: becomes the engine's program, whose exit status counts.
/// Returns 0 if it only writes.
int submitCommand(const Options& options);
/// Writes an image without its noise. Returns 0.
int denoiseCommand(const Options& options);
/// Prints the difference of two images.
int compareCommand(const Options& options);

}  // namespace eikonal
