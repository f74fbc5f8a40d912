#include "pack/image_lights.h"

#include "color/luminance.h"
#include "pack/colors.h"
#include "pack/portal.h"
#include "image/equal_area.h"

#include <algorithm>
#include <cmath>

namespace eikonal {

static double greyOf(glm::dvec3 s) { return (s.x + s.y + s.z) / 3; }

const ImageData& sphereImage(const Packer& packer, const Light& d, int index) {
    const ImageData& image = *packer.images[static_cast<size_t>(index)];
    if (image.width != image.height)
        throw SceneError(d.where, "the image of this light is " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                                      "; it must be square, in the equal-area mapping. pbrt-v4's `imgtool makeequiarea` converts latitude-longitude images.");
    return image;
}

glm::dvec3 texelOf(const ImageData& image, int x, int y) {
    const auto channel = [&](int c) { return std::max<double>(image.at(x, y, image.channels == 1 ? 0 : c), 0); };
    return {channel(0), channel(1), channel(2)};
}

uint nextTexel(const Packer& packer) {
    return static_cast<uint>(packer.packed.tables.environment_texels.size() / (packer.spectral ? TEXEL_WORDS_SPECTRAL : TEXEL_WORDS_RGB));
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

/// Light space to scene space, without what stretches.
static glm::dmat3 rotationOf(const Light& d) {
    const glm::dmat3 m(d.worldFromLight);
    return {glm::normalize(m[0]), glm::normalize(m[1]), glm::normalize(m[2])};
}

/// The first of an image's texels in `environment_texels`. Lights with the same image share them.
static uint packLightImage(Packer& packer, int index, bool inGrey) {
    const auto [found, isNew] = packer.lightTexels.try_emplace({index, inGrey}, nextTexel(packer));
    if (!isNew) return found->second;
    const ImageData& image = *packer.images[static_cast<size_t>(index)];
    std::vector<glm::vec3> texels;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) texels.emplace_back(inGrey ? glm::dvec3(greyOf(texelOf(image, x, y))) : texelOf(image, x, y));
    packTexels(packer, texels);
    return found->second;
}

/// At the origin of light space, without an intensity yet: that falls with the square of the distance, which is in scene units.
static light newPointLight(Packer& packer, const Light& d, light_kind kind) {
    light l = newLight(kind, packWhite(packer));
    l.p = toVec3(transformPoint(packer.space.sceneFromWorld() * d.worldFromLight, glm::dvec3(0)));
    return l;
}

PackedLight packImageLight(Packer& packer, const Light& d, const GoniometricLight& k) {
    const ImageData& image = sphereImage(packer, d, k.image);
    light l = newPointLight(packer, d, kind_goniometric_light);
    l.first_texel = packLightImage(packer, k.image, true);
    double mean = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) mean += greyOf(texelOf(image, x, y)) / (static_cast<double>(image.width) * image.height);
    const double watts = d.power ? *d.power / std::max(4 * M_PI * mean, 1e-30) : 1;
    const double factor = d.scale * watts * packer.space.scale * packer.space.scale;
    l.L = packEmission(packer, k.I, factor);
    const glm::dmat3 m = rotationOf(d);
    l.a = toVec3(m[0]); l.b = toVec3(m[2]); l.n = toVec3(m[1]);
    l.resolution = static_cast<uint>(image.width);
    return {l, 4 * M_PI * mean * luminanceOf(k.I, factor)};
}

