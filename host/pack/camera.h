#pragma once
// The camera, the film's pixels and the pixel filter.

#include "pack/context.h"

#include <array>

namespace eikonal {

/// What a camera is packed with.
struct CameraPacking {
    const PackContext& context;
    CameraTables& tables;
    double unit;   ///< of packed lengths, in those of the description (cameraUnit)
};

/// The unit of camera space on the device, in units of the description's camera space: a power of two that makes the transform to scene
/// space keep lengths, nearly. So no length, squared in single precision, overflows or vanishes, whatever the units of the scene.
double cameraUnit(const PackContext&);

/// The pixels to render, by pbrt-v4's rules for --pixelbounds and cropwindow. Throws SceneError if there are none.
PixelRect renderedPixels(const FilmDescription& film, Diagnostics& diagnostics);
/// Fills in the camera of the scene.
void packCamera(const CameraPacking&, camera&);
/// Fills in its pixel filter.
void packFilter(const CameraPacking&, filter&);
/// The transform when the shutter opens, in the middle, and when it closes.
std::array<glm::dmat4, 3> cameraFromScene(const PackContext&);

}  // namespace eikonal
