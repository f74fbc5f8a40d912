#include "image/equal_area.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace eikonal {

using std::numbers::pi;

glm::dvec3 directionFromSquare(glm::dvec2 p) {
    // The inner diamond of the square is the upper hemisphere; r is the distance to the nearer pole, 1 on the equator.
    const double u = 2 * p.x - 1, v = 2 * p.y - 1, x = std::abs(u), y = std::abs(v);
    const double height = 1 - (x + y), r = 1 - std::abs(height);
    const double phi = r == 0 ? 0 : ((y - x) / r + 1) * pi / 4;
    const double sinTheta = r * std::sqrt(2 - r * r);
    return {std::copysign(std::cos(phi) * sinTheta, u), std::copysign(std::sin(phi) * sinTheta, v), std::copysign(1 - r * r, height)};
}

glm::dvec2 squareFromDirection(glm::dvec3 d) {
    d /= glm::length(d);
    const double r = std::sqrt(std::max(0., 1 - std::abs(d.z)));
    double v = r * std::atan2(std::abs(d.y), std::abs(d.x)) * 2 / pi, u = r - v;
    if (d.z < 0) {
        const double swapped = 1 - v;
        v = 1 - u;
        u = swapped;
    }
    return {(std::copysign(u, d.x) + 1) / 2, (std::copysign(v, d.y) + 1) / 2};
}

ImageData equalAreaImage(int resolution, int samples, const std::function<glm::dvec3(glm::dvec3)>& radiance) {
    ImageData image{.width = resolution, .height = resolution, .channels = 3, .format = format_float};
    image.floats.resize(std::size_t(3) * resolution * resolution);
    tbb::parallel_for(0, resolution, [&](int y) {
        for (int x = 0; x < resolution; ++x) {
            glm::dvec3 sum(0);
            for (int j = 0; j < samples; ++j)
                for (int i = 0; i < samples; ++i)
                    sum += radiance(directionFromSquare({(x + (i + .5) / samples) / resolution, (y + (j + .5) / samples) / resolution}));
            for (int c = 0; c < 3; ++c)
                image.floats[(std::size_t(y) * resolution + x) * 3 + c] = static_cast<float>(sum[c] / (samples * samples));
        }
    });
    return image;
}

ImageData equalAreaFromLatLong(const ImageData& latLong, int resolution) {
    const int width = latLong.width, height = latLong.height;
    if (resolution <= 0) resolution = static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::ceil(std::sqrt(double(width) * height)))));

    const auto texel = [&](int x, int y) {
        x = (x % width + width) % width;
        y = std::clamp(y, 0, height - 1);
        const auto channel = [&](int c) { return latLong.at(x, y, latLong.channels == 1 ? 0 : c); };
        return glm::dvec3(channel(0), channel(1), channel(2));
    };
    const auto lookup = [&](glm::dvec3 d) {
        const double s = std::atan2(d.y, d.x) / (2 * pi) * width - .5, t = std::acos(std::clamp(d.z, -1., 1.)) / pi * height - .5;
        const int x = static_cast<int>(std::floor(s)), y = static_cast<int>(std::floor(t));
        return glm::mix(glm::mix(texel(x, y), texel(x + 1, y), s - x), glm::mix(texel(x, y + 1), texel(x + 1, y + 1), s - x), t - y);
    };

    // Sample densely enough to miss no source texel: a texel's side spans up to 1.6 times what its area suggests.
    const int samples = std::max(2, static_cast<int>(std::ceil(2. * std::sqrt(double(width) * height) / resolution)));
    return equalAreaImage(resolution, samples, lookup);
}

}  // namespace eikonal
