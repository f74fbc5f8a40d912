// Diffuse albedo of a deep body from its coefficients per world unit, made for the material "subsurface". Its image is a row of
// albedos for its g and eta (color/diffuse_albedo.h).

#include "kinds/texture_packing.h"

namespace eikonal {

static void pack(TexturePacking& into, const Texture& t, texture_instruction& i) {
    i.image = packImage(into.packer, t.image, false);
    i.value = packNumber(t.g);
}

const TextureTraits diffusealbedo_texture{.types = TextureTypes::none, .pack = pack, .takesCoefficients = true};

}  // namespace eikonal
