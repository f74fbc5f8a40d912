#pragma once
// What all parts of a description share: how one names another, and where things are.

#include <glm/glm.hpp>

namespace eikonal {

constexpr int none = -1;

/// Maps points of a local space to world space. Double precision: the scene is moved to a space of its own when it is packed.
using Transform = glm::dmat4;

}  // namespace eikonal
