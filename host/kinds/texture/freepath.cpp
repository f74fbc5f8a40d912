// Transport mean free path, 1 / (sigma_a + (1 - g) sigma_s). Only the material "subsurface" makes such textures.

#include "kinds/texture_packing.h"

namespace eikonal {

static void pack(TexturePacking&, const Texture& t, texture_instruction& i) {
    i.value = packNumber(t.g);
}

const TextureTraits freepath_texture{.types = TextureTypes::none, .pack = pack, .takesCoefficients = true};

}  // namespace eikonal
