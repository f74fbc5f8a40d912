// Every medium of the list MEDIA_KINDS: where a path's way ends, what is left of it, and what shines on it, against integrals along the way
// of what the medium says of itself.

#include "medium_walk.h"
#include "kinds/medium_kind.h"
#include "random_inputs.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace eikonal {
namespace {

class EveryMedium : public testing::TestWithParam<std::string> {
protected:
    static PackedScene scene() { return sceneWith(GetParam(), parametersOf(GetParam())); }
};

TEST_P(EveryMedium, HasAnExampleHere) { EXPECT_NE(parametersOf(GetParam()), ""); }

/// Ratio tracking, and whatever else shadow rays do, has the mean exp(-tau) in each channel.
TEST_P(EveryMedium, ShadowRaysLoseWhatTheyShould) {
    const PackedScene packed = scene();
    const DeviceScene onDevice(testContext(), packed);
    for (const MediumRay& ray : rays) {
        const Channels tau = channelsOf(
            integrate().with(onDevice, std::vector<vec3>{ray.o}, std::vector<vec3>{ray.d}, std::vector<float>{wayLength})[0].tau);
        std::array<Accumulator, 3> T;
        for (const Walked& w : walk(attenuate(), onDevice, ray, wayLength, 30000)) {
            const double density = mean(w.r_u) + mean(w.r_l);
            for (int c = 0; c < 3; ++c) T[c].add(w.beta.r == 0 && w.beta.g == 0 && w.beta.b == 0 ? 0 : channelsOf(w.beta)[c] / density);
        }
        EXPECT_GT(tau[1], 0.3) << "the ray passes the medium by";
        for (int c = 0; c < 3; ++c) expectMean(T[c], std::exp(-tau[c]), fmt::format("channel {}, tau {}", c, tau[c]));
    }
}

/// Where the way of a path ends, and how: distances in bins of equal length, for each hero.
TEST_P(EveryMedium, PathsEndWhereTheyShould) {
    const PackedScene packed = scene();
    const DeviceScene onDevice(testContext(), packed);
    constexpr size_t bins = 24, n = 20000;
    for (const MediumRay& ray : rays) {
        std::vector<float> ends(bins);
        for (size_t i = 0; i < bins; ++i) ends[i] = wayLength * static_cast<float>(i + 1) / bins;
        const auto integrals = integrate().with(onDevice, std::vector<vec3>(bins, ray.o), std::vector<vec3>(bins, ray.d), ends);
        for (int hero = 0; hero < 3; ++hero) {
            std::vector<double> expected, counts(2 * bins + 1);
            for (const auto of : {&Integrals::absorbed, &Integrals::scattered})
                for (size_t i = 0; i < bins; ++i)
                    expected.push_back(n * (channelsOf(integrals[i].*of)[hero] - (i ? channelsOf(integrals[i - 1].*of)[hero] : 0)));
            expected.push_back(n * std::exp(-channelsOf(integrals.back().tau)[hero]));
            for (const Walked& w : walk(track(), onDevice, ray, wayLength, n, hero)) {
                const size_t bin = std::min(static_cast<size_t>(w.t / wayLength * bins), bins - 1);
                ++counts[w.end == 0 ? 2 * bins : bin + (w.end == 2 ? bins : 0)];
            }
            const ChiSquare test = testChiSquare(counts, expected);
            EXPECT_GT(test.probability, significance) << "hero " << hero << ": " << test.describe();
        }
    }
}

/// Whatever the hero: passing, scattering and emission have the right means in all channels.
TEST_P(EveryMedium, WeightsAreRightInEveryChannel) {
    const PackedScene packed = scene();
    const DeviceScene onDevice(testContext(), packed);
    for (const MediumRay& ray : rays) expectWeights(onDevice, ray);
}

/// No point of the medium exceeds the bound of its cell.
TEST_P(EveryMedium, IsBounded) {
    const PackedScene packed = scene();
    if (kindOf(packed.tables.media[0]).variation == MediumVariation::HOMOGENEOUS) GTEST_SKIP() << "it needs no bounds";
    struct Both { spectrum sigma_t, bound; };
    const DeviceFunction<Both> function({.include = "medium/medium.clh",
                                         .type = "both",
                                         .body = R"(
        medium_tables medium_set = BIND_MEDIA;
        color_tables color_set = BIND_COLORS;
        sampled_wavelengths colors = path_wavelengths(color_set, 0u, 0u);
        medium m = medium_set.media[0];
        medium_spectra c = eval_medium(colors, m);
        medium_spectra at = eval_medium_point(medium_set, colors, m, c, p);
        result.sigma_t = add(at.sigma_a, at.sigma_s);
        result.bound = mul(bounded_extinction(m, c), current_majorant(medium_set, m, start_majorant(m, p, make_vec3(0.0f, 0.0f, 1.0f),
            1.0f)));)",
                                         .inputs = {"vec3 p"},
                                         .declarations = "typedef struct { spectrum sigma_t, bound; } both;",
                                         .tables = "MEDIUM_TABLES(TABLE) COLOR_TABLES(TABLE)"});
    const DeviceScene onDevice(testContext(), packed);
    Random random(7);
    std::vector<vec3> points;
    for (int i = 0; i < 50000; ++i) points.push_back({random.unit(), random.unit(), random.unit()});
    int full = 0;
    for (const Both& both : function.with(onDevice, points))
        for (int c = 0; c < 3; ++c) {
            ASSERT_LE(channelsOf(both.sigma_t)[c], channelsOf(both.bound)[c] * 1.00001);
            full += channelsOf(both.sigma_t)[c] > 0.5 * channelsOf(both.bound)[c];
        }
    EXPECT_GT(full, 1000) << "bounds are loose";
}

