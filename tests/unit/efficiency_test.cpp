// Error per second, from renders of several seeds.

#include "app/efficiency.h"

#include "error.h"
#include "image/compare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace eikonal {
namespace {

/// An image whose left half has mean 1 and right half mean 3; a sample is exponentially distributed, so that the variance of a pixel is its mean
/// squared over `samples`. `scale`: an exposure.
FilmImage noisy(std::mt19937& random, int samples, float scale = 1) {
    FilmImage image(16, 16);
    std::gamma_distribution<float> mean(static_cast<float>(samples), 1 / static_cast<float>(samples));
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) image.color[image.index(x, y)] = scale * (x < 8 ? 1.f : 3.f) * glm::vec3(mean(random), mean(random), mean(random));
    return image;
}

/// What SeedVariance is to find for `noisy`: m = 2, so 0.5 (1 / (1 + .04) + 9 / (9 + .04)) / samples.
double expected(int samples) { return (.5 / 1.04 + 4.5 / 9.04) / samples; }

TEST(SeedVariance, IsTheVarianceOfPixelsRelativeToWhatTheyAre) {
    std::mt19937 random(5);
    for (const int samples : {64, 256}) {
        SeedVariance renders;
        for (int seed = 0; seed < 200; ++seed) renders.add(noisy(random, samples));
        const Estimate found = renders.relativeVariance();
        EXPECT_NEAR(found.value / expected(samples), 1, .01) << samples << " samples";
        EXPECT_NEAR(found.value, expected(samples), 5 * found.standardError);
    }
}

TEST(SeedVariance, DoesNotDependOnTheExposure) {
    std::mt19937 random(6), same(6);
    SeedVariance renders, brighter;
    for (int seed = 0; seed < 5; ++seed) {
        renders.add(noisy(random, 16));
        brighter.add(noisy(same, 16, 1024));
    }
    EXPECT_NEAR(brighter.relativeVariance().value, renders.relativeVariance().value, 1e-9);
}

// A pixel of 10^4 whose seeds differ in the fifth digit: sums of squares would lose it in single precision, and half of the digits in double.
TEST(SeedVariance, SurvivesCancellation) {
    SeedVariance renders;
    for (const float value : {10000.f, 10001.f, 10002.f, 10003.f}) {
        FilmImage image(1, 1);
        image.color[0] = glm::vec3(value);
        renders.add(image);
    }
    const double mean = 10001.5;
    EXPECT_NEAR(renders.relativeVariance().value, (5. / 3) / (1.01 * mean * mean), 1e-18);
}

// Deviations of 400 estimates, in units of the standard errors that they state, have a root mean square of 1; channels are independent here but
// taken for equal, which makes it 1 / sqrt(3). Of 400 squares the mean is known to 10 %.
TEST(SeedVariance, KnowsItsStandardError) {
    std::mt19937 random(7);
    double squares = 0;
    constexpr int trials = 400;
    for (int trial = 0; trial < trials; ++trial) {
        SeedVariance renders;
        for (int seed = 0; seed < SeedVariance::leastSeeds; ++seed) renders.add(noisy(random, 64));
        const Estimate found = renders.relativeVariance();
        squares += std::pow((found.value - expected(64)) / found.standardError, 2) / trials;
    }
    EXPECT_NEAR(std::sqrt(squares), 1 / std::sqrt(3.), .1);
}

// What `compare` says of one render against the truth is what the variance between seeds says without it.
TEST(SeedVariance, IsTheRelativeMseOfCompare) {
    std::mt19937 random(8);
    FilmImage truth(16, 16);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) truth.color[truth.index(x, y)] = glm::vec3(x < 8 ? 1.f : 3.f);
    double error = 0;
    SeedVariance renders;
    for (int seed = 0; seed < 50; ++seed) {
        const FilmImage image = noisy(random, 64);
        renders.add(image);
        error += compare(image, truth).relativeMse / 50;
    }
    EXPECT_NEAR(renders.relativeVariance().value / error, 1, .02);
}

// Pixels of mean 1 of which one value in a thousand is 900.1 and the others are 0.1: relative to the mean of four seeds, most of the variance is hidden.
TEST(SeedVariance, AConvergedImageLetsOutliersCount) {
    std::mt19937 random(9);
    std::bernoulli_distribution isOutlier(.001);
    FilmImage truth(64, 64);
    std::ranges::fill(truth.color, glm::vec3(1));
    double hidden = 0, found = 0;
    for (int trial = 0; trial < 50; ++trial) {
        SeedVariance renders;
        for (int seed = 0; seed < SeedVariance::leastSeeds; ++seed) {
            FilmImage image(64, 64);
            for (glm::vec3& pixel : image.color) pixel = glm::vec3(isOutlier(random) ? 900.1f : .1f);
            renders.add(image);
        }
        hidden += renders.relativeVariance().value / 50;
        found += renders.relativeVariance(&truth).value / 50;
    }
    const double variance = .001 * .999 * 900 * 900 / 1.01;
    EXPECT_NEAR(found / variance, 1, .05);
    EXPECT_LT(hidden / variance, .1);
}

// One pixel in a hundred varies a thousand times as much as the others.
TEST(SeedVariance, LeavesOutTheWorstPixels) {
    std::mt19937 random(10);
    std::normal_distribution<float> noise;
    FilmImage truth(100, 100);
    std::ranges::fill(truth.color, glm::vec3(1));
    SeedVariance renders;
    for (int seed = 0; seed < 16; ++seed) {
        FilmImage image(100, 100);
        for (size_t i = 0; i < image.color.size(); ++i) image.color[i] = glm::vec3(1 + (i % 100 ? .1f : 3.16f) * noise(random));
        renders.add(image);
    }
    EXPECT_NEAR(renders.relativeVariance(&truth).value, (.99 * .01 + .01 * 10) / 1.01, .015);
    EXPECT_NEAR(renders.relativeVariance(&truth, .01).value, .99 * .01 / 1.01, .0003);
}

TEST(SeedVariance, RefusesAReferenceOfAnotherSize) {
    SeedVariance renders;
    for (int seed = 0; seed < 4; ++seed) renders.add(FilmImage(4, 4));
    const FilmImage other(5, 4);
    EXPECT_THROW(renders.relativeVariance(&other), Error);
}

TEST(SeedVariance, BlackHasNone) {
    SeedVariance renders;
    for (int seed = 0; seed < 4; ++seed) renders.add(FilmImage(4, 4));
    EXPECT_EQ(renders.relativeVariance().value, 0);
}

TEST(SeedVariance, RefusesAnotherSize) {
    SeedVariance renders;
    renders.add(FilmImage(4, 4));
    EXPECT_THAT([&] { renders.add(FilmImage(4, 5)); }, testing::ThrowsMessage<Error>("a render of 20 pixels cannot be combined with renders of 16"));
}

TEST(Efficiency, IsOneOverVarianceTimesTheMedianOfTheSeconds) {
    const Efficiency found = efficiencyOf({.01, .0001}, {2, 9, 2, 2, 1});
    EXPECT_DOUBLE_EQ(found.value, 50);
    EXPECT_LT(found.low, 50);
    EXPECT_DOUBLE_EQ(found.low * found.high, 2500) << "as many times below as above";
    const Efficiency steady = efficiencyOf({.01, .0001}, {2, 2, 2, 2});
    EXPECT_NEAR(steady.high / steady.value, std::exp(1.96 * .01), 1e-9) << "the variance's error alone";
}

}  // namespace
}  // namespace eikonal
