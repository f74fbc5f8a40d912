// Disks of one texture on another.

#include "kinds/texture_packing.h"
#include "kinds/texture_reading.h"

namespace eikonal {

static bool read(const pbrt::TextureReading& in, Texture& texture) {
    // pbrt-v4 passes these two in the wrong order: it paints the dots with "outside" and the gaps with "inside"
    readOperands(in, {"outside", "inside"}, texture);
    readMapping(in, texture);
    return true;
}

static void pack(TexturePacking& into, const Texture& t, texture_instruction& i) { packMapping(into, t.mapping, i); }

const TextureTraits dots_texture{.parameters = {"map inside = 1; map outside = 0", pbrt::mappingParameters}, .read = read, .pack = pack};

}  // namespace eikonal
