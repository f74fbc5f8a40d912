#pragma once
// Shapes, objects and instances as the device sees them, and what each hierarchy over them is to hold.

#include "pack/hierarchies.h"
#include "pack/lights.h"
#include "pack/materials.h"

namespace eikonal {

/// What packing of geometry writes, and what shapes refer to.
struct GeometryPacking {
    const PackContext& context;
    GeometryTables& tables;
    SceneCounts& counts;
    TexturePacker& textures;
    MaterialPacker& materials;
    LightPacker& lights;
};

/// All shapes with their materials and area lights. Returns what the hierarchies over them are to be built of.
Hierarchies packGeometry(const GeometryPacking&);

/// Adds a shape to a group, and to the tables: unless it has no elements, or is an interface in a scene without media.
/// `inObject`: of an object, where area lights do not emit. `instanceSwaps`: worldFromObject
/// has an instance's transform in it, which swaps handedness. `id`: what the channel of objects shows.
void packShape(const GeometryPacking&, Group&, const Shape&, const glm::dmat4& worldFromObject, bool inObject, bool instanceSwaps, uint id);

}  // namespace eikonal
