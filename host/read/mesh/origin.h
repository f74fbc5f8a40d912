#pragma once
// Positions are kept in single precision, relative to an origin: far from the origin of their object they would lose digits.

#include "scene/shapes.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace eikonal {

/// The middle of a box if rounding its corners to floats (by 2^-24 of the distance to the origin) exceeds a millionth of its size, else
/// zero.
glm::dvec3 originOf(const glm::dvec3& low, const glm::dvec3& high);

/// The same for points; zero also if floats hold all of them. Points that are not finite do not count.
glm::dvec3 originOf(std::span<const glm::dvec3> points);

/// The points minus `origin`, rounded to floats.
std::vector<glm::vec3> positionsFrom(const glm::dvec3& origin, std::span<const glm::dvec3> points);

/// Sets the positions and the origin of a mesh.
void setPositions(Mesh& mesh, std::span<const glm::dvec3> points);

}  // namespace eikonal
