#pragma once
// What kinds of shapes share when they are packed.

#include "kinds/light_packing.h"
#include "kinds/shape_kind.h"
#include "pack/group.h"
#include "pack/packer.h"

namespace eikonal {

/// A shape that is being packed.
struct ShapePacking {
    Packer& packer;
    SceneTables& tables;
    Group& group;                  ///< the hierarchy that gets its elements
    const Shape& description;
    shape& packed;                 ///< what all kinds have is filled in; the kind adds its own
    const glm::dmat4& m;           ///< object space to the space of the group
    bool instanceSwaps;            ///< whether the transform of an instance in m swaps handedness
};

/// The vertices and indices of its mesh.
void addVertices(const ShapePacking&);

/// Its only element, and q with the maps of its object space. `flips`: whether m flips the normal. Returns 1.
size_t addQuadric(const ShapePacking&, quadric q, bool flips);
/// Whether m flips normals that are made in object space and transformed: only the shape's own transform can, as pbrt-v4's mirrored quadrics do.
inline bool isMirrored(const ShapePacking& in) { return swapsHandedness(in.m) != in.instanceSwaps; }

/// What spheres, disks and cylinders have in common: their radius and their angle.
quadric newRound(const ShapePacking&);

/// Bounds of the vertices of its mesh.
Box meshBounds(const Shape&, const glm::dmat4& m);

}  // namespace eikonal
