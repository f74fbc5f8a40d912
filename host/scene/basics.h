#pragma once
// Types that all parts of a scene description share: indices and transforms.

#include <glm/glm.hpp>

namespace eikonal {

constexpr int none = -1;

/// Maps points of a local space to world space. In double precision; packing translates and scales the scene (docs/tour.md).
using Transform = glm::dmat4;

}  // namespace eikonal
