#pragma once
// The geometry of a Wavefront OBJ file.

#include "diagnostics.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace eikonal {

/// Indices from 0; none (-1) if not given.
struct ObjCorner { int position = -1, uv = -1, normal = -1; };

struct ObjFace {
    std::uint32_t firstCorner = 0, cornerCount = 0;  ///< in ObjGeometry::corners
    std::uint32_t group = 0;                         ///< in ObjGeometry::groups
    std::uint32_t smoothing = 0;                     ///< smoothing group; 0: flat
    int line = 0;
};

/// The faces of an object that share a material. Objects are named by "o", or by "g" in a file without any "o".
struct ObjGroup { std::string object, material; SourceLocation where; };

/// A file name after mtllib, or several.
struct ObjLibrary { std::string name; SourceLocation where; };

struct ObjGeometry {
    std::vector<glm::dvec3> positions, normals;
    std::vector<glm::dvec2> uvs;
    std::vector<ObjCorner> corners;
    std::vector<ObjFace> faces;
    std::vector<ObjGroup> groups;
    std::vector<ObjLibrary> libraries;

    const ObjCorner* cornersOf(const ObjFace& face) const { return &corners[face.firstCorner]; }
};

/// Parses v vt vn f o g s usemtl mtllib. Positions are in double precision, and all indices are checked. Lines, points, free-form surfaces
/// and vertex colours are reported as unsupported. Throws SceneError with the line and column of the error.
ObjGeometry parseObj(std::string_view text, const std::shared_ptr<const std::string>& file, Diagnostics& diagnostics);

/// Gives a normal to each corner without one. In smoothing groups it is the mean of the faces around the position, weighted by their angles
/// there; elsewhere it is the face's normal, but only in groups where other corners have normals. Groups without any normal are unchanged:
/// their faces are flat.
void completeNormals(ObjGeometry& geometry);

}  // namespace eikonal
