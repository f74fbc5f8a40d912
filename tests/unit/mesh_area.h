#pragma once
// The area of a mesh, where tests expect that none is lost or covered twice.

#include "scene/shapes.h"

#include <glm/glm.hpp>

namespace eikonal {

/// Corner `index` of the mesh's triangles, as `m` places it.
inline glm::dvec3 placedCorner(const Mesh& mesh, const Transform& m, size_t index) {
    return m * glm::dvec4(mesh.positions[mesh.indices[index]], 1);
}

/// Of the triangles, as `m` places them.
inline double areaOf(const Mesh& mesh, const Transform& m = Transform(1)) {
    double area = 0;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a = placedCorner(mesh, m, i), b = placedCorner(mesh, m, i + 1), c = placedCorner(mesh, m, i + 2);
        area += 0.5 * glm::length(glm::cross(b - a, c - a));
    }
    return area;
}

}  // namespace eikonal
