#pragma once
// The camera, the film's pixels and the pixel filter.

#include "pack/context.h"

#include <array>

namespace eikonal {

/// What packing of the camera writes, besides the camera itself.
struct CameraPacking {
    const PackContext& context;
    CameraTables& tables;
};

/// What is to be rendered of the image, by pbrt-v4's rules: --pixelbounds and cropwindow select pixels. Throws SceneError for nothing.
PixelRect renderedPixels(const FilmDescription& film, Diagnostics& diagnostics);
/// Fills in the camera of the scene.
void packCamera(const CameraPacking&, camera&);
/// And its pixel filter.
void packFilter(const CameraPacking&, filter&);
/// When the shutter opens, between, and when it closes.
std::array<glm::dmat4, 3> cameraFromScene(const PackContext&);

}  // namespace eikonal
