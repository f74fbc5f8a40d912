// Goniometric light: a point light whose intensity is I times a square image in the equal-area mapping of the sphere
// (kernels/light/goniometric.clh). As in pbrt-v4, the image's +z is +y of light space, and its values are the mean of R, G and B.

#include "kinds/light_packing.h"
#include "kinds/light_reading.h"

#include <algorithm>
#include <cmath>

namespace eikonal {

static bool read(const pbrt::LightReading& in, Light& light) {
    light.spectrum = in.arguments.spectrum("I", whiteOf(in.arguments));
    light.power = strengthOf(in.reading, in.arguments, "power");
    return readImage(in, wrap_octahedral, light);
}

static PackedLight pack(const LightPacking& in, const Light& d) {
    const ImageData& image = sphereImage(in.context, d);
    light l = newPointLight(in, d, kind_goniometric_light);
    l.first_texel = packLightImage(in, d.image, true);
    double mean = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) mean += greyOf(texelOf(image, x, y)) / (static_cast<double>(image.width) * image.height);
    const double watts = d.power ? *d.power / std::max(4 * M_PI * mean, 1e-30) : 1;
    const double factor = d.scale * watts * intensityScale(in.context);
    l.L = in.colors.emission(d.spectrum, factor);
    const glm::dmat3 m = rotationOf(in.context, d);
    l.a = toVec3(m[0]); l.b = toVec3(m[2]); l.n = toVec3(m[1]);
    l.resolution = static_cast<uint>(image.width);
    return {l, 4 * M_PI * mean * luminanceOf(d.spectrum, factor)};
}

const LightTraits goniometric_light{.directive = "goniometric",
                                    .parameters = "spectrum I; file filename; float power = -1",
                                    .read = read,
                                    .pack = pack,
                                    .bound = boundPoint};

}  // namespace eikonal
