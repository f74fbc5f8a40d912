// The random numbers: functions of (pixel, sample, dimension, seed) only, stratified with the Sobol' sampler, independent without.

#include "device_function.h"
#include "random_inputs.h"
#include "statistics.h"

#include "eikonal/dimensions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace eikonal {
namespace {

struct Drawn { float one; vec2 two; };

enum class Kind { independent, padded, joint };
std::string nameOf(Kind kind) { return kind == Kind::independent ? "independent" : kind == Kind::padded ? "paddedsobol" : "sobol"; }
Features featuresOf(Kind kind) {
    Features features;
    if (kind != Kind::independent) features.require(Feature::SOBOL);
    if (kind == Kind::joint) features.require(Feature::JOINT_PAIRS);
    return features;
}

class Sampler {
public:
    explicit Sampler(Kind kind)
        : function_({.include = "math/random.clh",
                     .type = "drawn",
                     .body = "result.one = sample_1d(seed, sample, dimension); result.two = sample_2d(seed, sample, dimension);",
                     .inputs = {"uint seed", "uint sample", "uint dimension"},
                     .declarations = "typedef struct { float one; vec2 two; } drawn;",
                     .features = featuresOf(kind)}) {}
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
class SobolSampler : public testing::TestWithParam<Kind> {};
INSTANTIATE_TEST_SUITE_P(Samplers, SobolSampler, testing::Values(Kind::padded, Kind::joint),
                         [](const auto& info) { return nameOf(info.param); });

TEST_P(SobolSampler, StratifiesEveryBlockInEveryDimension) {
    const Sampler sampler(GetParam());
    Random random(21);
    for (int test = 0; test < 24; ++test) {
        const uint seed = random.word(), dimension = test < 8 ? static_cast<uint>(test) : 8 + random.below(16 * 40);
        const auto all = sampler.draw(seed, dimension, 0, 4096);
        for (uint k = 0; k <= 12; k += 3)
            for (uint block = 0; block + (1u << k) <= 4096 && block < 8u << k; block += 1u << k) {
                const uint n = 1u << k;
                std::vector<int> strata(n);
                for (uint i = block; i < block + n; ++i) ++strata[static_cast<size_t>(all[i].one * static_cast<float>(n))];
                ASSERT_EQ(std::count(strata.begin(), strata.end(), 1), n)
                    << "one dimension, seed " << seed << " dimension " << dimension << " block " << block << " of " << n;
                for (uint a = 0; a <= k; ++a) {
                    std::vector<int> cells(n);
                    for (uint i = block; i < block + n; ++i) {
                        const uint x = static_cast<uint>(all[i].two.x * static_cast<float>(1u << a)),
                                   y = static_cast<uint>(all[i].two.y * static_cast<float>(1u << (k - a)));
                        ++cells[(y << a) + x];
                    }
                    ASSERT_EQ(std::count(cells.begin(), cells.end(), 1), n)
                        << "seed " << seed << " dimension " << dimension << " block " << block << " of " << n << " a " << a;
                }
            }
    }
}

/// The samples of a block of pixels are as well spread as those of one pixel: 4 x 4 pixels with 4 samples each have one sample in each of
/// the 64 elementary intervals of every shape, wherever an aligned block lies; and so in a tile and beyond it.
TEST(BlueNoise, SpreadsTheSamplesOfBlocksOfPixels) {
    const DeviceFunction<Drawn> draw({.include = "camera/camera.clh",
                                      .type = "drawn",
                                      .body = "sequence_place at = place_in_sequence(x, y, sample, 5u, 2u, 3u); result.one = "
                                              "sample_1d(at.seed, at.index, 9u); result.two = sample_2d(at.seed, at.index, 9u);",
                                      .inputs = {"uint x", "uint y", "uint sample"},
                                      .declarations = "typedef struct { float one; vec2 two; } drawn;",
                                      .features = Features::all()});
    for (const auto& [left, top] : {std::pair{0u, 0u}, {4u, 0u}, {4u, 4u}, {8u, 12u}, {1000u, 496u}}) {
        std::vector<uint> x, y, sample;
        for (uint i = 0; i < 64; ++i) { x.push_back(left + i % 4); y.push_back(top + i / 4 % 4); sample.push_back(i / 16); }
        const std::vector<Drawn> drawn = draw(x, y, sample);
        for (uint a = 0; a <= 6; ++a) {
            std::set<uint> cells;
            for (const Drawn& d : drawn)
                cells.insert((static_cast<uint>(d.two.y * static_cast<float>(1u << (6 - a))) << a) +
                             static_cast<uint>(d.two.x * static_cast<float>(1u << a)));
            EXPECT_EQ(cells.size(), 64u) << "pixels from (" << left << ", " << top << "), a " << a;
        }
    }
}

/// Pairs of numbers of several decisions.
struct Projection { std::string name; std::vector<uint> dimensions; };

/// Calls f with the bits of each coordinate, for all ways to share `bits` among them.
template <class F> void forEachShape(std::vector<uint>& shape, size_t coordinate, uint bits, const F& f) {
    if (coordinate + 1 == shape.size()) {
        shape[coordinate] = bits;
        f(shape);
        return;
    }
    for (uint b = 0; b <= bits; ++b) {
        shape[coordinate] = b;
        forEachShape(shape, coordinate + 1, bits - b, f);
    }
}

/// How many shapes of boxes of volume 2^(t - k), whose sides are powers of 2^-digit, do not all hold 2^t of the 2^k points from `first` on:
/// none is the definition of a net in base 2^digit.
size_t unevenShapes(const std::vector<std::vector<float>>& coordinates, uint first, uint k, uint t, uint digit = 1) {
    size_t uneven = 0;
    std::vector<uint> shape(coordinates.size());
    forEachShape(shape, 0, (k - t) / digit, [&](const std::vector<uint>& digits) {
        std::vector<uint> counts(1u << (k - t));
        for (uint i = first; i < first + (1u << k); ++i) {
            uint box = 0;
            for (size_t c = 0; c < digits.size(); ++c) {
                const uint bits = digit * digits[c];
                box = (box << bits) | static_cast<uint>(coordinates[c][i] * static_cast<float>(1u << bits));
            }
            ++counts[box];
        }
        uneven += static_cast<size_t>(std::count(counts.begin(), counts.end(), 1u << t)) != counts.size();
    });
    return uneven;
}

std::vector<std::vector<float>> coordinatesOf(const Sampler& sampler, const Projection& p, uint seed, uint count) {
    std::vector<std::vector<float>> coordinates;
    for (uint dimension : p.dimensions) {
        std::vector<float> x, y;
        for (const Drawn& d : sampler.draw(seed, dimension, 0, count)) { x.push_back(d.two.x); y.push_back(d.two.y); }
        coordinates.insert(coordinates.end(), {x, y});
    }
    return coordinates;
}

uint atVertex(uint depth, uint decision) { return camera_dimensions + depth * bounce_dimensions + decision; }

/// The pixel's pair and either pair of the first vertex are a (0, 4)-sequence in base 4: of every aligned block of 4^k samples, exactly one
/// lies in each box whose sides are powers of 1/4 and whose volume is 4^-k. No four coordinates can do better.
TEST(JointPairs, OfPixelAndFirstVertexAreASequenceInBase4) {
    const Sampler joint(Kind::joint), padded(Kind::padded);
    for (uint decision : {dimension_light_point, dimension_direction}) {
        const Projection p{"", {dimension_pixel, atVertex(0, decision)}};
        size_t unevenPadded = 0;
        for (uint seed : {3u, 0x9e3779b9u}) {
            const auto points = coordinatesOf(joint, p, seed, 8192), others = coordinatesOf(padded, p, seed, 8192);
            for (uint k = 2; k <= 12; k += 2)
                for (uint first : {0u, 1u << k, 8192u - (1u << k)}) {
                    EXPECT_EQ(unevenShapes(points, first, k, 0, 2), 0u)
                        << "decision " << decision << ", seed " << seed << ", samples " << first << " to " << first + (1u << k);
                    unevenPadded += unevenShapes(others, first, k, 0, 2);
                }
        }
        EXPECT_GT(unevenPadded, 0u) << decision;
    }
}

/// What meets in an integrand is spread together: every block of 16, 64 and 256 samples of a pixel is a (2, 4)-, (3, 6)- and (3, 8)-net in
/// the pairs of neighbours on a path, of four numbers; of six, (2, 4)-, (3, 6)- and (4, 8)-nets. joint_pairs_search finds these t by the
/// rank of the pairs' matrices; here boxes are counted. Padded pairs are no such nets.
TEST(JointPairs, AreNetsOfSmallT) {
    const Sampler joint(Kind::joint), padded(Kind::padded);
    const std::vector<Projection> projections = {
        {"pixel, light", {dimension_pixel, atVertex(0, dimension_light_point)}},
        {"pixel, direction", {dimension_pixel, atVertex(0, dimension_direction)}},
        {"lens, light", {dimension_lens, atVertex(0, dimension_light_point)}},
        {"pixel, lens", {dimension_pixel, dimension_lens}},
        {"direction, next light", {atVertex(0, dimension_direction), atVertex(1, dimension_light_point)}},
        {"direction, next direction", {atVertex(0, dimension_direction), atVertex(1, dimension_direction)}},
        {"second direction, next light", {atVertex(1, dimension_direction), atVertex(2, dimension_light_point)}},
        {"pixel, direction, next light", {dimension_pixel, atVertex(0, dimension_direction), atVertex(1, dimension_light_point)}},
        {"pixel, direction, next direction", {dimension_pixel, atVertex(0, dimension_direction), atVertex(1, dimension_direction)}}};
    for (const Projection& p : projections) {
        size_t unevenPadded = 0;
        for (uint seed : {3u, 0x9e3779b9u, 0xfffffff1u}) {
            const auto points = coordinatesOf(joint, p, seed, 512), others = coordinatesOf(padded, p, seed, 512);
            for (const auto& [k, t] : {std::pair{4u, 2u}, {6u, 3u}, {8u, p.dimensions.size() == 2 ? 3u : 4u}})
                for (uint first : {0u, 1u << k, 512u - (1u << k)}) {
                    EXPECT_EQ(unevenShapes(points, first, k, t), 0u)
                        << p.name << ", seed " << seed << ", samples " << first << " to " << first + (1u << k);
                    unevenPadded += unevenShapes(others, first, k, t);
                }
        }
        EXPECT_GT(unevenPadded, 0u) << p.name;
    }
}

class EverySampler : public testing::TestWithParam<Kind> {};

/// Numbers lie in [0, 1) and the mean over pixels is 1/2, in each dimension: one number a pixel, so that stratification over
/// samples does not help. Correlations between dimensions, between the two of a pair, and between pixels vanish. Four standard
/// errors of n independent numbers: 4 / sqrt(12 n) and 4 / (12 sqrt n).
TEST_P(EverySampler, IsUniformAndUncorrelatedOverPixels) {
    const Sampler sampler(GetParam());
    constexpr size_t n = 65536;
    const uint dimensions[] = {dimension_pixel, atVertex(0, dimension_light), atVertex(0, dimension_light_point),
                               atVertex(0, dimension_direction)};
    std::vector<float> columns[3 * std::size(dimensions)];
    const DeviceFunction<Drawn> perPixel(
        {.include = "camera/camera.clh",
         .type = "drawn",
         .body = "uint seed = place_in_sequence(pixel & 255u, pixel >> 8, 3u, 7u, 8u, 0u).seed; result.one = sample_1d(seed, 3u, "
                 "dimension); result.two = sample_2d(seed, 3u, dimension);",
         .inputs = {"uint pixel", "uint dimension"},
         .declarations = "typedef struct { float one; vec2 two; } drawn;",
         .features = featuresOf(GetParam())});
    std::vector<uint> pixels(n);
    for (uint i = 0; i < n; ++i) pixels[i] = i;
    for (size_t d = 0; d < std::size(dimensions); ++d) {
        const auto drawn = perPixel(pixels, std::vector<uint>(n, dimensions[d]));
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
    /* sample_1d and sample_2d of one dimension share their key, and are never used for the same decision: not compared */
    for (size_t a = 0; a < std::size(columns); ++a) for (size_t b = a + 1; b < std::size(columns); ++b) {
        if (a % 3 == 0 && b / 3 == a / 3) continue;
        double covariance = 0;
        for (size_t i = 0; i < n; ++i) covariance += (columns[a][i] - 0.5) * (columns[b][i] - 0.5);
        EXPECT_NEAR(covariance / n, 0, 4 / (12 * std::sqrt(1.0 * n))) << a << " " << b;
    }
}

/// Different seeds give different sequences; the same arguments give the same number whatever is computed beside them.
TEST_P(EverySampler, DependsOnItsArgumentsOnly) {
    const Sampler sampler(GetParam());
    const auto whole = sampler.draw(77, 9, 0, 512), part = sampler.draw(77, 9, 100, 37), other = sampler.draw(78, 9, 0, 512),
               dimension = sampler.draw(77, 10, 0, 512);
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

INSTANTIATE_TEST_SUITE_P(Samplers, EverySampler, testing::Values(Kind::independent, Kind::padded, Kind::joint),
                         [](const auto& info) { return nameOf(info.param); });

/// Without Sobol' the samples of one pixel are independent: chi-square over 16 x 16 cells, and no correlation with the next sample.
TEST(IndependentSampler, SamplesOfAPixelAreIndependent) {
    const Sampler sampler(Kind::independent);
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
    const DeviceFunction<vec2> function(
        {.include = "math/random.clh",
         .type = "vec2",
         .body = "random_stream s = make_stream(seed, sample, 5u); float a = next_random(&s); result = make_vec2(a, next_random(&s));",
         .inputs = {"uint seed", "uint sample"}});
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
