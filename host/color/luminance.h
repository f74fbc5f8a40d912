#pragma once
// How bright a colour is.

#include <glm/glm.hpp>

namespace eikonal {

/// The luminance of linear sRGB, white's being 1 (IEC 61966-2-1).
inline double luminance(const glm::dvec3& color) { return glm::dot(color, glm::dvec3(0.2126, 0.7152, 0.0722)); }

}  // namespace eikonal
