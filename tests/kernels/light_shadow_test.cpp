// Shadow rays to points of lights with an area: an opaque wall just before the light blocks all of them, and the light itself, and what it
// lies on, none.

#include "brute_force.h"
#include "device_function.h"
#include "kind_features.h"
#include "kinds/light_kind.h"
#include "pack/pack.h"
#include "random_inputs.h"
#include "stage.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace eikonal {
namespace {

/// Every shape, and every light with an area.
Features lightFeatures() {
    Features features;
    features.require(Feature::EMITTERS).require(Feature::LIGHTS).require(KindFeature::LIGHT_POINT);
#define REQUIRE_SHAPE(name, FEATURE, SPACE) features.require(KindFeature::FEATURE);
    SHAPES(REQUIRE_SHAPE)
#undef REQUIRE_SHAPE
    for (const LightKind& kind : lightKindList())
        if (kind.place == LightPlace::AREA) features.require(kind.feature);
    return features;
}

enum class Shadow : uint { none, blocked, free };   ///< none: the light does not shine there

/// The shadow ray from p towards the point v of the light that u chooses.
std::vector<Shadow> shadows(const PackedScene& scene, const std::vector<vec3>& p, const std::vector<float>& u, const std::vector<vec2>& v) {
    static const DeviceFunction<Shadow> function(
        {.include = "trace/test_shadow.clh shade/scatter.clh",
         .type = "uint",
         .body = R"(
        geometry g = BIND_GEOMETRY;
        texture_tables tables = BIND_TEXTURES;
        light_tables light_set = BIND_LIGHTS;
        color_tables color_set = BIND_COLORS;
        light_choice found = choose_this_light(light_set, no_choice(), (uint)sample_light_index(light_set, count, u).i);
        light_sample l = sample_light(light_set, path_wavelengths(color_set, 0u, 0u), found, p, v);
        spectrum one = uniform_spectrum(1.0f);
        shadow_item s = light_contribution(new_shadow(), one, one, l, one, 0.0f, 1);
        s.o = p;
        if (is_aimed_by_direction(g, s)) s = meet_light(g, tables, color_set, s);
        if (is_black(s.Ld)) s.t_max = -1.0f;
        aimed_element aim = {s.element, s.element_t};
        result = s.t_max < 0.0f ? 0u : is_blocked(g, tables, p, s.d, s.t_max, 0.0f, aim) ? 1u : 2u;)",
         .inputs = {"vec3 p", "float u", "vec2 v", "uint count"},
         .tables = "GEOMETRY_TABLES(TABLE) TEXTURE_TABLES(TABLE) LIGHT_TABLES(TABLE) COLOR_TABLES(TABLE)",
         .features = lightFeatures()});
    const DeviceScene onDevice(testContext(), scene);
    return function.with(onDevice, p, u, v, std::vector<uint>(p.size(), static_cast<uint>(scene.tables.lights.size())));
}

/// A light about the origin that shines downwards, or all around, of a size of about 1, and a wall around it or below it at a distance
/// `gap` along its normal, which hides the light down to `leastGap`.
struct LightCase { std::string name, light; std::string (*wall)(double gap); double leastGap = 1e-6; };
void PrintTo(const LightCase& c, std::ostream* out) { *out << c.name; }

std::string implicit(const std::string& F) {
    return "Shape \"implicit\" \"string F\" \"" + F + "\" \"point3 bounds\" [-.6 -.6 -.6  .6 .6 .6]";
}

const LightCase cases[] = {
    {"triangles", "Shape \"trianglemesh\" \"point3 P\" [-.4 0 -.4  .4 0 -.4  .4 0 .4  -.4 0 .4] \"integer indices\" [0 1 2 0 2 3]",
     [](double g) {
         return fmt::format("Shape \"trianglemesh\" \"point3 P\" [-.6 {0} -.6  .6 {0} -.6  .6 {0} .6  -.6 {0} .6] "
                            "\"integer indices\" [0 1 2 0 2 3]", -g);
     }},
    /* y = x z / 2, of which z = +-.4 has a slope of .2 */
    {"patch", "Shape \"bilinearmesh\" \"point3 P\" [-.4 .08 -.4  .4 -.08 -.4  -.4 -.08 .4  .4 .08 .4]",
     [](double g) {
         return fmt::format("Shape \"bilinearmesh\" \"point3 P\" [-.6 {0} -.6  .6 {1} -.6  -.6 {1} .6  .6 {0} .6]", .18 - g * 1.05,
                            -.18 - g * 1.05);
     }},
    {"disk", "Rotate 90 1 0 0 Shape \"disk\" \"float radius\" .4",
     [](double g) { return fmt::format("Translate 0 {} 0 Rotate 90 1 0 0 Shape \"disk\" \"float radius\" .6", -g); }},
    {"sphere", "Shape \"sphere\" \"float radius\" .4",
     [](double g) { return fmt::format("Shape \"sphere\" \"float radius\" {}", .4 + g); }},
    {"ellipsoid", "Scale .4 .3 .2 Shape \"sphere\"",
     [](double g) { return fmt::format("Scale {} {} {} Shape \"sphere\"", .4 + g, .3 + g, .2 + g); }},
    {"half_sphere", "Rotate 90 1 0 0 Shape \"sphere\" \"float radius\" .4 \"float zmin\" 0",
     [](double g) { return fmt::format("Shape \"sphere\" \"float radius\" {}", .4 + g); }},
    /* Their points are known to 4 times the rounding of F, or 16 times */
    {"implicit_ball", implicit("x^2 + y^2 + z^2 - .16"),
     [](double g) { return fmt::format("Shape \"sphere\" \"float radius\" {}", .4 + g); }, 1e-5},
    {"implicit_ring", implicit("(sqrt(x^2 + z^2) - .3)^2 + y^2 - .01"),
     [](double g) { return implicit(fmt::format("sqrt((sqrt(x^2 + z^2) - .3)^2 + y^2) - {}", .1 + g)); }, 1e-5},
    /* A point in or before a disk */
    {"point", "",
     [](double g) { return fmt::format("Translate 0 {} 0 Rotate 90 1 0 0 Shape \"disk\" \"float radius\" .6", -g); }, 1e-5},
    {"cylinder", "Shape \"cylinder\" \"float radius\" .3 \"float zmin\" -.3 \"float zmax\" .3",
     [](double g) { return fmt::format("Shape \"cylinder\" \"float radius\" {} \"float zmin\" -1 \"float zmax\" 1", .3 + g); }},
};

