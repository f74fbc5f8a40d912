// The error of an image, estimated from sums over its pixels.

#include "film/noise.h"

#include <gtest/gtest.h>

#include <cmath>

namespace eikonal {
namespace {

/// Of 1000 pixels whose variance falls as V(n): what is expected of them with n samples.
template <class Variance> NoiseSums sumsOf(Variance v, double n) {
    const double half = v(n / 2) - v(n), quarter = v(n / 4) - v(n / 2), eighth = v(n / 8) - v(n / 4), sum = half + quarter;
    return {1000, 1000, 1000 * half, 1000 * quarter, 1000 * eighth, 1000 * 5.0 / 3 * sum * sum, 0, static_cast<unsigned>(n)};
}

/// The error that is estimated over the true one.
template <class Variance> double estimated(Variance v, double n) {
    const NoiseSums sums = sumsOf(v, n);
    return estimateError(sums, decayOf(sums), ErrorMetric::mseRoot).error / std::sqrt(v(n));
}

TEST(VarianceDecay, OfIndependentSamplesIsOne) {
    for (double n : {4.0, 8.0, 64.0}) {
        const auto v = [](double m) { return 1 / m; };
        EXPECT_NEAR(estimated(v, n), 1, 1e-9);
        EXPECT_NEAR(decayOf(sumsOf(v, n)).exponent, 1, 1e-9);
    }
}

// V = 1/n^2 and 1/n^3; of fewer than 64 samples so fast a fall is not believed to go on.
TEST(VarianceDecay, OfSmoothPixelsIsLearned) {
    for (double power : {2.0, 3.0}) {
        const auto v = [&](double m) { return std::pow(m, -power); };
        EXPECT_NEAR(estimated(v, 64), 1, 1e-9) << power;
        EXPECT_NEAR(decayOf(sumsOf(v, 64)).exponent, power, 1e-9);
        EXPECT_GT(estimated(v, 32), 1.1) << power;
    }
}

// A sequence in base 4: V falls by 2 and by 32 in turn.
TEST(VarianceDecay, OfStepsThatAlternateIsLearned) {
    const auto v = [](double m) { return std::pow(m, -3.0) * (static_cast<int>(std::round(std::log2(m))) % 2 == 0 ? 1 : 4); };
    for (double n : {64.0, 128.0, 256.0}) EXPECT_NEAR(estimated(v, n), 1, 1e-9) << n;
}

// Between both, a pure power and a mixture of the two powers differ; the estimate is between what they say.
TEST(VarianceDecay, OfEdgesAndMixturesIsWithinAnEighth) {
    for (double n : {64.0, 256.0}) {
        EXPECT_NEAR(estimated([](double m) { return std::pow(m, -1.5); }, n), 1, 0.125) << n;
        EXPECT_NEAR(estimated([](double m) { return 1 / m + 64 / (m * m); }, n), 1, 0.125) << n;
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
    sums.squares = std::pow(sums.half + sums.quarter, 2) / 2;   // as if two pixels held it
    EXPECT_EQ(estimateError(sums, {}, ErrorMetric::relmseRoot).doubt, "very few pixels hold most of it");
    EXPECT_EQ(estimateError({1000, 0, 0, 0, 0, 0, 0, 64}, {}, ErrorMetric::relmseRoot).doubt, "no sample has found light");
    const auto doubtAt = [](double mean, ErrorMetric metric) {
        return estimateError({1000, 1000 * mean, 0, 0, 0, 0, 0, 64}, {}, metric).doubt;
    };
    for (double mean : {1e-20, 1e20}) EXPECT_NE(doubtAt(mean, ErrorMetric::nrmse).find("single precision"), std::string::npos) << mean;
    for (double mean : {1e-10, 1e10}) EXPECT_EQ(doubtAt(mean, ErrorMetric::nrmse), "") << mean;
    EXPECT_FALSE(estimateError({1000, 1e-17, 0, 0, 0, 0, 0, 64}, {}, ErrorMetric::nrmse).isKnown);
    EXPECT_EQ(doubtAt(1e-20, ErrorMetric::relmseRoot), "") << "far below the floor of this metric";
    NoiseSums bright = sumsOf([](double n) { return 1 / n; }, 64);
    bright.suspicion = std::pow(bright.pixels / 64, 2) / 4;   // as large as half of the sum of squared errors
    EXPECT_EQ(estimateError(bright, {}, ErrorMetric::relmseRoot).doubt, "single bright samples may hold most of it");
    sums.fewest = 1;
    const ErrorEstimate unknown = estimateError(sums, {}, ErrorMetric::relmseRoot);
    EXPECT_EQ(describe(unknown, ErrorMetric::relmseRoot), "error not known (relmse-root): a pixel has only 1 sample");
}

TEST(NoiseSums, Add) {
    NoiseSums sum;
    sum += {1, 2, 3, 4, 5, 6, 7, 64};
    sum += {1, 2, 3, 4, 5, 6, 7, 16};
    EXPECT_EQ(sum.pixels, 2);
    EXPECT_EQ(sum.half, 6);
    EXPECT_EQ(sum.eighth, 10);
    EXPECT_EQ(sum.suspicion, 14);
    EXPECT_EQ(sum.fewest, 16u);
}

}  // namespace
}  // namespace eikonal
