#pragma once
// Shared code for packing shapes.

#include "kinds/light_packing.h"
#include "kinds/shape_kind.h"
#include "pack/context.h"
#include "pack/group.h"

namespace eikonal {

/// The input of a shape's `pack`.
struct ShapePacking {
    const PackContext& context;
    GeometryTables& tables;
    SceneCounts& counts;
    Group& group;                  ///< the hierarchy that gets its elements
    const Shape& description;
    shape& packed;                 ///< fields that all kinds share are already set
    const glm::dmat4& m;           ///< object space to the space of the group
    bool instanceSwaps;            ///< whether the instance transform in m swaps handedness
};

/// Adds the vertices and indices of the shape's mesh to the tables.
void addVertices(const ShapePacking&);

/// Adds the shape's only element, and q with the transforms from and to object space. `flips`: whether m flips the normal. Returns 1.
size_t addInObjectSpace(const ShapePacking&, object_space q, bool flips);
/// Whether m flips normals that are computed in object space. As in pbrt-v4, the shape's own transform does so if it mirrors, an
/// instance's transform does not.
inline bool isMirrored(const ShapePacking& in) { return swapsHandedness(in.m) != in.instanceSwaps; }

/// An object space with the radius and phiMax of a sphere, disk or cylinder.
object_space newRound(const ShapePacking&);

/// Bounds of the mesh's vertices.
Box meshBounds(const Shape&, const glm::dmat4& m);

}  // namespace eikonal
