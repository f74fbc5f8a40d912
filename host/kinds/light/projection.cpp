// Projection light: a slide in front of a point light, projected along +z of light space with its top at +y (kernels/light/projection.clh).

#include "color/luminance.h"
#include "kinds/light_packing.h"
#include "kinds/light_reading.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eikonal {

static bool read(const pbrt::LightReading& in, Light& light) {
    light.fov = in.arguments.number("fov");
    light.power = strengthOf(in.reading, in.arguments, "power");
    return readImage(in, wrap_clamp, light);
}

static PackedLight pack(const LightPacking& in, const Light& d) {
    const ImageData& image = in.context.imageData(d.image);
    light l = newPointLight(in, d, kind_projection_light);
    l.first_texel = packLightImage(in, d.image, false);
    const double opposite = std::tan(glm::radians(d.fov) / 2), shorter = std::min(image.width, image.height);
    const double halfWidth = opposite * image.width / shorter, halfHeight = opposite * image.height / shorter;   // of the slide, at z = 1
    double flux = 0;   // luminance times solid angle
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const double u = (2 * (x + 0.5) / image.width - 1) * halfWidth, v = (2 * (y + 0.5) / image.height - 1) * halfHeight;
            flux += luminance(texelOf(image, x, y)) * std::pow(1 + u * u + v * v, -1.5);
        }
    flux *= 4 * halfWidth * halfHeight / (static_cast<double>(image.width) * image.height);
    const double watts = d.power ? *d.power / std::max(flux, 1e-30) : 1, I = d.scale * watts * intensityScale(in.context);
    l.L = in.colors.white(I);
    const glm::dmat3 m = rotationOf(in.context, d);
    l.a = toVec3(m[0] / halfWidth); l.b = toVec3(-m[1] / halfHeight); l.n = toVec3(m[2]);
    l.resolution = static_cast<uint>(image.width);
    l.rows = static_cast<uint>(image.height);
    return {l, flux * I};
}

static void bound(const light& l, double power, LightBounds& bounds) {
    const glm::dvec3 x = toGlm(l.a), y = toGlm(l.b);
    const double corner = std::atan(std::sqrt(1 / glm::dot(x, x) + 1 / glm::dot(y, y)));
    bounds.normals = corner;
    bounds.emission = leastEmission;
    bounds.intensity = power / (2 * std::numbers::pi * (1 - std::cos(corner)));
}

const LightTraits projection_light{.directive = "projection", .parameters = "file filename; float power = -1; float fov = 90 in (0, 180)",
                                        .read = read, .pack = pack, .bound = bound};

}  // namespace eikonal
