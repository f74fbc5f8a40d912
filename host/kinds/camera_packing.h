#pragma once
// What kinds of cameras share when they are read and packed.

#include "kinds/camera_kind.h"
#include "pack/packer.h"
#include "read/pbrt/arguments.h"

namespace eikonal {

/// The screen of a perspective or orthographic camera: as wide as the image's shape makes it, the shorter side from -reach to reach.
void packScreen(Packer&, const CameraDescription&, double reach, camera&);

namespace pbrt {

/// What there is to read a camera from.
struct CameraReading { Reading& reading; const Arguments& arguments; };

}  // namespace pbrt
}  // namespace eikonal
