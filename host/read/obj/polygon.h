#pragma once
// Polygons in space, cut into triangles.

#include <glm/glm.hpp>

#include <array>
#include <span>
#include <vector>

namespace eikonal {

/// The normal of a polygon, of length twice its area: its corners run counter-clockwise around it (Newell's method).
glm::dvec3 polygonNormal(std::span<const glm::dvec3> corners);

/// Adds triangles of corner numbers that cover a simple polygon, convex or not, with its orientation: corners - 2 of them.
/// Quads are cut along the shorter diagonal that lies inside. A polygon that crosses itself or has no area still gives corners - 2 triangles.
void triangulate(std::span<const glm::dvec3> corners, std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace eikonal
