#pragma once
// Meshes from PLY files.

#include "scene/scene.h"

#include <cstddef>
#include <memory>
#include <string>

namespace eikonal {

/// What a PLY file holds. A mesh is null when there are no such faces; when there are both, each has all of the file's vertices.
struct PlyMesh {
    std::shared_ptr<Mesh> triangles;  ///< faces with three corners, and fans of those with five and more
    std::shared_ptr<Mesh> quads;      ///< faces with four corners, as bilinear patches: the file's corners 0 1 3 2
    std::size_t droppedFaces = 0;     ///< faces with fewer than three corners, which are left out
};

/// All faces as triangles, patches cut in two from corner 0 to corner 3 (of a bilinear patch: to (1, 1)), as pbrt-v4 does for displacement. Null if there are none.
std::shared_ptr<const Mesh> trianglesOf(const PlyMesh& ply);

/// Reads a PLY file of format ascii, binary_little_endian or binary_big_endian, gzip-compressed or not.
/// Of element "vertex": x y z, and where present nx ny nz and one of (u v) (s t) (texture_u texture_v) (texture_s texture_t).
/// Of element "face": the list vertex_indices (or vertex_index). Anything else is skipped. Vertices keep their order and numbers.
/// Throws SceneError at `where`, naming the file: not readable, not PLY, truncated, an index out of range, a position that is not finite.
PlyMesh loadPly(const std::string& path, const SourceLocation& where);

}  // namespace eikonal
