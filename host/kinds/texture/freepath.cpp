// Mean free path of reduced scattering from coefficients: 1 / (sigma_a + (1 - g) sigma_s). Made for the material "subsurface".

#include "kinds/texture_packing.h"

namespace eikonal {

static void pack(TexturePacking&, const Texture& t, texture_instruction& i) {
    i.value = packNumber(t.g);
}

const TextureTraits freepath_texture{.types = TextureTypes::none, .pack = pack, .takesCoefficients = true};

}  // namespace eikonal