PackedLight packImageLight(Packer& packer, const Light& d, const ProjectionLight& k) {
    const ImageData& image = *packer.images[static_cast<size_t>(k.image)];
    light l = newPointLight(packer, d, kind_projection_light);
    l.first_texel = packLightImage(packer, k.image, false);
    const double opposite = std::tan(glm::radians(k.fov) / 2), shorter = std::min(image.width, image.height);
    const double halfWidth = opposite * image.width / shorter, halfHeight = opposite * image.height / shorter;   /* of the slide, at z = 1 */
    double flux = 0;   /* luminance times solid angle */
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const double u = (2 * (x + 0.5) / image.width - 1) * halfWidth, v = (2 * (y + 0.5) / image.height - 1) * halfHeight;
            flux += luminance(texelOf(image, x, y)) * std::pow(1 + u * u + v * v, -1.5);
        }
    flux *= 4 * halfWidth * halfHeight / (static_cast<double>(image.width) * image.height);
    const double watts = d.power ? *d.power / std::max(flux, 1e-30) : 1, I = d.scale * watts * packer.space.scale * packer.space.scale;
    l.L = packWhite(packer, I);
    const glm::dmat3 m = rotationOf(d);
    l.a = toVec3(m[0] / halfWidth); l.b = toVec3(-m[1] / halfHeight); l.n = toVec3(m[2]);
    l.resolution = static_cast<uint>(image.width);
    l.rows = static_cast<uint>(image.height);
    return {l, flux * I};
}

/// Interpolated; beyond an edge of the square lies another part of it.
static glm::dvec3 lookUp(const ImageData& image, glm::dvec2 square) {
    const int n = image.width;
    const auto texel = [&](int x, int y) {
        if (x < 0 || x >= n) { x = x < 0 ? -x - 1 : 2 * n - 1 - x; y = n - 1 - y; }
        if (y < 0 || y >= n) { y = y < 0 ? -y - 1 : 2 * n - 1 - y; x = n - 1 - x; }
        return texelOf(image, x, y);
    };
    const double s = square.x * n - 0.5, t = square.y * n - 0.5;
    const int x = static_cast<int>(std::floor(s)), y = static_cast<int>(std::floor(t));
    return glm::mix(glm::mix(texel(x, y), texel(x + 1, y), s - x), glm::mix(texel(x, y + 1), texel(x + 1, y + 1), s - x), t - y);
}

PackedLight packImageLight(Packer& packer, const Light& d, const PortalInfiniteLight& k) {
    const ImageData* image = k.image == none ? nullptr : &sphereImage(packer, d, k.image);
    const glm::dvec3 x = glm::normalize(k.portal[3] - k.portal[0]), y = glm::normalize(k.portal[1] - k.portal[0]), n = glm::cross(x, y);
    const glm::dmat3 lightFromPortal = glm::transpose(rotationOf(d)) * glm::dmat3(x, y, n);
    const PortalImage portal = makePortalImage(image ? image->width : 1, [&](glm::dvec3 w) { return image ? lookUp(*image, squareFromDirection(lightFromPortal * w)) : glm::dvec3(1); });
    const double scale = d.scale * (image && d.illuminance ? *d.illuminance / upwardIlluminance(*image) : 1);
    light l = newLight(kind_portal_environment, image ? packWhite(packer, scale) : packEmission(packer, k.L, scale));
    l.a = toVec3(x); l.b = toVec3(y); l.n = toVec3(n);
    l.p = toVec3(transformPoint(packer.space.sceneFromWorld(), k.portal[0]));
    l.c = toVec3(transformPoint(packer.space.sceneFromWorld(), k.portal[2]));
    SceneTables& tables = packer.packed.tables;
    l.resolution = static_cast<uint>(portal.resolution);
    l.first_texel = nextTexel(packer);
    l.first_sum = static_cast<uint>(tables.portal_sums.size());
    packTexels(packer, {portal.texels.begin(), portal.texels.end()});
    tables.portal_sums.insert(tables.portal_sums.end(), portal.sums.begin(), portal.sums.end());
    packer.packed.require(Feature::PORTALS, d.where.toString());
    const double area = glm::length(k.portal[3] - k.portal[0]) * glm::length(k.portal[1] - k.portal[0]) * packer.space.scale * packer.space.scale;
    return {l, area * portal.fluence * (image ? scale : luminanceOf(k.L, scale))};
}

}  // namespace eikonal
