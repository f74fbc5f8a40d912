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

/// The unit of the object space of a sphere, disk or cylinder on the device: a power of two by which the radius is in [1, 2), so that its
/// square neither overflows nor vanishes.
double unitOfRound(const ShapePacking&);
/// An object space with the radius and phiMax of a sphere, disk or cylinder.
object_space newRound(const ShapePacking&);
/// Adds the only element of a sphere, disk or cylinder, like addInObjectSpace, with the origin of the space around it and its centre.
/// `curved`: the axes of object space along which it curves, from x on: 3 of a sphere, 2 of a cylinder, 0 of a disk, whose heights are then
/// counted from the origin.
size_t addRound(const ShapePacking&, object_space q, int curved);

/// Bounds of the mesh's vertices.
Box meshBounds(const Shape&, const glm::dmat4& m);

}  // namespace eikonal
