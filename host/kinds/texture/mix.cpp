// A blend of two textures by a third.

#include "kinds/texture_reading.h"

namespace eikonal {

static bool read(const pbrt::TextureReading& in, Texture& texture) {
    readOperands(in, {"tex1", "tex2", "amount"}, texture);
    return true;
}

const TextureTraits mix_texture{.parameters = {"map tex1 = 0; map tex2 = 1; floatmap amount = 0.5"}, .read = read};

}  // namespace eikonal
