#pragma once
// Surfaces by subdivision of triangles (Loop 1987, "Smooth Subdivision Surfaces Based on Triangles"), as pbrt-v4 has them.

#include "scene/scene.h"

namespace eikonal {

/// What became of a mesh.
struct SubdividedMesh {
    Mesh mesh;                 ///< vertices on the limit surface, with its normals, which look as in pbrt-v4: against the right hand's rule
    size_t droppedFaces = 0;   ///< that name a vertex twice
};

/// The most triangles that subdivideByLoop makes.
constexpr size_t mostSubdividedTriangles = size_t(1) << 25;

/// The triangles of `mesh`, each split in four `levels` times (Loop's rules; Hoppe et al. 1994 for boundaries), moved to the limit
/// surface. Normals, texture coordinates and vertices without a face are not kept. Takes time and memory in proportion to
/// the triangles made. An edge of more than two faces is a boundary to all but the first two; where faces that meet do not agree
/// on their orientation, only normals suffer. levels >= 0, and faces * 4^levels <= mostSubdividedTriangles.
SubdividedMesh subdivideByLoop(const Mesh& mesh, int levels);

}  // namespace eikonal
