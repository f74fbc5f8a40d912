#include "pack/geometry.h"

#include "kinds/integrator_kind.h"
#include "kinds/shape_packing.h"

namespace eikonal {

void packShape(const GeometryPacking& in, Group& group, const Shape& s, const ShapePlace& place, bool inObject, uint id) {
    const PackContext& context = in.context;
    GeometryTables& tables = in.tables;
    const uint materialIndex = in.materials.material(s.material);
    const bool isInterface = in.materials.tables().materials[materialIndex].next_queue == next_crossing;
    const bool emits = s.areaLight != none && !inObject && context.scene.integrator.kind->countsMaterials();
    if (s.areaLight != none && inObject)
        context.diagnostics.unsupported("area light in object", s.where, "area lights in instanced objects do not emit (as in pbrt-v4)");
    if (isInterface && !emits && !context.hasMedia) return;

    shape packed{};
    packed.kind = s.kind->value;
    packed.material = materialIndex;
    packed.id = id;
    packed.first_element = static_cast<uint>(tables.element_shapes.size());
    packed.first_normal = packed.first_tangent = packed.first_uv = packed.object_space = NONE;
    packed.first_light = packed.alpha = packed.emission = NONE;
    packed.inside = packed.outside = NONE;
    if (isInterface) packed.flags |= shape_is_interface;
    if (in.materials.isEntered(materialIndex)) packed.flags |= shape_is_entered;
    if (context.hasMedia && s.interface) {
        packed.flags |= shape_has_interface;
        packed.inside = s.interface->inside == none ? NONE : static_cast<uint>(s.interface->inside);
        packed.outside = s.interface->outside == none ? NONE : static_cast<uint>(s.interface->outside);
    }
    if (s.alpha.texture != none || s.alpha.value.value() < 1) {
        context.require(Feature::ALPHA, s.where.toString());
        packed.alpha = in.textures.alpha(s.alpha, glm::inverse(place.worldFromDefinition) * group.space.worldFromScene());
    }
    const glm::dmat4 groupFromObject = group.space.sceneFromWorld() * (place.worldFromDefinition * place.definitionFromObject);
    const bool instanceSwaps = swapsHandedness(place.worldFromDefinition);
    const size_t elements = s.kind->traits.pack({context, tables, in.counts, group, s, packed, groupFromObject, instanceSwaps});
    if (elements == 0) return;
    context.require(s.kind->feature, s.where.toString());
    tables.element_shapes.insert(tables.element_shapes.end(), elements, static_cast<uint>(tables.shapes.size()));
    if (emits) in.lights.addShape(s, packed, tables, groupFromObject, elements);
    tables.shapes.push_back(packed);
}

}  // namespace eikonal
