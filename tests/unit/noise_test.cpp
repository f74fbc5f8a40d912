// The error of an image, estimated from sums over its pixels.

#include "film/noise.h"

#include <gtest/gtest.h>

#include <cmath>

namespace eikonal {
namespace {

/// Of 1000 pixels whose variance falls as V(n): what is expected of them with n samples.
template <class Variance> NoiseSums sumsOf(Variance v, double n) {
    const double half = v(n / 2) - v(n), quarter = v(n / 4) - v(n / 2);
    return {1000, 1000, 1000 * half, 1000 * quarter, 1000 * 3 * half * half, static_cast<unsigned>(n)};
}

TEST(VarianceDecay, OfIndependentSamplesIsOne) {
    const VarianceDecay decay = decayOf(sumsOf([](double n) { return 1 / n; }, 64));
    EXPECT_NEAR(decay.share, 1, 1e-9);
    EXPECT_NEAR(decay.exponent, 1, 1e-9);
}

// V = 1/n^2: V(n/2) - V(n) is 3 V(n).
TEST(VarianceDecay, OfSmoothPixelsIsAThird) {
    const VarianceDecay decay = decayOf(sumsOf([](double n) { return 1 / (n * n); }, 64));
    EXPECT_NEAR(decay.share, 1.0 / 3, 1e-9);
    EXPECT_NEAR(decay.exponent, 2, 1e-9);
}

// Between both, a pure power and a mixture of the two powers differ; the share is between what they say.
TEST(VarianceDecay, OfEdgesAndMixturesIsWithinATenth) {
    const auto edge = [](double n) { return std::pow(n, -1.5); };
    const auto mixture = [](double n) { return 1 / n + 64 / (n * n); };
    for (double n : {64.0, 256.0}) {
        const double ofEdge = edge(n) / (edge(n / 2) - edge(n)), ofMixture = mixture(n) / (mixture(n / 2) - mixture(n));
        EXPECT_NEAR(decayOf(sumsOf(edge, n)).share / ofEdge, 1, 0.2);
        EXPECT_NEAR(decayOf(sumsOf(mixture, n)).share / ofMixture, 1, 0.2);
    }
}

TEST(VarianceScale, IsOneAtPowersOfTwoAndThatOfIndependentRunsBetween) {
    for (unsigned n : {1u, 4u, 1024u}) EXPECT_DOUBLE_EQ(varianceScale(n, 1.7), 1);
    EXPECT_NEAR(varianceScale(100, 1), 64.0 / 100, 1e-12);
    /* 64 + 32 samples of variances 1 and 4: (64^2 + 4 * 32^2) / 96^2 */
    EXPECT_NEAR(varianceScale(96, 2), 8192.0 / 9216, 1e-12);
}

TEST(EstimateError, IsTheRootOfTheMeanVarianceInsideItsInterval) {
    const NoiseSums sums = sumsOf([](double n) { return 1 / n; }, 64);
    const ErrorEstimate e = estimateError(sums, decayOf(sums), ErrorMetric::mseRoot);
    EXPECT_NEAR(e.error, 1.0 / 8, 1e-9);
    EXPECT_LT(e.low, e.error);
    EXPECT_GT(e.high, e.error);
    EXPECT_LT(e.high / e.low, 1.5);
    EXPECT_EQ(e.doubt, "");
    NoiseSums bright = sums;
    bright.brightness *= 4;
    EXPECT_NEAR(estimateError(bright, decayOf(bright), ErrorMetric::nrmse).error, 1.0 / 32, 1e-9);
}

TEST(EstimateError, IsInDoubtWhereFewPixelsHoldItOrNothingIsKnown) {
    NoiseSums sums = sumsOf([](double n) { return 1 / n; }, 64);
    sums.squares = sums.half * sums.half / 2;   // as if two pixels held it
    EXPECT_EQ(estimateError(sums, {}, ErrorMetric::relmseRoot).doubt, "very few pixels hold most of it");
    EXPECT_EQ(estimateError({1000, 0, 0, 0, 0, 64}, {}, ErrorMetric::relmseRoot).doubt, "no sample has found light");
    sums.fewest = 1;
    EXPECT_EQ(estimateError(sums, {}, ErrorMetric::relmseRoot).doubt, "a pixel has only 1 sample");
}

TEST(NoiseSums, Add) {
    NoiseSums sum;
    sum += {1, 2, 3, 4, 5, 64};
    sum += {1, 2, 3, 4, 5, 16};
    EXPECT_EQ(sum.pixels, 2);
    EXPECT_EQ(sum.half, 6);
    EXPECT_EQ(sum.fewest, 16u);
}

}  // namespace
}  // namespace eikonal
