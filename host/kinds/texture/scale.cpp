// The product of two textures.

#include "kinds/texture_reading.h"

namespace eikonal {

static bool read(const pbrt::TextureReading& in, Texture& texture) {
    readOperands(in, {"tex", "scale"}, texture);
    return true;
}

const TextureTraits scale_texture{.parameters = {"map tex = 1; floatmap scale = 1"}, .read = read};

}  // namespace eikonal
