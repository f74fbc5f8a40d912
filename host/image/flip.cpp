#include "image/flip.h"

#include "color/observer.h"
#include "color/transfer.h"
#include "image/compare.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace eikonal {
namespace {

constexpr double pi = std::numbers::pi;
using Plane = std::vector<glm::dvec3>;

const glm::dvec3& white() {
    static const glm::dvec3 xyz = xyzFromRgb(ColorSpace::srgb) * glm::dvec3(1);
    return xyz;
}

/// XYZ of linear sRGB, relative to its white.
glm::dvec3 relativeXyz(const glm::dvec3& rgb) { return xyzFromRgb(ColorSpace::srgb) * rgb / white(); }

/// The opponent space YCxCz, in which contrast sensitivity is known.
glm::dvec3 opponentFromStored(const glm::vec3& stored) {
    const glm::dvec3 rgb(linearFromSrgb(stored.x), linearFromSrgb(stored.y), linearFromSrgb(stored.z));
    const glm::dvec3 v = relativeXyz(rgb);
    return {116 * v.y - 16, 500 * (v.x - v.y), 200 * (v.y - v.z)};
}

glm::dvec3 rgbFromOpponent(const glm::dvec3& c) {
    const double y = (c.x + 16) / 116;
    return glm::clamp(rgbFromXyz(ColorSpace::srgb) * (glm::dvec3(y + c.y / 500, y, y - c.z / 200) * white()), 0., 1.);
}

/// CIELAB with the Hunt effect: chroma counts less where it is dark.
glm::dvec3 huntLab(const glm::dvec3& rgb) {
    glm::dvec3 f = relativeXyz(rgb);
    constexpr double delta = 6. / 29;
    for (int c = 0; c < 3; ++c) f[c] = f[c] > delta * delta * delta ? std::cbrt(f[c]) : f[c] / (3 * delta * delta) + 4. / 29;
    const double lightness = 116 * f.y - 16;
    return {lightness, 0.01 * lightness * 500 * (f.x - f.y), 0.01 * lightness * 200 * (f.y - f.z)};
}

double hyab(const glm::dvec3& a, const glm::dvec3& b) { return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z); }

/// A filter along one axis: weights of each channel at offsets -radius .. radius.
struct Kernel {
    int radius;
    Plane weights;
    template <class Weight> Kernel(int radius, Weight weight) : radius(radius) {
        for (int i = -radius; i <= radius; ++i) weights.push_back(glm::dvec3(weight(i)));
    }
    glm::dvec3 sum() const {
        glm::dvec3 total(0);
        for (const glm::dvec3& w : weights) total += w;
        return total;
    }
    /// Makes the positive weights sum to 1 and the negative ones to -1.
    void normalize() {
        glm::dvec3 positive(0), negative(0);
        for (const glm::dvec3& w : weights) positive += glm::max(w, 0.), negative -= glm::min(w, 0.);
        for (glm::dvec3& w : weights)
            for (int c = 0; c < 3; ++c)
                if (w[c] != 0) w[c] /= w[c] > 0 ? positive[c] : negative[c];
    }
};

/// Filters rows with `across` and columns with `down`.
Plane filter(const Plane& in, int width, int height, const Kernel& across, const Kernel& down) {
    const auto pass = [&](const Plane& from, const Kernel& kernel, int stepX, int stepY) {
        Plane to(from.size());
        tbb::parallel_for(0, height, [&](int y) {
            for (int x = 0; x < width; ++x) {
                glm::dvec3 sum(0);
                for (int i = -kernel.radius; i <= kernel.radius; ++i) {
                    const int px = std::clamp(x + i * stepX, 0, width - 1), py = std::clamp(y + i * stepY, 0, height - 1);
                    sum += kernel.weights[i + kernel.radius] * from[static_cast<std::size_t>(py) * width + px];
                }
                to[static_cast<std::size_t>(y) * width + x] = sum;
            }
        });
        return to;
    };
    return pass(pass(in, across, 1, 0), down, 0, 1);
}

/// Filters with the contrast sensitivity of the eye: one Gaussian for Y and Cx, the sum of two for Cz.
Plane seen(const Plane& opponent, int width, int height, double pixelsPerDegree) {
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * pixelsPerDegree));
    const auto gaussians = [&](const glm::dvec3& b) {
        return Kernel(radius, [=](int i) { return glm::exp(-std::pow(pi * i / pixelsPerDegree, 2) / b); });
    };
    const glm::dvec3 b1(0.0047, 0.0053, 0.04), b2(0.0047, 0.0053, 0.025), a1(1, 1, 34.1), a2(0, 0, 13.5);
    Kernel first = gaussians(b1), second = gaussians(b2);
    const glm::dvec3 s1 = first.sum(), s2 = second.sum();
    const glm::dvec3 share1 = a1 * glm::sqrt(pi / b1) * s1 * s1, share2 = a2 * glm::sqrt(pi / b2) * s2 * s2;
    first.normalize();
    second.normalize();
    Plane result = filter(opponent, width, height, first, first);
    const Plane other = filter(opponent, width, height, second, second);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = (share1 * result[i] + share2 * other[i]) / (share1 + share2);
    return result;
}

