#include "image/flip.h"

#include "error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace eikonal {
namespace {

using Pixels = std::vector<glm::vec3>;

Pixels constant(float grey) { return Pixels(20 * 10, glm::vec3(grey)); }

/// Two unlike patterns of 32 x 24 pixels: fine texture, and ramps.
struct Patterns {
    static constexpr int width = 32, height = 24;
    Pixels texture, ramps;
    Patterns() {
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                texture.emplace_back((x * 7 + y * 3) % 32 / 31.f, (x * x + y) % 29 / 28.f, (x + y * y) % 23 / 22.f);
                ramps.emplace_back(x / 31.f, y / 23.f, 0.5f);
            }
    }
    double mean(double pixelsPerDegree) const { return flip(texture, ramps, width, height, pixelsPerDegree).mean; }
};

/// FLIP of two constant greys whose CIELAB lightness differs by `lightness`: no features, and the difference to the power of 0.7 against
/// that of green and blue, whose CIELAB colours are well known (chroma is scaled by lightness / 100: the Hunt effect).
double greyFlip(double lightness) {
    const double lg = 87.7347, lb = 32.2970;
    const double a = 0.01 * (lg * -86.1827 - lb * 79.1875), b = 0.01 * (lg * 83.1793 - lb * -107.8602);
    const double largest = std::pow(lg - lb + std::hypot(a, b), 0.7), d = std::pow(lightness, 0.7);
    return d < 0.4 * largest ? 0.95 * d / (0.4 * largest) : 0.95 + 0.05 * (d - 0.4 * largest) / (0.6 * largest);
}

TEST(Flip, OfIdenticalImagesIsZero) {
    const Patterns p;
    for (float each : flip(p.texture, p.texture, p.width, p.height).map) EXPECT_EQ(each, 0);
}

// White has lightness 100. 18.4187 % of white, the stored value 0.466327, has lightness 50.
TEST(Flip, OfConstantGreysFollowsTheFormula) {
    EXPECT_NEAR(flip(constant(0), constant(1), 20, 10).mean, greyFlip(100), 1e-4);
    EXPECT_NEAR(flip(constant(0.466327f), constant(1), 20, 10).mean, greyFlip(50), 1e-4);
    for (float each : flip(constant(0.466327f), constant(0), 20, 10).map) EXPECT_NEAR(each, greyFlip(50), 1e-4);
}

TEST(Flip, IsSymmetric) {
    const Patterns p;
    EXPECT_EQ(flip(p.texture, p.ramps, p.width, p.height).map, flip(p.ramps, p.texture, p.width, p.height).map);
}

TEST(Flip, FineTextureDisappearsWhenPixelsAreSmall) {
    Pixels checkers(32 * 32), grey(32 * 32, glm::vec3(0.7353569f));  // half of white's light
    for (int i = 0; i < 32 * 32; ++i) checkers[i] = glm::vec3((i + i / 32) % 2);
    EXPECT_LT(flip(checkers, grey, 32, 32, 200).mean, 0.5 * flip(checkers, grey, 32, 32, 20).mean);
}

// The expected means are those of flip-evaluator 1.7 (PyPI).
TEST(Flip, AgreesWithFlipEvaluator) {
    EXPECT_NEAR(Patterns().mean(67.02), 0.8064949, 1e-4);
    EXPECT_NEAR(Patterns().mean(30), 0.8311627, 1e-4);
}

TEST(Flip, ComparesTheSharedPixelsOfFilms) {
    FilmImage whole(20, 10), part(20, 10, {4, 9, 2, 5});
    for (glm::vec3& each : part.color) each = glm::vec3(7);
    EXPECT_EQ(flipMap(part, whole).size(), 15u);
    EXPECT_NEAR(flipMean(part, whole), greyFlip(100), 1e-4);
    EXPECT_NEAR(flipMean(part, whole, {ToneCurve::clamp, std::log2(0.1841865 / 7)}), greyFlip(50), 1e-4);
    EXPECT_THROW(flipMean(part, FilmImage(10, 10)), Error);
    EXPECT_THROW(flipMean(part, FilmImage(20, 10, {9, 20, 0, 10})), Error);
}

TEST(Flip, HeatColorsGrowBrighter) {
    const auto sum = [](float at) { const glm::vec3 c = heatColor(at); return c.x + c.y + c.z; };
    for (int i = 0; i < 64; ++i) EXPECT_LT(sum(i / 64.f), sum((i + 1) / 64.f)) << i;
    EXPECT_EQ(heatColor(2), heatColor(1));
}

}  // namespace
}  // namespace eikonal
