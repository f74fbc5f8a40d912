// The environment guide on the device: samples fall as a map says, and points find the map that was learnt for them.

#include "device_function.h"
#include "pack/alias_table.h"
#include "pack/environment_guide.h"
#include "random_inputs.h"
#include "image/equal_area.h"
#include "statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace eikonal {
namespace {

constexpr size_t bins = GUIDE_SIDE * GUIDE_SIDE;

struct GuidedSample { vec3 wi; float pdf, pdfOfDirection; };

PackedScene guidedScene() {
    PackedScene scene;
    scene.tables.frame.resize(1);
    packUnlearnedGuide(scene.tables);
    return scene;
}

std::vector<GuidedSample> sampleMap(const PackedScene& scene, uint map, const std::vector<vec2>& u) {
    const DeviceFunction<GuidedSample> function({.include = "light/light.clh",
                                                 .type = "guided_sample",
                                                 .body = R"(
        light_tables tables = BIND_LIGHTS;
        light_sample s = sample_guided_environment(tables, uniform_spectrum(1.0f), map, u);
        result.wi = s.wi; result.pdf = s.pdf; result.pdf_of_direction = pdf_guided_environment(tables, map, s.wi);)",
                                                 .inputs = {"uint map", "vec2 u"},
                                                 .declarations = "typedef struct { vec3 wi; float pdf, pdf_of_direction; } guided_sample;",
                                                 .tables = "LIGHT_TABLES(TABLE)",
                                                 .features = Features::all()});
    const DeviceScene onDevice(testContext(), scene);
    return function.with(onDevice, std::vector<uint>(u.size(), map), u);
}

// Directions fall into the bins as often as their probability; the density of a direction is that of its sample, but for rounding at the
// edges of bins.
TEST(EnvironmentGuide, SamplesFollowTheMap) {
    const PackedScene scene = guidedScene();
    Random random(71);
    const auto u = generate(65536, [&] { return random.square(); });
    for (const uint map : {0u, 4u, static_cast<uint>(GUIDE_ALL_DIRECTIONS)}) {
        const alias_entry* entries = scene.tables.guide_aliases.data() + size_t{map} * GUIDE_MAP_ENTRIES;
        std::vector<double> counts(bins, 0), expected;
        for (size_t bin = 0; bin < bins; ++bin)
            expected.push_back(double{entries[bin / GUIDE_SIDE].pmf} * entries[GUIDE_SIDE + bin].pmf * static_cast<double>(u.size()));
        int apart = 0;
        for (const GuidedSample& s : sampleMap(scene, map, u)) {
            const glm::dvec2 at = squareFromDirection({s.wi.x, s.wi.y, s.wi.z});
            const auto index = [](double x) { return std::min(static_cast<size_t>(x * GUIDE_SIDE), size_t{GUIDE_SIDE - 1}); };
            const size_t bin = index(at.y) * GUIDE_SIDE + index(at.x);
            counts[bin] += 1;
            ASSERT_GT(s.pdf, 0);
            apart += std::abs(s.pdf - s.pdfOfDirection) > 1e-5f * s.pdf;
        }
        EXPECT_LT(apart, 40);
        const ChiSquare chi = testChiSquare(counts, expected);
        EXPECT_GT(chi.probability, significance) << map << ": " << chi.describe();
    }
}

// Host and device cut space the same way: each point that a map was learnt from finds a learnt map.
TEST(EnvironmentGuide, PointsFindTheirMaps) {
    PackedScene scene = guidedScene();
    Random random(72);
    const auto points = generate(4096, [&] { return vec3{random.between(-2, 3), random.between(0, 1), random.logBetween(0.01f, 10)}; });
    const auto normals = generate(4096, [&] { return random.direction(); });
    learnGuide(scene.tables, points, normals, {size_t{1} << 24, true},
               [](const GuideRepresentatives& from) { return std::vector<float>(from.maps * bins, 1.0f); });
    const DeviceFunction<uint> function({.include = "light/guide_place.clh",
                                         .type = "uint",
                                         .body = "light_tables tables = BIND_LIGHTS; result = guide_map(tables, p, n);",
                                         .inputs = {"vec3 p", "vec3 n"},
                                         .tables = "LIGHT_TABLES(TABLE)",
                                         .features = Features::all()});
    const DeviceScene onDevice(testContext(), scene);
    for (const uint map : function.with(onDevice, points, normals)) ASSERT_GE(map, static_cast<uint>(GUIDE_FACES));
    for (const uint map : function.with(onDevice, points, std::vector<vec3>(points.size(), vec3{0, 0, 0})))
        ASSERT_GE(map, static_cast<uint>(GUIDE_FACES));
}

}  // namespace
}  // namespace eikonal
