#pragma once
// Displaced meshes: edges are split until they are short, then vertices move along their normals.

#include "scene/shapes.h"

#include <cstddef>
#include <span>

namespace eikonal {

/// The most triangles that a displaced mesh is split into.
constexpr std::size_t mostDisplacedTriangles = std::size_t(1) << 25;

/// The result of splitting; unless it is `done`, the mesh is unusable. tooMany: too many triangles. tooFine: an edge has no floats between
/// its ends.
enum class Split { done, tooMany, tooFine };

/// Splits edges of a triangle mesh in halves, the longest edge of a triangle first, until all are shorter than `edgeLength` (> 0) in the
/// space after worldFromObject. An edge is split the same way for all triangles that share its vertices, so no crack opens. New vertices
/// average the attributes of the edge's ends; a mesh without normals first gets the means of its faces' normals (as in pbrt-v4).
Split splitLongEdges(Mesh& mesh, const Transform& worldFromObject, double edgeLength);

/// Moves each vertex by its height along its normal, both in object space, and sets its normal to the mean of its faces' new normals.
void displaceVertices(Mesh& mesh, std::span<const float> heights);

/// Approximately the shortest edge length that stays within mostDisplacedTriangles, from the mesh's area and edge lengths.
double shortestEdgeLength(const Mesh& mesh, const Transform& worldFromObject);

}  // namespace eikonal
