// Diffuse albedo of a semi-infinite body from its coefficients per world unit. Only the material "subsurface" makes such textures. The
// image is a row of albedos for the body's g and eta (color/diffuse_albedo.h).

#include "kinds/texture_packing.h"

namespace eikonal {

static void pack(TexturePacking& into, const Texture& t, texture_instruction& i) {
    i.image = into.textures.image(t.image, false);
    i.value = packNumber(t.g);
}

const TextureTraits diffusealbedo_texture{.types = TextureTypes::none, .pack = pack, .takesCoefficients = true};

}  // namespace eikonal
