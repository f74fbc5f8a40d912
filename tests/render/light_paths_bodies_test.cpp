// Paths from both ends in scenes with subsurface bodies: light paths end at them, and what goes through them is left to paths from the
// camera. The light is that of paths from the camera alone, and the bits are the same, however the paths are divided.

#include "both_ends.h"

#include <gmock/gmock.h>

namespace eikonal {
namespace {

std::string flesh(const std::string& more) {
    return "\"subsurface\" \"rgb sigma_a\" [.5 1 2] \"rgb sigma_s\" [10 12 14] " + more;
}
const std::string walked = flesh("\"string method\" \"randomwalk\""),
                  rough = flesh("\"string method\" \"randomwalk\" \"float roughness\" .2"),
                  diffused = flesh("\"string method\" \"diffusion\" \"float roughness\" .2");
const std::string smoke = "MakeNamedMedium \"m\" \"string type\" \"homogeneous\" \"rgb sigma_s\" [1 2 4] \"rgb sigma_a\" [.1 .2 .1]\n"
                          "AttributeBegin MediumInterface \"m\" \"\" Material \"interface\" Translate 0 1 0 "
                          "Shape \"sphere\" \"float radius\" .95 AttributeEnd\n";
const std::string lampInBall = lamp("Translate .1 .5 0 Shape \"sphere\" \"float radius\" .1");
/// A ball in the smoke, and one that a mix makes flesh in some of its points.
const std::string smoked = "AttributeBegin MediumInterface \"\" \"m\"\n" + ball(rough) + "AttributeEnd\n";
const std::string spotted = "MakeNamedMaterial \"a\" \"string type\" \"diffuse\"\nMakeNamedMaterial \"b\" \"string type\" " + rough +
                            "\nMakeNamedMaterial \"c\" \"string type\" \"mix\" \"string materials\" [\"a\" \"b\"] \"float amount\" .6\n"
                            "AttributeBegin Translate .1 .5 0 NamedMaterial \"c\" Shape \"sphere\" \"float radius\" .4 AttributeEnd\n";

/// A body that is open: paths come out of it, and light in, without passing its surface again.
std::string openBody(const std::string& material) {
    return "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [10 8 6] \"bool twosided\" true "
           "Shape \"bilinearmesh\" \"point3 P\" [-.6 .1 -.6  .6 .1 -.6  -.6 .1 .6  .6 .1 .6] AttributeEnd\n"
           "AttributeBegin Material " +
           material + " Shape \"bilinearmesh\" \"point3 P\" [-.9 .6 -.9  .9 .6 -.9  -.9 .6 .9  .9 .6 .9] AttributeEnd\n";
}

struct Case {
    std::string name, world;
    int samples = 256;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }
class LightPathsAroundBodies : public testing::TestWithParam<Case> {};

TEST_P(LightPathsAroundBodies, GiveTheImageOfPathsFromTheCamera) {
    View v = view();
    v.samples = GetParam().samples;
    const std::string text = sceneText(v, GetParam().world), both = withIntegrator("\"bdpt\"", text);
    ASSERT_TRUE(packScene(both).features.has(Feature::LIGHT_PATHS));
    expectSameLight(text, both);
    expectSameLight(text, withIntegrator("\"vcm\" \"float radius\" .03", text), 5e-3);
}

INSTANTIATE_TEST_SUITE_P(Of, LightPathsAroundBodies,
                         testing::Values(Case{"a_walk", room + panel + ball(rough)},
                                         Case{"a_walk_in_a_smooth_ball", room + panel + ball(walked)},
                                         Case{"a_profile", room + panel + ball(diffused)},
                                         Case{"a_walk_in_smoke", room + panel + smoke + smoked, 512},
                                         Case{"a_mix", room + panel + spotted},
                                         Case{"an_open_walk", room + openBody(rough)},
                                         Case{"an_open_profile", room + openBody(diffused)},
                                         Case{"a_lamp_in_it", room + panel + lampInBall + ball(walked)}),
                         [](const auto& info) { return info.param.name; });

TEST(LightPathsAroundBodies, DoNotBeginInThem) {
    const auto emitters = [](const std::string& world) {
        const PackedScene scene = packScene(withIntegrator("\"bdpt\"", sceneText(view(), room + world)));
        unsigned count = 0;
        for (const light& l : scene.tables.lights) count += l.emission_pmf > 0;
        return count;
    };
    EXPECT_EQ(emitters(panel + lampInBall), 2u);
    EXPECT_EQ(emitters(panel + lampInBall + ball(walked)), 1u);
    EXPECT_EQ(emitters(panel + lampInBall + ball(diffused)), 1u);
    EXPECT_EQ(emitters(panel + lampInBall + spotted), 1u);
    /* In the box of the ball, but not in the ball */
    EXPECT_EQ(emitters(panel + lamp("Translate .42 .82 .32 Shape \"sphere\" \"float radius\" .05") + ball(walked)), 2u);
}

TEST(LightPathsAroundBodies, WavesPartsAndCropsDoNotShow) {
    View v = view();
    v.samples = 32;
    for (const char* integrator : {"\"bdpt\"", "\"vcm\""}) {
        const PackedScene scene = packScene(withIntegrator(integrator, sceneText(v, room + panel + ball(rough))));
        const FilmImage image = render(scene).image;
        expectSameBitsInAnyWaves(scene, image);
        expectSameBitsInRangesOfSamples(scene, image);
        expectSameBitsInACrop(scene, image);
    }
}

}  // namespace
}  // namespace eikonal
