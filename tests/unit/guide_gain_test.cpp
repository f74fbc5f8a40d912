// What a path guide gains: a light that is hit with probability p, and with the guide with probability q.

#include "render/guide_gain.h"

#include <gtest/gtest.h>

#include <random>

namespace eikonal {
namespace {

constexpr std::size_t samples = 4, pixels = 20000;
constexpr double p = 1. / 64, q = (1 + p) / 2;

/// direct: light of each path that is found before, 0 or twice this.
double measured(double direct) {
    GuideGain gain;
    std::mt19937 numbers(7);
    std::bernoulli_distribution hits(q), lit(.5);
    for (std::size_t batch = 0; batch < 2; ++batch) {
        gain.begin(samples * pixels / 2);
        for (std::size_t path = 0; path < samples * pixels / 2; ++path) {
            if (lit(numbers)) gain.found(path, 2 * direct);
            const bool hit = hits(numbers);
            gain.sampled(path, hit ? q : 1 - q, hit ? p : 1 - p);
            if (hit) gain.found(path, p / q);   // the light is 1
        }
    }
    return gain.varianceRatio(samples);
}
double expected(double direct) {
    const double noise = direct * direct, without = p * (1 - p), with = p * p * (1 - q) / q;
    return (noise + without) / (noise + with);
}

/// Pixels with a negative estimate of the variance count as 0, and the worst do not count: a few percent.
TEST(GuideGain, IsTheRatioOfVariances) {
    EXPECT_NEAR(measured(0) / expected(0), 1, .15);
    for (const double direct : {.05, .2}) EXPECT_NEAR(measured(direct) / expected(direct), 1, .05) << direct;
}

TEST(GuideGain, IsOneWithoutPathsAndWithoutNoise) {
    GuideGain none, still;
    EXPECT_EQ(none.varianceRatio(samples), 1);
    still.begin(samples);
    for (std::size_t path = 0; path < samples; ++path) still.found(path, 3);
    EXPECT_EQ(still.varianceRatio(samples), 1);
}

}  // namespace
}  // namespace eikonal
