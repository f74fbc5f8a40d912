#pragma once
// Shared code for reading and packing cameras.

#include "kinds/camera_kind.h"
#include "pack/camera.h"
#include "read/pbrt/arguments.h"

namespace eikonal {

/// Sets the screen of a perspective or orthographic camera: the shorter side spans [-reach, reach], the aspect ratio gives the other.
void packScreen(const PackContext&, const CameraDescription&, double reach, camera&);

namespace pbrt {

/// The input of a camera's `read`.
struct CameraReading { Reading& reading; const Arguments& arguments; };

}  // namespace pbrt
}  // namespace eikonal
