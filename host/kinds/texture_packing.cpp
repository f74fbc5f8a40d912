#include "kinds/texture_packing.h"

namespace eikonal {

static float f(double x) { return static_cast<float>(x); }
/// Texture space from the space of points.
static glm::dmat4 matrixOf(const TexturePacking& into, const Mapping& m) { return glm::inverse(m.worldFromTexture) * into.worldFromPoint; }

static glm::dmat4 scaledMatrixOf(const TexturePacking& into, const Mapping& m, double scale) {
    return glm::dmat4(glm::dmat3(scale)) * matrixOf(into, m);
}

affine textureFromScene(const TexturePacking& into, const Mapping& m, double scale) { return toAffine(scaledMatrixOf(into, m, scale)); }

void packMapping(const TexturePacking& into, const Mapping& m, texture_instruction& i) {
    i.mapping = m.kind;
    switch (m.kind) {
        case mapping_uv:
            i.texture_from_scene.xx = f(m.uScale); i.texture_from_scene.xw = f(m.uOffset);
            i.texture_from_scene.yy = f(m.vScale); i.texture_from_scene.yw = f(m.vOffset);
            return;
        case mapping_spherical:
        case mapping_cylindrical:
        case mapping_point:
            i.texture_from_scene = textureFromScene(into, m);
            return;
        case mapping_planar: {
            glm::dmat4 plane(1);
            for (int axis = 0; axis < 3; ++axis) { plane[axis][0] = m.planeU[axis]; plane[axis][1] = m.planeV[axis]; }
            plane[3][0] = m.uOffset;
            plane[3][1] = m.vOffset;
            i.texture_from_scene = toAffine(plane * matrixOf(into, m));
            return;
        }
    }
}

void packOctaves(TexturePacking& into, const Texture& t, texture_instruction& i) {
    i.octaves = static_cast<uint>(t.octaves);
    i.roughness = f(t.roughness);
    i.variation = f(t.variation);
    const glm::dmat4 matrix = scaledMatrixOf(into, t.mapping, t.scale);
    i.texture_from_scene = toAffine(matrix);
    const glm::dmat3 turn(matrix);
    const double frequency = std::max({glm::length(turn[0]), glm::length(turn[1]), glm::length(turn[2])}), lacunarity = 1.99;
    if (frequency > 0) into.addDetail({.distance = 1 / (frequency * std::pow(lacunarity, std::max(t.octaves - 1, 0)))});
}

}  // namespace eikonal
