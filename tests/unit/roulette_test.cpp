// Which rule of Russian roulette is chosen from recorded paths.

#include "render/roulette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace eikonal {
namespace {

/// Paths of ten bounces, whose throughput shrinks by `albedo` at each.
struct Bounces {
    double albedo;                          ///< of each surface
    double first;                           ///< light at the first surface
    std::function<double(int)> light;       ///< at each later one, of throughput 1
};

RecordedPaths record(const Bounces& scene, size_t pixels = 100) {
    RecordedPaths recorded{4, 4, {}};
    std::mt19937 random(3);
    std::exponential_distribution<double> noise;
    for (size_t i = 0; i < pixels * recorded.sets * recorded.samples; ++i) {
        std::vector<PathSegment> path{{static_cast<float>(scene.first), 0, static_cast<float>(scene.albedo)}};
        for (int bounce = 1; bounce <= 10; ++bounce) {
            const double throughput = std::pow(scene.albedo, bounce);
            path.push_back({static_cast<float>(throughput * scene.light(bounce) * noise(random)), 1,
                            bounce < 10 ? static_cast<float>(throughput * scene.albedo) : 0.f});
        }
        recorded.paths.push_back(path);
    }
    return recorded;
}

double product(const RouletteForecast& f) { return f.relativeVariance * f.cost; }

constexpr Roulette pbrt{RouletteRule::throughput, 1, 1}, none{RouletteRule::root, 1, 1000};

// The variance that is forecast is that of estimates of the same paths that are really ended.
TEST(Roulette, ForecastIsWhatHappens) {
    const RecordedPaths recorded = record({.6, 1, [](int) { return 1; }}, 400);
    const RouletteForecast without = forecastRoulette(recorded, none);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> uniform;
    for (const Roulette& rule : {pbrt, Roulette{RouletteRule::root, 1.5, 2}}) {
        double squares = 0, rays = 0, mean = 0;
        const int plays = 20;
        for (const auto& path : recorded.paths) {
            double all = 0;
            for (const PathSegment& s : path) all += s.light;
            mean += all;
            for (int i = 0; i < plays; ++i) {
                double estimate = 0, reached = 1;
                int depth = 0;
                for (const PathSegment& s : path) {
                    estimate += s.light / reached;
                    rays += s.rays / plays;
                    if (depth++ < rule.depth) continue;
                    const double t = s.throughput / reached,
                                 q = std::min(1., rule.scale * (rule.rule == RouletteRule::root ? std::sqrt(t) : t));
                    if (uniform(random) >= q) break;
                    reached *= q;
                }
                squares += (estimate - all) * (estimate - all) / plays;
            }
        }
        const double count = static_cast<double>(recorded.paths.size());
        mean /= count;
        const RouletteForecast found = forecastRoulette(recorded, rule);
        /* Sets are weighted by the mean of the other three, of 12 samples */
        EXPECT_NEAR((found.relativeVariance - without.relativeVariance) / (squares / count / 4 / (mean * mean * 1.01)), 1, .1);
        EXPECT_NEAR(found.cost, 1 + rays / count, .02 * found.cost);
    }
}

// Nothing but the light of the first surface, and noise elsewhere that is a thousandth: rays on are not worth their time.
TEST(Roulette, EndsPathsThatBringNothing) {
    const RecordedPaths recorded = record({.5, 1, [](int bounce) { return bounce == 1 ? 1 : 1e-3; }});
    const Roulette chosen = chooseRoulette(recorded);
    EXPECT_LT(forecastRoulette(recorded, chosen).cost, .6 * forecastRoulette(recorded, none).cost);
    EXPECT_LE(product(forecastRoulette(recorded, chosen)), product(forecastRoulette(recorded, {})));
}

// All light is at the end of a long way through the dark.
TEST(Roulette, FollowsPathsToFarLight) {
    const RecordedPaths recorded = record({.5, .001, [](int bounce) { return bounce == 10 ? 1e3 : 0; }});
    const Roulette chosen = chooseRoulette(recorded);
    EXPECT_LT(product(forecastRoulette(recorded, chosen)), .5 * product(forecastRoulette(recorded, {})));
    EXPECT_LT(product(forecastRoulette(recorded, chosen)), .1 * product(forecastRoulette(recorded, pbrt)));
}

TEST(Roulette, KeepsTheDefaultWithoutLight) {
    const RecordedPaths recorded = record({.5, 0, [](int) { return 0; }});
    const Roulette chosen = chooseRoulette(recorded), usual;
    EXPECT_EQ(chosen.rule, usual.rule);
    EXPECT_EQ(chosen.scale, usual.scale);
    EXPECT_EQ(chosen.depth, usual.depth);
}

}  // namespace
}  // namespace eikonal
