// The environment guide on the device: samples leave through the openings as a map says, and points find the map that was learnt for them.

#include "device_function.h"
#include "pack/environment_guide.h"
#include "pack/guide_map.h"
#include "pack/guide_openings.h"
#include "random_inputs.h"
#include "statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace eikonal {
namespace {

struct GuidedSample { vec3 wi; float pdf, pdfOfDirection; uint opening; };

/// A box from (-2, 0, 0) to (3, 1, 10) with openings on three of its sides, and map 0 for all of them alike.
PackedScene guidedScene() {
    PackedScene scene;
    scene.tables.frame.resize(1);
    packUnlearnedGuide(scene.tables);
    packGuideBox(scene.tables, std::vector<vec3>{{-2, 0, 0}, {3, 1, 10}});
    std::vector<uint> exits;
    for (const uint side : {0u, 3u, 5u})
        for (uint y = 10; y < 30; ++y)
            for (uint x = 20 + side; x < 50; ++x) exits.push_back((side * GUIDE_TEXELS + y) * GUIDE_TEXELS + x);
    packGuideOpenings(scene.tables, exits);
    std::vector<double> weights;
    for (int i = 0; i < GUIDE_OPENINGS; ++i) weights.push_back(1 + i % 5);
    writeGuideMap(scene.tables.guide_sums, weights);
    return scene;
}

const std::string guidedSample = "typedef struct { vec3 wi; float pdf, pdf_of_direction; uint opening; } guided_sample;";

std::vector<GuidedSample> sampleGuide(const PackedScene& scene, vec3 p, const std::vector<vec2>& u) {
    const DeviceFunction<GuidedSample> function({.include = "light/light.clh",
                                                 .type = "guided_sample",
                                                 .body = R"(
        light_tables tables = BIND_LIGHTS;
        light_sample s = sample_guided_environment(tables, uniform_spectrum(1.0f), 0u, p, u);
        box_exit out = exit_guide_box(tables.guide_box, p, s.wi);
        result.wi = s.wi; result.pdf = s.pdf; result.pdf_of_direction = pdf_guided_environment(tables, 0u, p, s.wi);
        result.opening = out.texel == NONE ? NONE : tables.guide_texels[out.texel];)",
                                                 .inputs = {"vec3 p", "vec2 u"},
                                                 .declarations = guidedSample,
                                                 .tables = "LIGHT_TABLES(TABLE)",
                                                 .features = Features::all()});
    const DeviceScene onDevice(testContext(), scene);
    return function.with(onDevice, std::vector<vec3>(u.size(), p), u);
}

// From inside of the box, directions leave through the openings as often as their probability; the density of a direction is that of its
// sample, but for rounding at the edges of openings.
TEST(EnvironmentGuide, SamplesFollowTheMap) {
    const PackedScene scene = guidedScene();
    Random random(71);
    const auto u = generate(65536, [&] { return random.square(); });
    std::vector<double> expected;
    for (size_t i = 0; i < GUIDE_OPENINGS; ++i)
        expected.push_back(openingProbability(scene.tables.guide_sums, i) * static_cast<double>(u.size()));
    for (const vec3& p : {vec3{0, 0.5f, 5}, vec3{-1.99f, 0.01f, 9.9f}}) {
        std::vector<double> counts(GUIDE_OPENINGS, 0);
        int apart = 0;
        for (const GuidedSample& s : sampleGuide(scene, p, u)) {
            ASSERT_GT(s.pdf, 0);
            apart += std::abs(s.pdf - s.pdfOfDirection) > 1e-3f * s.pdf;
            if (s.opening != NONE) counts[s.opening] += 1;
        }
        EXPECT_LT(apart, 100);
        const ChiSquare chi = testChiSquare(counts, expected);
        EXPECT_GT(chi.probability, significance) << chi.describe();
    }
}

// Over all directions, the density integrates to the probability of the openings that are a way out: all of them from inside of the box,
// and from outside those on the far sides.
TEST(EnvironmentGuide, DensityIntegratesToOne) {
    const PackedScene scene = guidedScene();
    Random random(73);
    const auto d = generate(1 << 20, [&] { return random.direction(); });
    const DeviceFunction<float> function({.include = "light/light.clh",
                                          .type = "float",
                                          .body = "light_tables tables = BIND_LIGHTS; result = pdf_guided_environment(tables, 0u, p, d);",
                                          .inputs = {"vec3 p", "vec3 d"},
                                          .tables = "LIGHT_TABLES(TABLE)",
                                          .features = Features::all()});
    const DeviceScene onDevice(testContext(), scene);
    const auto integral = [&](vec3 p) {
        double sum = 0;
        for (const float pdf : function.with(onDevice, std::vector<vec3>(d.size(), p), d)) sum += pdf;
        return 4 * M_PI * sum / static_cast<double>(d.size());
    };
    EXPECT_NEAR(integral({0.5f, 0.5f, 5}), 1, 0.02);
    double far = 0;
    for (size_t i = 0; i < GUIDE_OPENINGS; ++i)
        if (scene.tables.guide_openings[i].n.x == 0) far += openingProbability(scene.tables.guide_sums, i);
    EXPECT_GT(far, 0.3);
    EXPECT_LT(far, 0.9);
    EXPECT_NEAR(integral({-4, 0.5f, 5}), far, 0.05);
}

// Host and device cut space the same way: each point that a map was learnt from finds a learnt map.
TEST(EnvironmentGuide, PointsFindTheirMaps) {
    PackedScene scene = guidedScene();
    Random random(72);
    const auto points = generate(4096, [&] { return vec3{random.between(-2, 3), random.between(0, 1), random.logBetween(0.01f, 10)}; });
    const auto normals = generate(4096, [&] { return random.direction(); });
    learnGuide(scene.tables, points, normals, {size_t{1} << 24, true},
               {[](const LightTables&, size_t count) { return std::vector<uint>(count, 7u); },
                [](const LightTables&, const GuideRepresentatives& from) {
                    return std::vector<float>(from.maps * 2 * GUIDE_OPENINGS, 1.0f);
                }});
    const DeviceFunction<uint> function({.include = "light/guide_place.clh",
                                         .type = "uint",
                                         .body = "light_tables tables = BIND_LIGHTS; result = guide_map(tables, p, n);",
                                         .inputs = {"vec3 p", "vec3 n"},
                                         .tables = "LIGHT_TABLES(TABLE)",
                                         .features = Features::all()});
    const DeviceScene onDevice(testContext(), scene);
    for (const uint map : function.with(onDevice, points, normals)) ASSERT_GE(map, 1u);
    for (const uint map : function.with(onDevice, points, std::vector<vec3>(points.size(), vec3{0, 0, 0})))
        ASSERT_GE(map, 1u);
}

}  // namespace
}  // namespace eikonal
