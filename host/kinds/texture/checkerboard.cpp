// Checkerboard of two textures, in two or three dimensions.

#include "kinds/texture_packing.h"
#include "kinds/texture_reading.h"

namespace eikonal {

static bool read(const pbrt::TextureReading& in, Texture& texture) {
    texture.dimensions = in.arguments.integer("dimension");
    if (texture.dimensions != 2 && texture.dimensions != 3)
        throw SceneError(in.arguments.whereOf("dimension"),
                         "\"integer dimension\" is " + std::to_string(texture.dimensions) + "; it can be 2 or 3");
    readOperands(in, {"tex1", "tex2"}, texture);
    if (texture.dimensions == 2) readMapping(in, texture);
    return true;
}

static void pack(TexturePacking& into, const Texture& t, texture_instruction& i) {
    if (t.dimensions == 2) return packMapping(into, t.mapping, i);
    i.mapping = mapping_point;
    i.texture_from_scene = textureFromScene(into, t.mapping);
}

const TextureTraits checkerboard_texture{
    .parameters = {"map tex1 = 1; map tex2 = 0; integer dimension = 2", pbrt::mappingParameters},
    .read = read,
    .pack = pack};

}  // namespace eikonal
