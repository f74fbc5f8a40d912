#pragma once
// Luminance of colours.

#include <glm/glm.hpp>

namespace eikonal {

/// The luminance of linear sRGB; 1 for white (IEC 61966-2-1).
inline double luminance(const glm::dvec3& color) { return glm::dot(color, glm::dvec3(0.2126, 0.7152, 0.0722)); }

}  // namespace eikonal
