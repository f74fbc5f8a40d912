#pragma once
// Builds meshes from the groups of an OBJ file.

#include "read/obj/geometry.h"
#include "scene/shapes.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace eikonal {

struct ObjMesh {
    std::shared_ptr<Mesh> mesh;   ///< null if no triangle is left
    double area = 0;              ///< of its triangles
    double uvArea = 0;            ///< area of its triangles in texture space
    bool isClosed = false;        ///< every edge belongs to two triangles that traverse it in opposite directions
};

struct ObjMeshes {
    std::vector<ObjMesh> groups;          ///< one for each ObjGeometry::groups
    glm::dvec3 offset{0};  ///< to be added to all positions. Not zero for models far from the origin, whose details floats would lose
    std::size_t triangles = 0;
    std::size_t degenerate = 0;           ///< triangles skipped because they have no area or a position that is not finite
    int firstDegenerateLine = 0;          ///< of the file, of the face of the first of them; 0: none
};

/// Triangulates the faces, and merges corners with the same position, texture coordinate and normal into one vertex.
ObjMeshes buildMeshes(const ObjGeometry& geometry);

}  // namespace eikonal
