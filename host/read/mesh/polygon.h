#pragma once
// Triangulates polygons in space.

#include <glm/glm.hpp>

#include <array>
#include <span>
#include <vector>

namespace eikonal {

/// The normal of a polygon with counter-clockwise corners; its length is twice the area (Newell's method).
glm::dvec3 polygonNormal(std::span<const glm::dvec3> corners);

/// Adds the corners - 2 triangles, as corner numbers, of a simple polygon, convex or not, with its orientation. Quads are split along the
/// shorter diagonal that lies inside. A polygon that intersects itself or has no area still gives corners - 2 triangles.
void triangulate(std::span<const glm::dvec3> corners, std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace eikonal
