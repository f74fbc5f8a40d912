// Which light is taken, by an alias table (light_tree_test.cpp: by a tree).

#include "light_sampling.h"
#include "pack/alias_table.h"
#include "random_inputs.h"
#include "statistics.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>
#include <vector>

namespace eikonal {
namespace {

/// Nothing but a table that chooses lights with these weights.
PackedScene sceneChoosingBy(const std::vector<double>& weights) {
    PackedScene scene;
    scene.tables.light_aliases = makeAliasTable(weights);
    scene.tables.frame.resize(1);
    return scene;
}

/// Lights are taken as often as their probability; a sample's density has the probability of its light as a factor.
TEST(LightSampler, TakesLightsByTheirProbability) {
    const std::vector<double> weights{1, 5, 0.01, 3, 0, 2, 0.5, 7};
    PackedScene scene = sceneChoosingBy(weights);
    for (size_t i = 0; i < weights.size(); ++i) {
        light l = newLight(kind_point_light);
        l.p = {static_cast<float>(i), 0, 0};
        l.pmf = scene.tables.light_aliases[i].pmf;
        scene.tables.lights.push_back(l);
    }
    Random random(49);
    const auto u = generate(100000, [&] { return random.unit(); });
    const auto results = sample(scene, {0.3f, 1, 1}, u, std::vector<vec2>(u.size(), {0.5f, 0.5f}));
    std::vector<double> counts(weights.size()), expected;
    for (double w : weights) expected.push_back(w / 18.51 * static_cast<double>(u.size()));
    for (const LightResult& r : results) {
        ASSERT_LT(r.index, weights.size());
        counts[r.index] += 1;
        ASSERT_NEAR(r.pdf, weights[r.index] / 18.51, 1e-6);
    }
    const ChiSquare chi = testChiSquare(counts, expected);
    EXPECT_GT(chi.probability, significance) << chi.describe();
    EXPECT_EQ(counts[4], 0);
}

/// What is left over of the number that chose is uniform again, whatever was chosen: it places a point in a texel.
TEST(LightSampler, LeavesAUniformRest) {
    struct Chosen { int i; float rest; };
    const PackedScene scene = sceneChoosingBy({0.3, 4, 1, 0.7});
    const DeviceScene onDevice(testContext(), scene);
    const DeviceFunction<Chosen> function({.include = "light/light.clh",
                                           .type = "alias_sample",
                                           .body = "result = sample_alias(light_aliases, 4, u);",
                                           .inputs = {"float u"},
                                           .tables = "LIGHT_TABLES(TABLE)"});
    Random random(50);
    const auto u = generate(100000, [&] { return random.unit(); });
    std::vector<double> counts(4 * 16), expected;
    for (double w : {0.3, 4.0, 1.0, 0.7}) expected.insert(expected.end(), 16, w / 6 / 16 * 100000);
    for (const Chosen& c : function.with(onDevice, u)) {
        ASSERT_GE(c.rest, 0);
        ASSERT_LT(c.rest, 1);
        counts[static_cast<size_t>(c.i) * 16 + static_cast<size_t>(c.rest * 16)] += 1;
    }
    const ChiSquare chi = testChiSquare(counts, expected);
    EXPECT_GT(chi.probability, significance) << chi.describe();
}

/// Of 64 points of a low-discrepancy sequence, four lights that are equally likely get 16 each, and what is left of the first number makes
/// of these again points with one in each of the 16 elementary intervals of every shape. Points that a number of its own had dealt to the
/// lights would not be so.
TEST(LightSampler, LeavesStrataToEachLight) {
    struct Placed { int i; vec2 at; };
    const PackedScene scene = sceneChoosingBy({1, 1, 1, 1});
    const DeviceScene onDevice(testContext(), scene);
    const DeviceFunction<Placed> function(
        {.include = "light/light.clh",
         .type = "placed",
         .body = "light_tables tables = BIND_LIGHTS; vec2 u = sample_2d(seed, sample, 9u); alias_sample lot = sample_light_index(tables, "
                 "4u, u.x); result.i = lot.i; result.at = make_vec2(lot.rest, u.y);",
         .inputs = {"uint seed", "uint sample"},
         .declarations = "#include \"math/random.clh\"\ntypedef struct { int i; vec2 at; } placed;",
         .tables = "LIGHT_TABLES(TABLE)",
         .features = Features().require(Feature::SOBOL)});
    std::vector<uint> sample(64);
    std::iota(sample.begin(), sample.end(), 0u);
    for (uint seed = 1; seed <= 8; ++seed) {
        const std::vector<Placed> placed = function.with(onDevice, std::vector<uint>(64, seed), sample);
        for (uint a = 0; a <= 4; ++a) {
            std::set<uint> cells;
            for (const Placed& p : placed) {
                const uint x = static_cast<uint>(p.at.x * static_cast<float>(1u << a)),
                           y = static_cast<uint>(p.at.y * static_cast<float>(1u << (4 - a)));
                cells.insert(16 * static_cast<uint>(p.i) + (y << a) + x);
            }
            EXPECT_EQ(cells.size(), 64u) << "seed " << seed << " a " << a;
        }
    }
}

}  // namespace
}  // namespace eikonal
