// Diffuse albedo of a semi-infinite body from its coefficients per world unit. Only the material "subsurface" makes such textures. The
// image is a row of albedos for the body's g and eta (color/diffuse_albedo.h).

#include "color/diffuse_albedo.h"
#include "kinds/texture_packing.h"

#include <algorithm>

namespace eikonal {

static void pack(TexturePacking& into, const Texture& t, texture_instruction& i) {
    i.image = into.textures.image(t.image, false);
    i.value = packNumber(t.g);
}

static ColorSet colors(const Texture& t, std::span<const ColorSet> operands) {
    const auto albedo = [&](double a, double s) { return halfSpaceAlbedo(s / std::max(s + a, 1e-30), t.g); };
    return combine(operands[0], operands[1], [&](const DualColor& a, const DualColor& s) { return DualColor::combine(a, s, albedo); });
}

const TextureTraits diffusealbedo_texture{
    .types = TextureTypes::none, .pack = pack, .takesCoefficients = true, .colors = colors};

}  // namespace eikonal
