#pragma once
// Reads lens files: text with comments after "#", and four numbers per element, from the scene to the film.

#include "error.h"
#include "scene/camera.h"

#include <string>
#include <vector>

namespace eikonal::pbrt {

/// The elements of a lens file. Throws SceneError if it has none, if an element is incomplete, or if its numbers are invalid.
std::vector<LensElement> readLensFile(const std::string& path);

}  // namespace eikonal::pbrt
