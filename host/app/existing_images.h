#pragma once
// Images that an earlier call has left.

#include "app/options.h"

namespace eikonal {

/// Whether all image files of the render are there and whole: those of -o, and the PNG beside an EXR. Says which is not, though it is
/// there.
bool hasWholeImages(const Options& options);

}  // namespace eikonal
