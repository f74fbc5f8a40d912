// A blend of two textures by a third.

#include "kinds/texture_reading.h"

#include <algorithm>

namespace eikonal {

static bool read(const pbrt::TextureReading& in, Texture& texture) {
    readOperands(in, {"tex1", "tex2", "amount"}, texture);
    return true;
}

static ColorSet colors(const Texture&, std::span<const ColorSet> operands) {
    const double amount = std::clamp(meanOf(operands[2]).rgb.x, 0.0, 1.0);
    return unite(operands[0], 1 - amount, operands[1], amount);
}

const TextureTraits mix_texture{
    .parameters = {"map tex1 = 0; map tex2 = 1; floatmap amount = 0.5"}, .read = read, .colors = colors};

}  // namespace eikonal
