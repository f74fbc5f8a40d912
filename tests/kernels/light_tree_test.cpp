// The light tree: it takes lights with the probability that it says, and none that matters never.

#include "device_function.h"
#include "random_inputs.h"
#include "stage.h"
#include "statistics.h"
#include "test_paths.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace eikonal {
namespace {

/// Lights of every kind that a tree holds, here and there in a box, and two that are infinitely far away.
std::string crowd(int count) {
    Random random(71);
    std::string text = "Integrator \"volpath\" \"string lightsampler\" \"bvh\"\nWorldBegin\n";
    for (int i = 0; i < count; ++i) {
        const vec3 p = random.box(2), to = random.direction();
        const std::string power = fmt::format("\"float scale\" {}", random.logBetween(0.1f, 10));
        const std::string at =
            fmt::format("AttributeBegin Translate {} {} {} Rotate {} {} {} {} ", p.x, p.y, p.z, 360 * random.unit(), to.x, to.y, to.z);
        const std::string area = "AreaLightSource \"diffuse\" " + power;
        switch (i % 10) {
            case 0: text += at + "LightSource \"point\" " + power; break;
            case 1: text += at + "LightSource \"spot\" \"float coneangle\" 40 \"float conedeltaangle\" 15 " + power; break;
            case 2: text += at + area + " Shape \"trianglemesh\" \"point3 P\" [0 0 0 .1 0 0 0 .2 0] \"integer indices\" [0 1 2]"; break;
            case 3: text += at + area + " \"bool twosided\" true Shape \"disk\" \"float radius\" .1"; break;
            case 4: text += at + area + " Shape \"sphere\" \"float radius\" .05"; break;
            case 5: text += at + area + " Shape \"bilinearmesh\" \"point3 P\" [0 0 0 .1 0 .05 0 .1 0 .1 .1 0]"; break;
            case 6: text += at + area + " Shape \"cylinder\" \"float radius\" .03 \"float zmin\" -.1 \"float zmax\" .2"; break;
            case 7:
                text += at + "LightSource \"goniometric\" \"string filename\" \"" EIKONAL_SOURCE_DIR "/scenes/assets/tiles.png\" " + power;
                break;
            case 8:
                text += at +
                        "LightSource \"projection\" \"float fov\" 70 \"string filename\" \"" EIKONAL_SOURCE_DIR
                        "/scenes/assets/tiles.png\" " +
                        power;
                break;
            case 9: text += at + "LightSource \"spot\" \"float coneangle\" 20 \"float conedeltaangle\" 20 " + power; break;
        }
        text += " AttributeEnd\n";
    }
    return text + "LightSource \"infinite\" \"string filename\" \"" EIKONAL_SOURCE_DIR
                  "/scenes/assets/tiles.png\" LightSource \"distant\" Shape \"sphere\" \"float radius\" 4";
}

struct Chosen { uint light; float pmf, again; };
const DeviceFunction<Chosen>& chooser() {
    static const DeviceFunction<Chosen> function({.include = "light/choose.clh", .type = "chosen", .body = R"(
        light_tables tables = BIND_LIGHTS;
        light_choice c = sample_light_tree(tables, frame, p, n, u, no_choice());
        light l = fetch(tables.lights + c.light);
        result.light = c.light;
        result.pmf = c.pmf;
        result.again = l.pmf * pmf_light_tree(tables, l, p, n);)",
        .inputs = {"vec3 p", "vec3 n", "float u"}, .declarations = "typedef struct { uint light; float pmf, again; } chosen;",
        .tables = "LIGHT_TABLES(TABLE) ARGUMENT(__global const settings *, frame)"});
    return function;
}

struct Sent { float contribution, pmf; };
const DeviceFunction<Sent>& sender() {
    static const DeviceFunction<Sent> function({.include = "light/choose.clh", .type = "sent", .body = R"(
        light_tables tables = BIND_LIGHTS;
        light_choice c = no_choice();
        c.light = light_index; c.pmf = 1.0f;
        color_tables color_set = BIND_COLORS;
        light_sample s = sample_light(tables, path_wavelengths(color_set, 0u, 0u), c, p, v);
        int on_surface = length_squared(n) > 0.0f;
        result.contribution = s.pdf > 0.0f ? max_component(s.L) * (on_surface ? fabs(dot3(n, s.wi)) : 1.0f) / s.pdf : 0.0f;
        light l = fetch(tables.lights + light_index);
        result.pmf = l.pmf * pmf_light_tree(tables, l, p, n);)",
        .inputs = {"uint light_index", "vec3 p", "vec3 n", "vec2 v"}, .declarations = "typedef struct { float contribution, pmf; } sent;",
        .tables = "LIGHT_TABLES(TABLE) COLOR_TABLES(TABLE)"});
    return function;
}

