#pragma once
// Subdivision surfaces of triangles (Loop 1987, "Smooth Subdivision Surfaces Based on Triangles"), as in pbrt-v4.

#include "scene/shapes.h"

namespace eikonal {

/// The result of a subdivision.
struct SubdividedMesh {
    Mesh mesh;                 ///< on the limit surface; its normals point opposite to the right-hand rule, as in pbrt-v4
    size_t droppedFaces = 0;   ///< faces that name a vertex twice
};

/// The most triangles that subdivideByLoop makes.
constexpr size_t mostSubdividedTriangles = size_t(1) << 25;

/// Splits each triangle of `mesh` in four `levels` times (Loop's rules; Hoppe et al. 1994 for boundaries), and moves the vertices to the
/// limit surface. Drops normals, texture coordinates and unused vertices. Time and memory are proportional to the triangles made. An edge
/// of more than two faces is a boundary for all but the first two; if neighbouring faces have inconsistent orientation, only normals
/// suffer. levels >= 0, and faces * 4^levels <= mostSubdividedTriangles.
SubdividedMesh subdivideByLoop(const Mesh& mesh, int levels);

}  // namespace eikonal
