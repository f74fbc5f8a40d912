// Bilinear interpolation between the corners of the unit square in (u, v), extrapolated outside.

#include "kinds/texture_packing.h"
#include "kinds/texture_reading.h"

namespace eikonal {

static bool read(const pbrt::TextureReading& in, Texture& texture) {
    readOperands(in, {"v00", "v01", "v10", "v11"}, texture);
    readMapping(in, texture);
    return true;
}

static void pack(TexturePacking& into, const Texture& t, texture_instruction& i) {
    packMapping(into, t.mapping, i);
    into.leavesUnit = true;
}

const TextureTraits bilerp_texture{
    .parameters = {"value v00 = 0; value v01 = 1; value v10 = 0; value v11 = 1", pbrt::mappingParameters},
    .read = read,
    .pack = pack};

}  // namespace eikonal
