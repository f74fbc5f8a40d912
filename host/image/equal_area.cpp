#include "image/equal_area.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace eikonal {

using std::numbers::pi;

namespace {

/// Where a point of the square is, with the centre as origin. The inner diamond is the upper hemisphere.
struct Place {
    double u, v, x, y;        ///< in [-1, 1], and without signs
    double height;            ///< above the diamond's border: 1 at the upper pole, -1 at the lower one
    double r;                 ///< the distance to the nearer pole, 1 on the equator
    double z() const { return std::copysign(1 - r * r, height); }
};

Place placeOf(glm::dvec2 p) {
    const double u = 2 * p.x - 1, v = 2 * p.y - 1, x = std::abs(u), y = std::abs(v);
    const double height = 1 - (x + y);
    return {u, v, x, y, height, 1 - std::abs(height)};
}

}  // namespace

double heightFromSquare(glm::dvec2 p) { return placeOf(p).z(); }

glm::dvec3 directionFromSquare(glm::dvec2 p) {
    const Place at = placeOf(p);
    const double phi = at.r == 0 ? 0 : ((at.y - at.x) / at.r + 1) * pi / 4;
    const double sinTheta = at.r * std::sqrt(2 - at.r * at.r);
    return {std::copysign(std::cos(phi) * sinTheta, at.u), std::copysign(std::sin(phi) * sinTheta, at.v), at.z()};
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

glm::ivec2 wrapTexelOfSquare(glm::ivec2 texel, int resolution) {
    const int last = resolution - 1;
    int x = texel.x, y = texel.y;
    if (x < 0 || x > last) { x = x < 0 ? -x - 1 : 2 * resolution - 1 - x; y = last - y; }
    if (y < 0 || y > last) { y = y < 0 ? -y - 1 : 2 * resolution - 1 - y; x = last - x; }
    return {x, y};
}

glm::dvec3 texelOfSquare(const SquareGrid& grid, int x, int y, const std::function<glm::dvec3(glm::dvec2)>& radiance) {
    const auto& [resolution, samples] = grid;
    glm::dvec3 sum(0);
    for (int j = 0; j < samples; ++j)
        for (int i = 0; i < samples; ++i)
            sum += radiance({(x + (i + .5) / samples) / resolution, (y + (j + .5) / samples) / resolution});
    return sum / double(samples * samples);
}

ImageData equalAreaImage(int resolution, int samples, const std::function<glm::dvec3(glm::dvec3)>& radiance) {
    ImageData image{.width = resolution, .height = resolution, .channels = 3, .format = format_float};
    image.floats.resize(std::size_t(3) * resolution * resolution);
    const auto radianceAt = [&](glm::dvec2 p) { return radiance(directionFromSquare(p)); };
    tbb::parallel_for(0, resolution, [&](int y) {
        for (int x = 0; x < resolution; ++x) {
            const glm::dvec3 mean = texelOfSquare({resolution, samples}, x, y, radianceAt);
            for (int c = 0; c < 3; ++c) image.floats[(std::size_t(y) * resolution + x) * 3 + c] = static_cast<float>(mean[c]);
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