std::vector<std::string> kinds() {
    std::vector<std::string> names;
    for (const MediumKind& e : mediumKindList()) names.push_back(e.name);
    return names;
}
INSTANTIATE_TEST_SUITE_P(Media, EveryMedium, testing::ValuesIn(kinds()), [](const auto& info) { return info.param; });

/// Optical depths from nothing to beyond a million: nothing overflows, and shares are what Beer's law says.
TEST(ExtremeMedia, EveryOpticalDepthIsFiniteAndRight) {
    for (const std::string kind : {"homogeneous", "uniformgrid"})
        for (const double depth : {0., 1e-12, 1e-3, 1., 20., 1e3, 1e6, 1e9}) {
            const PackedScene packed = sceneWith(
                kind,
                fmt::format("\"rgb sigma_a\" [ {0} 0 {1} ] \"rgb sigma_s\" [ {0} {0} 0 ] ", depth, depth * 1e-3) +
                    (depth > 0 ? "\"rgb Le\" [ 1 1 1 ] " : "") +
                    (kind == "homogeneous"
                         ? ""
                         : "\"integer nx\" 2 \"point3 p0\" [ -1 -1 -1 ] \"point3 p1\" [ 1 1 1 ] \"float density\" [ 1 1 ]"));
            const DeviceScene onDevice(testContext(), packed);
            const MediumRay ray{{-0.5f, 0, 0}, {1, 0, 0}};
            std::array<Accumulator, 3> T, passed;
            for (const auto* function : {&track(), &attenuate()})
                for (const Walked& w : walk(*function, onDevice, ray, 1, 3000)) {
                    ASSERT_TRUE(finite(w.beta) && finite(w.r_u) && finite(w.r_l) && finite(w.L)) << kind << " of depth " << depth;
                    const double density = mean(w.r_u) + (function == &attenuate() ? mean(w.r_l) : 0);
                    for (int c = 0; c < 3; ++c)
                        (function == &attenuate() ? T : passed)[c].add(w.end != 0 || mean(w.beta) == 0 ? 0
                                                                                                       : channelsOf(w.beta)[c] / density);
                }
            const Channels sigma{2 * depth, depth, depth * 1e-3};
            for (int c = 0; c < 3; ++c)
                for (const auto* estimates : {&T, &passed}) {
                    const Estimate e = (*estimates)[c].estimate();
                    EXPECT_NEAR(e.mean, std::exp(-sigma[c]), 4.5 * e.error + 1e-4) << kind << " of depth " << depth << " in channel " << c;
                }
        }
}

}  // namespace
}  // namespace eikonal
