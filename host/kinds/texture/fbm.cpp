// Fractional Brownian motion: octaves of noise.

#include "kinds/texture_packing.h"
#include "kinds/texture_reading.h"

namespace eikonal {

static bool read(const pbrt::TextureReading& in, Texture& texture) {
    readOctaves(in, texture);
    return true;
}

static void pack(TexturePacking& into, const Texture& t, texture_instruction& i) {
    packOctaves(into, t, i);
    into.leavesUnit = true;
}

const TextureTraits fbm_texture{.types = TextureTypes::floatOnly, .parameters = {pbrt::octaveParameters}, .read = read, .pack = pack};

}  // namespace eikonal
