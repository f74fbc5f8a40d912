// The random numbers: functions of (pixel, sample, dimension, seed) only, stratified with the Sobol' sampler, independent without.

#include "device_function.h"
#include "random_inputs.h"
#include "statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace eikonal {
namespace {

struct Drawn { float one; vec2 two; };

class Sampler {
public:
    explicit Sampler(bool sobol)
        : function_({.include = "random.clh", .type = "drawn", .body = "result.one = sample_1d(seed, sample, dimension); result.two = sample_2d(seed, sample, dimension);",
                     .inputs = {"uint seed", "uint sample", "uint dimension"}, .declarations = "typedef struct { float one; vec2 two; } drawn;",
                     .features = sobol ? Features().require(Feature::SOBOL) : Features()}) {}
    /// `count` samples from `first` on, of one dimension of one pixel.
    std::vector<Drawn> draw(uint seed, uint dimension, uint first, uint count) const {
        std::vector<uint> sample;
        for (uint i = 0; i < count; ++i) sample.push_back(first + i);
        return function_(std::vector<uint>(count, seed), sample, std::vector<uint>(count, dimension));
    }

private:
    DeviceFunction<Drawn> function_;
};

/// Of 2^k samples from a multiple of 2^k on, exactly one lies in each of the 2^k elementary intervals, for every shape
/// 2^-a x 2^-(k-a): the definition of a (0, 2)-sequence in base 2, and Owen scrambling keeps it. In one dimension likewise.
TEST(SobolSampler, StratifiesEveryBlockInEveryDimension) {
    const Sampler sampler(true);
    Random random(21);
    for (int test = 0; test < 24; ++test) {
        const uint seed = random.word(), dimension = test < 8 ? static_cast<uint>(test) : 8 + random.below(16 * 40);
        const auto all = sampler.draw(seed, dimension, 0, 4096);
        for (uint k = 0; k <= 12; k += 3)
            for (uint block = 0; block + (1u << k) <= 4096 && block < 8u << k; block += 1u << k) {
                const uint n = 1u << k;
                std::vector<int> strata(n);
                for (uint i = block; i < block + n; ++i) ++strata[static_cast<size_t>(all[i].one * static_cast<float>(n))];
                ASSERT_EQ(std::count(strata.begin(), strata.end(), 1), n) << "one dimension, seed " << seed << " dimension " << dimension << " block " << block << " of " << n;
                for (uint a = 0; a <= k; ++a) {
                    std::vector<int> cells(n);
                    for (uint i = block; i < block + n; ++i) {
                        const uint x = static_cast<uint>(all[i].two.x * static_cast<float>(1u << a)), y = static_cast<uint>(all[i].two.y * static_cast<float>(1u << (k - a)));
                        ++cells[(y << a) + x];
                    }
                    ASSERT_EQ(std::count(cells.begin(), cells.end(), 1), n) << "seed " << seed << " dimension " << dimension << " block " << block << " of " << n << " a " << a;
                }
            }
    }
}

/// The samples of a block of pixels are as well spread as those of one pixel: 4 x 4 pixels with 4 samples each have one sample in each of
/// the 64 elementary intervals of every shape, wherever an aligned block lies; and so in a tile and beyond it.
TEST(SobolSampler, SpreadsTheSamplesOfBlocksOfPixels) {
    const DeviceFunction<Drawn> draw({.include = "camera/camera.clh", .type = "drawn",
        .body = "sequence_place at = place_in_sequence(x, y, sample, 5u, 2u, 3u); result.one = sample_1d(at.seed, at.index, 9u); result.two = sample_2d(at.seed, at.index, 9u);",
        .inputs = {"uint x", "uint y", "uint sample"}, .declarations = "typedef struct { float one; vec2 two; } drawn;", .features = Features::all()});
    for (const auto& [left, top] : {std::pair{0u, 0u}, {4u, 0u}, {4u, 4u}, {8u, 12u}, {1000u, 496u}}) {
        std::vector<uint> x, y, sample;
        for (uint i = 0; i < 64; ++i) { x.push_back(left + i % 4); y.push_back(top + i / 4 % 4); sample.push_back(i / 16); }
        const std::vector<Drawn> drawn = draw(x, y, sample);
        for (uint a = 0; a <= 6; ++a) {
            std::set<uint> cells;
            for (const Drawn& d : drawn) cells.insert((static_cast<uint>(d.two.y * static_cast<float>(1u << (6 - a))) << a) + static_cast<uint>(d.two.x * static_cast<float>(1u << a)));
            EXPECT_EQ(cells.size(), 64u) << "pixels from (" << left << ", " << top << "), a " << a;
        }
    }
}

class EverySampler : public testing::TestWithParam<bool> {};

/// Numbers lie in [0, 1) and the mean over pixels is 1/2, in each dimension: one number a pixel, so that stratification over
/// samples does not help. Correlations between dimensions, between the two of a pair, and between pixels vanish. Four standard
/// errors of n independent numbers: 4 / sqrt(12 n) and 4 / (12 sqrt n).
TEST_P(EverySampler, IsUniformAndUncorrelatedOverPixels) {
    const Sampler sampler(GetParam());
    constexpr size_t n = 65536;
    std::vector<float> columns[6];
    const DeviceFunction<Drawn> perPixel({.include = "camera/camera.clh", .type = "drawn",
        .body = "uint seed = place_in_sequence(pixel & 255u, pixel >> 8, 3u, 7u, 8u, 0u).seed; result.one = sample_1d(seed, 3u, dimension); result.two = sample_2d(seed, 3u, dimension);",
        .inputs = {"uint pixel", "uint dimension"}, .declarations = "typedef struct { float one; vec2 two; } drawn;",
        .features = GetParam() ? Features::all() : Features()});
    std::vector<uint> pixels(n);
    for (uint i = 0; i < n; ++i) pixels[i] = i;
    for (uint d = 0; d < 2; ++d) {
        const auto drawn = perPixel(pixels, std::vector<uint>(n, 8 + d));
        for (const Drawn& v : drawn) {
            columns[3 * d].push_back(v.one);
            columns[3 * d + 1].push_back(v.two.x);
            columns[3 * d + 2].push_back(v.two.y);
        }
    }
    for (const auto& column : columns) {
        double sum = 0, neighbours = 0;
        for (size_t i = 0; i < n; ++i) {
            ASSERT_GE(column[i], 0);
            ASSERT_LT(column[i], 1);
            sum += column[i];
            if (i + 1 < n) neighbours += (column[i] - 0.5) * (column[i + 1] - 0.5);
        }
        EXPECT_NEAR(sum / n, 0.5, 4 / std::sqrt(12.0 * n));
        EXPECT_NEAR(neighbours / n, 0, 4 / (12 * std::sqrt(1.0 * n)));
    }
    /* sample_1d and the first of sample_2d share their key, and are never used for the same decision: not compared */
    for (const auto& [a, b] : {std::pair{1, 2}, {0, 3}, {1, 4}, {2, 5}, {1, 5}, {2, 4}}) {
        double covariance = 0;
        for (size_t i = 0; i < n; ++i) covariance += (columns[a][i] - 0.5) * (columns[b][i] - 0.5);
        EXPECT_NEAR(covariance / n, 0, 4 / (12 * std::sqrt(1.0 * n))) << a << " " << b;
    }
}

/// Different seeds give different sequences; the same arguments give the same number whatever is computed beside them.
TEST_P(EverySampler, DependsOnItsArgumentsOnly) {
    const Sampler sampler(GetParam());
    const auto whole = sampler.draw(77, 9, 0, 512), part = sampler.draw(77, 9, 100, 37), other = sampler.draw(78, 9, 0, 512), dimension = sampler.draw(77, 10, 0, 512);
    int sameSeed = 0, sameDimension = 0;
    for (size_t i = 0; i < part.size(); ++i) {
        ASSERT_EQ(part[i].one, whole[100 + i].one);
        ASSERT_EQ(part[i].two.x, whole[100 + i].two.x);
        ASSERT_EQ(part[i].two.y, whole[100 + i].two.y);
    }
    for (size_t i = 0; i < whole.size(); ++i) {
        sameSeed += whole[i].one == other[i].one;
        sameDimension += whole[i].one == dimension[i].one;
    }
    EXPECT_LE(sameSeed, 2);
    EXPECT_LE(sameDimension, 2);
}

INSTANTIATE_TEST_SUITE_P(Samplers, EverySampler, testing::Bool(), [](const auto& info) { return info.param ? "sobol" : "independent"; });

/// Without Sobol' the samples of one pixel are independent: chi-square over 16 x 16 cells, and no correlation with the next sample.
TEST(IndependentSampler, SamplesOfAPixelAreIndependent) {
    const Sampler sampler(false);
    for (uint seed : {1u, 0xdeadbeefu, 12345u}) {
        const auto drawn = sampler.draw(seed, 11, 0, 65536);
        std::vector<double> counts(256), expected(256, 256.0);
        double serial = 0;
        for (size_t i = 0; i < drawn.size(); ++i) {
            counts[static_cast<size_t>(drawn[i].two.y * 16) * 16 + static_cast<size_t>(drawn[i].two.x * 16)] += 1;
            if (i + 1 < drawn.size()) serial += (drawn[i].one - 0.5) * (drawn[i + 1].one - 0.5);
        }
        const ChiSquare chi = testChiSquare(counts, expected);
        EXPECT_GT(chi.probability, significance) << chi.describe();
        EXPECT_NEAR(serial / 65536, 0, 4 / (12 * 256.0));
    }
}

/// A stream's numbers are uniform, and streams of neighbouring samples have nothing in common.
TEST(RandomStream, IsUniformAndItsOwn) {
    const DeviceFunction<vec2> function({.include = "random.clh", .type = "vec2",
        .body = "random_stream s = make_stream(seed, sample, 5u); float a = next_random(&s); result = make_vec2(a, next_random(&s));", .inputs = {"uint seed", "uint sample"}});
    std::vector<uint> seed, sample;
    for (uint i = 0; i < 65536; ++i) { seed.push_back(i >> 8); sample.push_back(i & 255); }
    const auto drawn = function(seed, sample);
    std::vector<double> counts(256), expected(256, 256.0);
    for (const vec2& v : drawn) counts[static_cast<size_t>(v.y * 16) * 16 + static_cast<size_t>(v.x * 16)] += 1;
    const ChiSquare chi = testChiSquare(counts, expected);
    EXPECT_GT(chi.probability, significance) << chi.describe();
}

}  // namespace
}  // namespace eikonal
