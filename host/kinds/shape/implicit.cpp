// Implicit surface F(x, y, z) = 0 within a box (kernels/shape/implicit.clh).

#include "kinds/shape_packing.h"
#include "kinds/shape_reading.h"
#include "pack/implicit.h"
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

static const ShapeDirective directives[] = {
    {"implicit", "string F; point3s bounds; float a; float b; float c; float d", read},
};

const ShapeTraits implicit_shape{.directives = directives,
                                 .bound = bound,
                                 .pack = pack,
                                 .cannotEmit = "an implicit surface cannot emit, since its points cannot be sampled"};

}  // namespace eikonal
