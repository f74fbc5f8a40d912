// Water waves.

#include "kinds/texture_packing.h"

namespace eikonal {

static void pack(TexturePacking& into, const Texture& t, texture_instruction& i) {
    packOctaves(into, t, i);
    into.leavesUnit = true;
}

const TextureTraits windy_texture{.types = TextureTypes::floatOnly, .pack = pack};

}  // namespace eikonal
