// What is taken from an image as fireflies.

#include "film/fireflies.h"

#include "eikonal/film.h"

#include <gtest/gtest.h>

#include <cmath>

namespace eikonal {
namespace {

constexpr std::size_t side = 5, middle = side * side / 2;
constexpr float samples = 16;

/// A film of 5 x 5 pixels of 16 samples each, all dim: of luminance 0.1.
struct SmallFilm {
    std::vector<float> sums = std::vector<float>(BRIGHTNESS_BANDS * GROUP_WORDS * side * side);
    std::vector<float> weights = std::vector<float>(side * side, samples);

    SmallFilm() {
        for (std::size_t i = 0; i < side * side; ++i) add(i, 0, 0.1f * samples);
    }
    /// Adds grey light to a band of a pixel.
    void add(std::size_t pixel, int band, float light) {
        for (int c = 0; c < WORDS_rgb; ++c) sums[static_cast<std::size_t>(band * GROUP_WORDS + c) * side * side + pixel] += light;
    }
    std::vector<glm::vec3> fireflies() const { return firefliesIn({side, side, sums.data(), weights.data()}); }
};

/// The luminance of a band's samples.
float levelOf(int band) { return LEAST_BRIGHTNESS * std::pow(BAND_RATIO, static_cast<float>(band)); }

TEST(Fireflies, ASingleBrightSampleIsTakenButForWhatDoesNotShow) {
    for (const std::size_t pixel : {std::size_t{0}, middle, side * side - 1}) {
        SmallFilm film;
        film.add(pixel, 5, levelOf(5));
        const std::vector<glm::vec3> taken = film.fireflies();
        const float added = levelOf(5) / samples;
        EXPECT_NEAR(taken[pixel].r, added - 0.25 * 0.1, 1e-3 * added) << pixel;
        for (std::size_t i = 0; i < taken.size(); ++i) EXPECT_EQ(taken[i] != glm::vec3(0), i == pixel) << i;
    }
}

TEST(Fireflies, OneInEachPixelIsNone) {
    SmallFilm film;
    for (std::size_t i = 0; i < side * side; ++i) film.add(i, 5, levelOf(5));
    for (const glm::vec3& taken : film.fireflies()) EXPECT_EQ(taken, glm::vec3(0));
}

/// A small lamp: one pixel, but a quarter of its samples.
TEST(Fireflies, SeveralInOnePixelAreNone) {
    SmallFilm film;
    film.add(middle, 5, 4 * levelOf(5));
    for (const glm::vec3& taken : film.fireflies()) EXPECT_EQ(taken, glm::vec3(0));
}

TEST(Fireflies, WhatHardlyShowsStays) {
    SmallFilm film;
    film.weights.assign(side * side, 4096);
    for (std::size_t i = 0; i < side * side; ++i) film.add(i, 0, 0.1f * (4096 - samples));
    film.add(middle, 2, levelOf(2));
    for (const glm::vec3& taken : film.fireflies()) EXPECT_EQ(taken, glm::vec3(0));
}

/// As samples are added, any brightness is found often enough.
TEST(Fireflies, VanishWithMoreSamples) {
    double before = 1;
    for (const float more : {1.f, 2.f, 4.f}) {
        SmallFilm film;
        film.weights.assign(side * side, samples * more);
        film.add(middle, 5, levelOf(5) * more);
        const double share = double{film.fireflies()[middle].r} / (double{levelOf(5)} / samples);
        EXPECT_LT(share, before);
        before = share;
    }
    EXPECT_EQ(before, 0);
}

TEST(Fireflies, ShareIsOfTheLightOfBoth) {
    EXPECT_NEAR(firefliesShare({glm::vec3(1), glm::vec3(0)}, {glm::vec3(1), glm::vec3(2)}), 0.25, 1e-6);
    EXPECT_EQ(firefliesShare({glm::vec3(0)}, {glm::vec3(0)}), 0);
}

}  // namespace
}  // namespace eikonal
