#pragma once
// Meshes of the groups of an OBJ file.

#include "read/obj/geometry.h"
#include "scene/scene.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace eikonal {

struct ObjMesh {
    std::shared_ptr<Mesh> mesh;   ///< null if nothing is left of the group
    double area = 0;              ///< of its triangles
    double uvArea = 0;            ///< of its triangles on the texture
    bool isClosed = false;        ///< every edge belongs to two triangles that run along it in opposite directions
};

struct ObjMeshes {
    std::vector<ObjMesh> groups;          ///< one for each of ObjGeometry::groups
    glm::dvec3 offset{0};                 ///< to be added to all positions. Not zero for models far from the origin, whose details floats would lose
    std::size_t triangles = 0;
    std::size_t degenerate = 0;           ///< triangles without area, or with a position that is not finite: left out
};

/// Cuts the faces into triangles and gives corners with the same position, texture coordinate and normal one vertex.
ObjMeshes buildMeshes(const ObjGeometry& geometry);

}  // namespace eikonal