/// The strength of edges (x) and of points (y) in the luminance.
std::vector<glm::dvec2> features(const Plane& opponent, int width, int height, double pixelsPerDegree) {
    const double deviation = 0.5 * 0.082 * pixelsPerDegree;
    const int radius = static_cast<int>(std::ceil(3 * deviation));
    const auto gaussian = [=](int i) { return std::exp(-i * i / (2 * deviation * deviation)); };
    Kernel smooth(radius, gaussian);
    Kernel detect(radius, [&](int i) {
        return glm::dvec3(-i * gaussian(i), (i * i / (deviation * deviation) - 1) * gaussian(i), 0);
    });
    smooth.normalize();
    detect.normalize();
    Plane brightness(opponent.size());
    for (std::size_t i = 0; i < brightness.size(); ++i) brightness[i] = glm::dvec3((opponent[i].x + 16) / 116);
    const Plane along = filter(brightness, width, height, detect, smooth), down = filter(brightness, width, height, smooth, detect);
    std::vector<glm::dvec2> result(along.size());
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = {std::hypot(along[i].x, down[i].x), std::hypot(along[i].y, down[i].y)};
    return result;
}

/// The difference of two colours in [0, 1]: small differences get most of the range.
double colorDifference(const glm::dvec3& a, const glm::dvec3& b) {
    static const double largest = std::pow(hyab(huntLab({0, 1, 0}), huntLab({0, 0, 1})), 0.7);
    const double knee = 0.4 * largest, d = std::pow(hyab(huntLab(a), huntLab(b)), 0.7);
    return d < knee ? 0.95 * d / knee : std::min(1., 0.95 + 0.05 * (d - knee) / (largest - knee));
}

}  // namespace

Flip flip(const std::vector<glm::vec3>& test, const std::vector<glm::vec3>& reference, int width, int height, double pixelsPerDegree) {
    struct Appearance { Plane colors; std::vector<glm::dvec2> features; };
    const auto look = [&](const std::vector<glm::vec3>& stored) {
        Plane opponent(stored.size());
        std::ranges::transform(stored, opponent.begin(), opponentFromStored);
        return Appearance{seen(opponent, width, height, pixelsPerDegree), features(opponent, width, height, pixelsPerDegree)};
    };
    const Appearance a = look(test), b = look(reference);
    Flip result;
    for (std::size_t i = 0; i < test.size(); ++i) {
        const double color = colorDifference(rgbFromOpponent(a.colors[i]), rgbFromOpponent(b.colors[i]));
        const glm::dvec2 off = glm::abs(a.features[i] - b.features[i]);
        const double feature = std::min(1., std::sqrt(std::max(off.x, off.y) / std::sqrt(2.)));
        const double value = std::pow(color, 1 - feature);
        result.map.push_back(static_cast<float>(value));
        result.mean += value / static_cast<double>(test.size());
    }
    return result;
}

Flip flip(const FilmImage& test, const FilmImage& reference, const ToneMapping& mapping) {
    const PixelBounds both = sharedPixels(test, reference);
    const auto stored = [&](const FilmImage& image) {
        std::vector<glm::vec3> values;
        for (int y = both.y0; y < both.y1; ++y)
            for (int x = both.x0; x < both.x1; ++x) values.push_back(toneMap(image.color[image.index(x, y)], mapping));
        return values;
    };
    return flip(stored(test), stored(reference), both.x1 - both.x0, both.y1 - both.y0);
}

std::vector<float> flipMap(const FilmImage& test, const FilmImage& reference, const ToneMapping& mapping) {
    return flip(test, reference, mapping).map;
}

double flipMean(const FilmImage& test, const FilmImage& reference, const ToneMapping& mapping) {
    return flip(test, reference, mapping).mean;
}

glm::vec3 heatColor(float value) {
    // Nine evenly spaced colours of magma (van der Walt and Smith 2015, matplotlib).
    constexpr std::array<int, 9> points{0x000004, 0x1d1147, 0x51127c, 0x822681, 0xb63679, 0xe65164, 0xfb8861, 0xfec287, 0xfcfdbf};
    const auto color = [&](int i) { return glm::vec3(points[i] >> 16, points[i] >> 8 & 255, points[i] & 255) / 255.f; };
    const float at = std::clamp(value, 0.f, 1.f) * 8;
    const int i = std::min(static_cast<int>(at), 7);
    return glm::mix(color(i), color(i + 1), at - static_cast<float>(i));
}

}  // namespace eikonal
