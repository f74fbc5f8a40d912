// Implicit surface F(x, y, z) = 0 within a box, which may emit (kernels/shape/implicit.clh, kernels/light/implicit.clh).

#include "kinds/shape_packing.h"
#include "kinds/shape_reading.h"
#include "pack/implicit.h"
#include "pack/implicit_extent.h"
#include "read/pbrt/implicit.h"

namespace eikonal {

static bool read(const pbrt::ShapeReading& in, pbrt::PendingShape& pending) {
    pending.shape.implicit = std::make_shared<const ImplicitSurface>(pbrt::readImplicit(in.reading, in.arguments));
    return true;
}

static Box bound(const Shape& s, const glm::dmat4& m) { return transformed({s.implicit->low, s.implicit->high}, m); }

static size_t pack(const ShapePacking& in) {
    const ImplicitSurface& surface = *in.description.implicit;
    in.packed.first_index = static_cast<uint>(in.tables.implicits.size());
    const std::vector<implicit_instruction> program = implicitProgram(*surface.F, in.description.where);
    Table<implicit_instruction>& instructions = in.tables.implicit_instructions;
    in.tables.implicits.push_back(
        {toVec3(surface.low), toVec3(surface.high), static_cast<uint>(instructions.size()), static_cast<uint>(program.size())});
    instructions.insert(instructions.end(), program.begin(), program.end());
    ++in.counts.implicits;
    /* The inside is where F < 0, also if the transform mirrors */
    return addInObjectSpace(in, object_space{}, false);
}

static light_kind lightKindOf(const Shape&, const glm::dmat4&) { return kind_implicit_light; }

static light packLight(const AreaElement& e, const color& L) {
    const implicit& surface = e.tables.implicits[e.packed.first_index];
    const auto program = std::span(e.tables.implicit_instructions).subspan(surface.first_instruction, surface.instruction_count);
    const ImplicitExtent extent = extentOf(program, {toGlm(surface.low), toGlm(surface.high)}, e.sceneFromObject);
    light l = newLight(kind_implicit_light, L);
    l.p = toVec3(extent.center);
    /* With a margin for what the device rounds */
    l.radius = static_cast<float>(1.00001 * extent.radius + 1e-6 * glm::length(extent.center));
    l.inverse_area = static_cast<float>(1 / extent.area);
    /* Without a surface it is no light */
    if (!(extent.radius > 0)) l.pmf = l.inverse_area = 0;
    return l;
}

const LightTraits implicit_light{.packElement = packLight, .bound = boundSphere, .isAimedByDirection = true,
                                .startsPaths = false};

static const ShapeDirective directives[] = {
    {"implicit", "string F; point3s bounds; float a; float b; float c; float d", read},
};

const ShapeTraits implicit_shape{.directives = directives,
                                 .bound = bound,
                                 .pack = pack,
                                 .lightKindOf = lightKindOf};

}  // namespace eikonal