/// A point among the lights, far from them, and a surface's normal or none.
struct Place { vec3 p, n; };
std::vector<Place> places(const PackedScene& scene) {
    Random random(72);
    std::vector<Place> list;
    const float s = static_cast<float>(1 / scene.worldScale);
    for (int i = 0; i < 6; ++i) {
        const vec3 p = random.box(i < 3 ? 2 : 4);
        list.push_back({{p.x * s, p.y * s, p.z * s}, i % 2 ? random.direction() : vec3{0, 0, 0}});
    }
    return list;
}

class LightTrees : public testing::TestWithParam<int> {};

/// Frequencies follow the probabilities, which are evaluated alike from the leaf up.
TEST_P(LightTrees, TakesLightsByTheirProbability) {
    const PackedScene scene = packText(crowd(GetParam()));
    const DeviceScene onDevice(testContext(), scene);
    Random random(73);
    const size_t draws = 20000, lights = scene.tables.lights.size();
    const auto u = generate(draws, [&] { return random.unit(); });
    for (const Place& at : places(scene)) {
        std::vector<double> counts(lights + 1), expected(lights + 1);
        for (const Chosen& c : chooser().with(onDevice, std::vector<vec3>(draws, at.p), std::vector<vec3>(draws, at.n), u)) {
            if (c.pmf > 0) { ASSERT_NEAR(c.again / c.pmf, 1, 1e-4); }
            counts[c.pmf > 0 ? c.light : lights] += 1;
        }
        std::vector<uint> index(lights);
        for (uint i = 0; i < lights; ++i) index[i] = i;
        const auto all = sender().with(onDevice, index, std::vector<vec3>(lights, at.p), std::vector<vec3>(lights, at.n),
                                       std::vector<vec2>(lights, {0.5f, 0.5f}));
        double sum = 0;
        for (size_t i = 0; i < lights; ++i) { expected[i] = all[i].pmf * draws; sum += all[i].pmf; }
        expected[lights] = (1 - sum) * draws;
        EXPECT_NEAR(sum + counts[lights] / draws, 1, 1e-2 + (counts[lights] > 0 ? 0.02 : 0));
        const ChiSquare chi = testChiSquare(counts, expected);
        EXPECT_GT(chi.probability, significance) << chi.describe();
    }
}

/// What arrives somewhere from a light is never left out: its probability is positive.
TEST_P(LightTrees, LeavesNothingOut) {
    const PackedScene scene = packText(crowd(GetParam()));
    const DeviceScene onDevice(testContext(), scene);
    Random random(74);
    const size_t draws = 40000;
    std::vector<uint> index;
    std::vector<vec3> p, n;
    const float s = static_cast<float>(1 / scene.worldScale);
    while (index.size() < draws) {
        index.push_back(static_cast<uint>(random.below(static_cast<int>(scene.tables.lights.size()))));
        const vec3 q = random.box(3);
        p.push_back({q.x * s, q.y * s, q.z * s});
        n.push_back(index.size() % 2 ? random.direction() : vec3{0, 0, 0});
    }
    const auto v = generate(draws, [&] { return random.square(); });
    size_t lit = 0;
    const auto sent = sender().with(onDevice, index, p, n, v);
    for (size_t i = 0; i < draws; ++i) {
        if (sent[i].contribution > 1e-6f) {
            ++lit;
            EXPECT_GT(sent[i].pmf, 0) << "light " << index[i] << " of kind " << scene.tables.lights[index[i]].kind;
        }
    }
    EXPECT_GT(lit, draws / 8);
}

INSTANTIATE_TEST_SUITE_P(Of, LightTrees, testing::Values(1, 10, 63, 700));

}  // namespace
}  // namespace eikonal
