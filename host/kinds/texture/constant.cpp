// The same value everywhere.

#include "kinds/texture_reading.h"

namespace eikonal {

static bool read(const pbrt::TextureReading& in, Texture& texture) {
    texture.operands = {{in.arguments.spectrum("value"), none, in.arguments.whereOf("value")}};
    return true;
}

const TextureTraits constant_texture{.parameters = {"value value = 1"}, .read = read, .isItsOperand = true};

}  // namespace eikonal