class LightShadows : public testing::TestWithParam<LightCase> {
protected:
    /// Shares of shadow rays, of those where the light shines, that nothing blocks: in scenes with the light at 8 angles, seen from
    /// points 1 below it.
    struct Share { double free = 0; size_t rays = 0; };
    static Share freeShare(const std::string& light, const std::string& wall, double size = 1, double turns = 7) {
        Share share;
        Random random(91);
        for (int turn = 0; turn < 8; ++turn) {
            const std::string place = fmt::format("Translate 0 1 0 Rotate {} 1 2 3 Scale {} {} {} ", turn * turns, size, size, size);
            const PackedScene scene = packText(
                "WorldBegin Shape \"disk\" \"float radius\" .001 AttributeBegin " +
                (light.empty() ? place + "LightSource \"point\"" : "AreaLightSource \"diffuse\" " + place + light) +
                " AttributeEnd AttributeBegin " + place + wall + " AttributeEnd");
            std::vector<vec3> p;
            std::vector<float> u;
            std::vector<vec2> v;
            /* Scene space, by the disk at the origin */
            const object_space& origin = scene.tables.object_spaces[0];
            const affine& m = origin.scene_from_object;
            const vec3 center = placedCenter(origin);
            const float scale = m.xx * origin.radius / .001f;
            for (int i = 0; i < 100000; ++i) {
                const float x = random.between(-.5f, .5f), z = random.between(-.5f, .5f);
                p.push_back({center.x + scale * x, center.y + scale * .01f, center.z + scale * z});
                u.push_back(random.unit());
                v.push_back({random.unit(), random.unit()});
            }
            for (const Shadow s : shadows(scene, p, u, v)) {
                share.rays += s != Shadow::none;
                share.free += s == Shadow::free;
            }
        }
        share.free /= static_cast<double>(share.rays);
        return share;
    }
};

// The wall is 1e-6 before the light, at distances of .5 to 1.5. Points of this scene, of size 1.4, are rounded by 2^-24 in each coordinate,
// a fifteenth of the gap.
TEST_P(LightShadows, AWallJustBeforeTheLightBlocksAll) {
    for (const double gap : {1e-4, 1e-5, 1e-6}) {
        if (gap < GetParam().leastGap) continue;
        const Share share = freeShare(GetParam().light, GetParam().wall(gap));
        EXPECT_GT(share.rays, 100000u);
        EXPECT_EQ(share.free, 0) << gap;
    }
}

// The light itself blocks only its far side. Seen from 10,000 of its sizes, a step of a ray's direction is a thousandth of the light.
TEST_P(LightShadows, NoLightHidesItself) {
    for (const double size : {1., 1e-2, 1e-4}) EXPECT_EQ(freeShare(GetParam().light, "", size).free, 1) << size;
}

// A light in the plane of a wall is on it. Round ones in round walls may disappear where the ray is within 1e-2 of their tangent plane:
// there SHADOW_EPSILON limits the gap.
TEST_P(LightShadows, WhatTheLightLiesOnHidesNothing) { EXPECT_GT(freeShare(GetParam().light, GetParam().wall(0)).free, 1 - 2e-4); }

// On the far side of a light that shines inwards, its near side hides the sampled points: those of a cylinder or a bowl all of them, seen
// from beside or from below, where every chord of the round begins on its near side. All of a bowl is seen where it is open and wider than
// the place of those who look. Where a chord is shorter than the error at the ray's end, its near side counts as the point: within 1.2e-3
// (the root of a rounding over the radius) of the tangent plane. That is one or two rays in a thousand, and 1e-6 of the light.
TEST_F(LightShadows, TheNearSideOfALightHidesItsFarSide) {
    const std::string cylinder = "ReverseOrientation Shape \"cylinder\" \"float radius\" .3 \"float zmin\" -3 \"float zmax\" 3 ",
                      bowl = "ReverseOrientation Shape \"sphere\" \"float radius\" .4 ";
    const std::string up = "Rotate -90 1 0 0 ", down = "Rotate 90 1 0 0 ";
    for (const std::string& hidden : {cylinder, up + bowl + "\"float zmax\" 0", up + "Scale 1 .8 1.2 " + bowl + "\"float zmax\" 0"}) {
        const Share share = freeShare(hidden, "", 1, 0);
        EXPECT_GT(share.rays, 100000u) << hidden;
        EXPECT_LT(share.free, 4e-3) << hidden;
    }
    for (const char* size : {"2 2 2 ", "2.2 2 1.8 "}) {
        const std::string open = down + "Scale " + size + bowl + "\"float zmax\" 0";
        const Share share = freeShare(open, "", 1, 0);
        EXPECT_GT(share.rays, 100000u) << open;
        EXPECT_GT(share.free, 1 - 2e-4) << open;
    }
}

INSTANTIATE_TEST_SUITE_P(Lights, LightShadows, testing::ValuesIn(cases), [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace eikonal
