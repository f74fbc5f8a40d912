// The product of two textures.

#include "kinds/texture_reading.h"

namespace eikonal {

static bool read(const pbrt::TextureReading& in, Texture& texture) {
    readOperands(in, {"tex", "scale"}, texture);
    return true;
}

static ColorSet colors(const Texture&, std::span<const ColorSet> operands) {
    return combine(operands[0], operands[1], std::multiplies<DualColor>());
}

const TextureTraits scale_texture{.parameters = {"map tex = 1; floatmap scale = 1"}, .read = read, .colors = colors};

}  // namespace eikonal
