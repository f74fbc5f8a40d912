// A blend of two textures by the angle between the geometric normal and a direction: only the first where they are parallel.

#include "kinds/texture_packing.h"
#include "kinds/texture_reading.h"

namespace eikonal {

static bool read(const pbrt::TextureReading& in, Texture& texture) {
    const glm::dvec3 direction = glm::dmat3(texture.mapping.worldFromTexture) * in.arguments.vector("dir", {0, 1, 0});
    if (!(glm::length(direction) > 0)) throw SceneError(in.arguments.whereOf("dir"), "\"vector3 dir\" has no length");
    texture.direction = glm::normalize(direction);
    readOperands(in, {"tex1", "tex2"}, texture);
    return true;
}

static void pack(TexturePacking& into, const Texture& t, texture_instruction& i) {
    i.texture_from_scene = toAffine(glm::inverse(into.worldFromPoint));   // turns normals the other way, into world space
    i.direction = toVec3(t.direction);
}

const TextureTraits directionmix_texture{.parameters = {"map tex1 = 0; map tex2 = 1; vector3 dir"}, .read = read, .pack = pack};

}  // namespace eikonal
