#pragma once
// The camera, the film's pixels and the pixel filter.

#include "pack/context.h"

#include <array>

namespace eikonal {

/// The tables of cameras.
struct CameraPacking {
    const PackContext& context;
    CameraTables& tables;
};

/// The pixels to render, by pbrt-v4's rules for --pixelbounds and cropwindow. Throws SceneError if there are none.
PixelRect renderedPixels(const FilmDescription& film, Diagnostics& diagnostics);
/// Fills in the camera of the scene.
void packCamera(const CameraPacking&, camera&);
/// Fills in its pixel filter.
void packFilter(const CameraPacking&, filter&);
/// The transform when the shutter opens, in the middle, and when it closes.
std::array<glm::dmat4, 3> cameraFromScene(const PackContext&);

}  // namespace eikonal
