// Marble: layers of colour, displaced by noise.

#include "kinds/texture_packing.h"
#include "kinds/texture_reading.h"

namespace eikonal {

static bool read(const pbrt::TextureReading& in, Texture& texture) {
    readOctaves(in, texture);
    texture.scale = in.arguments.number("scale");
    texture.variation = in.arguments.number("variation");
    return true;
}

static void pack(TexturePacking& into, const Texture& t, texture_instruction& i) {
    packOctaves(into, t, i);
    if (into.context.spectral) into.colors.addUplift();
}

const TextureTraits marble_texture{
    .types = TextureTypes::spectrumOnly,
    .parameters = {pbrt::octaveParameters, "float scale = 1; float variation = 0.2"},
    .read = read, .pack = pack};

}  // namespace eikonal
