// Absorption of hair from its colour and azimuthal roughness. Only the material "hair" makes such textures.

#include "eikonal/formulas.h"
#include "kinds/texture_kind.h"

namespace eikonal {

static ColorSet colors(const Texture&, std::span<const ColorSet> operands) {
    const double scale = hair_absorption_scale(meanOf(operands[1]).rgb.x);
    return map(operands[0], [=](const DualColor& hair) { return hair.map(squared_log) * scale; });
}

const TextureTraits absorption_texture{.types = TextureTypes::none, .colors = colors};

}  // namespace eikonal
