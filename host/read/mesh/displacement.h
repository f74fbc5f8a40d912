#pragma once
// Displaced meshes: cut until no edge is long, and moved along their normals.

#include "scene/shapes.h"

#include <cstddef>
#include <span>

namespace eikonal {

/// Most triangles that a displaced mesh is cut into.
constexpr std::size_t mostDisplacedTriangles = std::size_t(1) << 25;

/// How cutting ended; if not `done`, the mesh is of no use any more. tooMany: triangles. tooFine: no number lies between an edge's ends.
enum class Split { done, tooMany, tooFine };

/// Cuts every edge of a mesh of triangles in halves, the longest of a triangle first, until all are shorter than `edgeLength` in the space that
/// worldFromObject leads to; > 0. An edge is cut alike for all triangles that share its vertices, so no crack opens. New vertices are in the middle
/// of what they had; those of a mesh without normals get them first, as means of their faces' (as in pbrt-v4).
Split splitLongEdges(Mesh& mesh, const Transform& worldFromObject, double edgeLength);

/// Moves every vertex by its height along its normal, both in object space, and gives it the mean of its faces' new normals.
void displaceVertices(Mesh& mesh, std::span<const float> heights);

/// About the shortest edge length that stays within mostDisplacedTriangles, by the area of the mesh and the lengths of its edges.
double shortestEdgeLength(const Mesh& mesh, const Transform& worldFromObject);

}  // namespace eikonal
