#pragma once
// Lens files: text, "#" starts a comment; four numbers for each element, from the scene to the film.

#include "scene/scene.h"

#include <string>
#include <vector>

namespace eikonal::pbrt {

/// The elements of a lens file. Throws SceneError: its numbers are not four for each element, it has none, or an element is impossible.
std::vector<LensElement> readLensFile(const std::string& path);

}  // namespace eikonal::pbrt
