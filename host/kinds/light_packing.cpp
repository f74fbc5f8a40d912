#include "kinds/light_packing.h"

#include "color/luminance.h"
#include "image/equal_area.h"
#include "pack/motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eikonal {

light newLight(light_kind kind, const color& L) {
    light l{};
    l.kind = kind;
    l.L = L;
    l.pmf = 1;
    l.extent = 1;
    l.element = l.leaf = l.medium = NONE;
    l.resolution = l.rows = 1;
    return l;
}

light newPointLight(const LightPacking& in, const Light& d, light_kind kind) {
    light l = newLight(kind, in.colors.white());
    l.p = toVec3(transformPoint(in.context.space.sceneFromWorld() * d.worldFromLight, glm::dvec3(0)));
    return l;
}

double intensityScale(const PackContext& context) { return context.space.scale * context.space.scale; }

double sceneRadius(const PackContext& context) {
    return context.bounds.empty() ? 1 : std::max(context.bounds.radius() * context.space.scale, 1e-6);
}

glm::dmat3 rotationOf(const PackContext& context, const Light& d) {
    const Transform& m = d.worldFromLight;
    /* Matrices in files have few digits */
    if (uniformScale(m, 1e-3) == 0)
        context.diagnostics.warn(d.where, "the transform of this light scales unequally or shears; its image is only turned and mirrored");
    const glm::dmat3 rotation = decompose(m).rotation;
    return swapsHandedness(m) ? -rotation : rotation;
}

double greyOf(glm::dvec3 rgb) { return (rgb.x + rgb.y + rgb.z) / 3; }

const ImageData& sphereImage(const PackContext& context, const Light& d) {
    const ImageData& image = context.imageData(d.image);
    if (image.width != image.height)
        throw SceneError(
            d.where,
            "the image of this light is " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                "; it must be square, in the equal-area mapping. pbrt-v4's `imgtool makeequiarea` converts latitude-longitude images.");
    return image;
}

glm::dvec3 texelOf(const ImageData& image, int x, int y) {
    const auto channel = [&](int c) { return std::max<double>(image.at(x, y, image.channels == 1 ? 0 : c), 0); };
    return {channel(0), channel(1), channel(2)};
}

uint packTexels(const LightPacking& in, const std::vector<glm::vec3>& texels) {
    Table<float>& table = in.tables.environment_texels;
    const uint first = static_cast<uint>(table.size() / (in.context.spectral ? TEXEL_WORDS_SPECTRAL : TEXEL_WORDS_RGB));
    in.colors.appendTexels(table, texels);
    return first;
}

double upwardIlluminance(const ImageData& image) {
    const int n = image.width;
    double sum = 0;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const double z = directionFromSquare({(x + 0.5) / n, (y + 0.5) / n}).z;
            if (z > 0) sum += luminance(texelOf(image, x, y)) * z;
        }
    return std::max(sum * 2 * M_PI / (static_cast<double>(n) * n), 1e-30);
}

uint packLightImage(const LightPacking& in, int index, bool inGrey) {
    const auto [found, isNew] = in.images.try_emplace({index, inGrey}, 0);
    if (!isNew) return found->second;
    const ImageData& image = in.context.imageData(index);
    std::vector<glm::vec3> texels;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) texels.emplace_back(inGrey ? glm::dvec3(greyOf(texelOf(image, x, y))) : texelOf(image, x, y));
    return found->second = packTexels(in, texels);
}

int emittingSide(const AreaElement& e, const uint* corners, const std::vector<MeshPoint>& points) {
    const shape& s = e.packed;
    if (s.first_normal == NONE) return s.flags & shape_reversed ? -1 : 1;
    bool up = false, down = false;
    for (const MeshPoint& p : points) {
        glm::dvec3 normal(0);
        for (size_t i = 0; i < p.weights.size(); ++i)
            if (p.weights[i] > 0) normal += p.weights[i] * toGlm(e.tables.normals[s.first_normal + corners[i]]);
        const double side = glm::dot(normal, p.across);
        up = up || side > 0;
        down = down || side < 0;
    }
    return up && down ? 0 : down ? -1 : 1;
}

double shareOfCircle(double phiMax) { return std::clamp(phiMax, 0.0, 360.0) / 360; }

vec3 sideOf(const AreaElement& e) {
    return {((e.packed.flags & shape_reversed) != 0) != swapsHandedness(e.sceneFromObject) ? -1.0f : 1.0f, 0, 0};
}

void boundAllDirections(LightBounds& bounds) {
    bounds.axis = {0, 0, 1};
    bounds.normals = std::numbers::pi;
}

void boundSphere(const light& l, double, LightBounds& bounds) {
    const glm::dvec3 p = toGlm(l.p);
    bounds.box = {p - static_cast<double>(l.radius), p + static_cast<double>(l.radius)};
    boundAllDirections(bounds);
    bounds.intensity /= 4;
}

void boundPoint(const light&, double power, LightBounds& bounds) {
    boundAllDirections(bounds);
    bounds.intensity = power / (4 * std::numbers::pi);
}

}  // namespace eikonal
