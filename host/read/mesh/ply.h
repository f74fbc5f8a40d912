#pragma once
// Reads meshes from PLY files.

#include "error.h"
#include "scene/shapes.h"

#include <cstddef>
#include <memory>
#include <string>

namespace eikonal {

/// The contents of a PLY file. A mesh is null if the file has no such faces; if it has both kinds, each mesh has all vertices of the file.
struct PlyMesh {
    std::shared_ptr<Mesh> triangles;  ///< faces with three corners, and those that polygons with five or more are cut into
    std::shared_ptr<Mesh> quads;      ///< faces with four corners, as bilinear patches: the file's corners 0 1 3 2
    std::size_t droppedFaces = 0;     ///< skipped faces, with fewer than three corners
    int skippedHeaderLine = 0;        ///< ply::Header::skippedLine
    std::size_t firstUnreadLine = 0;  ///< of a text file: the line of what follows its last element; 0 if that is blank
    std::size_t unreadBytes = 0;      ///< of a binary file: bytes after its last element; 0 if they are blank
};

/// All faces as triangles, as pbrt-v4 does for displacement: patches are split from corner 0 to corner 3 (of a bilinear patch: to (1, 1)).
/// Null if there are none.
std::shared_ptr<const Mesh> trianglesOf(const PlyMesh& ply);

/// Reads a PLY file in format ascii, binary_little_endian or binary_big_endian, gzip-compressed or not. Of element "vertex": x y z, and if
/// present nx ny nz and one of (u v) (s t) (texture_u texture_v) (texture_s texture_t). Of element "face": the list vertex_indices (or
/// vertex_index). Skips everything else. Vertices keep their order and numbers. Throws SceneError at `where` with the file's name: not
/// readable, not PLY, truncated, an index out of range, a position that is not finite.
PlyMesh loadPly(const std::string& path, const SourceLocation& where);

}  // namespace eikonal
