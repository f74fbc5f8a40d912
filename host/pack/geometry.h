#pragma once
// Packs shapes, objects and instances, and lists the elements of each hierarchy over them.

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

/// Where a shape is: where it was defined, and where the instance is that became part of the world.
struct ShapePlace { glm::dmat4 definitionFromObject, worldFromDefinition{1}; };

/// Packs all shapes with their materials and area lights. Returns the elements of the hierarchies.
Hierarchies packGeometry(const GeometryPacking&);

/// Adds a shape to a group and to the tables, unless it has no elements or is an interface in a scene without media.
/// `inObject`: it belongs to an object, where area lights do not emit. `id`: its object id in the auxiliary channel.
void packShape(const GeometryPacking&, Group&, const Shape&, const ShapePlace&, bool inObject, uint id);

}  // namespace eikonal
