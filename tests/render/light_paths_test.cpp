// Paths from both ends: the same image as by paths from the camera where those find all light, and what they cannot find where they do not.

#include "both_ends.h"

#include "lens_file.h"

#include <cmath>

namespace eikonal {
namespace {

std::string withLightPaths(const std::string& text) { return withIntegrator("\"bdpt\"", text); }

struct Case {
    std::string name, world, directive;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }
class LightPaths : public testing::TestWithParam<Case> {};

TEST_P(LightPaths, GiveTheImageOfPathsFromTheCamera) {
    const std::string text = sceneWith(view(), GetParam().directive, room + GetParam().world);
    expectSameLight(text, withLightPaths(text));
}

std::string manyLamps() {
    std::string all;
    for (int i = 0; i < 12; ++i)
        all += lamp("Translate " + std::to_string(-.8 + .4 * (i % 5)) + " " + std::to_string(1.5 - .2 * (i / 5)) + " " +
                    std::to_string(-.5 + .4 * (i / 5)) + " Shape \"sphere\" \"float radius\" .06");
    return all;
}
const std::string leaf = "\"diffusetransmission\" \"rgb reflectance\" [.3 .3 .3] \"rgb transmittance\" [.5 .4 .3]";

/// Filters reach over the edges of what a camera sees around it.
const std::string inTheRoom = "PixelFilter \"gaussian\" Identity LookAt -.3 1.1 -.8  .3 .8 .4  0 1 0 ";

/// A thick lens of 50 mm with a wide stop behind it, focused on the room.
std::string lensSystem() {
    static const LensFile lens("50 6 1.5 40\n-50 1 1 40\n0 50 0 36\n");
    return lens.camera() + " \"float aperturediameter\" 30 \"float focusdistance\" 4";
}

INSTANTIATE_TEST_SUITE_P(
    Of, LightPaths,
    testing::Values(
        Case{"clear_glass", panel + ball("\"dielectric\""), ""},
        Case{"rough_glass", panel + ball("\"dielectric\" \"float roughness\" .3"), ""},
        Case{"a_coat", panel + ball("\"coateddiffuse\" \"float roughness\" 0"), ""},
        Case{"vertex_normals", panel + R"(Material "diffuse" Shape "trianglemesh"
                         "point3 P" [-.8 .3 .3  .8 .3 .3  0 1.6 .6] "normal N" [-1 0 -1  1 0 -1  0 1 -.5])",
             ""},
        Case{"a_filter_with_negative_lobes", panel + ball("\"diffuse\""), "PixelFilter \"mitchell\""},
        Case{"a_lens", panel + ball("\"diffuse\""),
             "Camera \"perspective\" \"float fov\" 40 \"float lensradius\" .2 \"float focaldistance\" 3"},
        Case{"parallel_rays", panel + ball("\"dielectric\""), "Camera \"orthographic\" \"float screenwindow\" [-1.3 1.3 -1.3 1.3]"},
        Case{"a_lens_system", panel + ball("\"dielectric\" \"float roughness\" .3"), "Camera " + lensSystem()},
        Case{"a_moving_lens_system", panel + ball("\"diffuse\""),
             "ActiveTransform EndTime Translate .2 0 0 ActiveTransform All Camera " + lensSystem()},
        Case{"a_lens_with_a_square_stop", panel + ball("\"diffuse\""), "Camera " + lensSystem() + " \"string aperture\" \"square\""},
        Case{"an_equal_area_sphere", panel + ball("\"dielectric\" \"float roughness\" .3"), inTheRoom + "Camera \"spherical\""},
        Case{"a_globe", panel + ball("\"diffuse\""), inTheRoom + "Camera \"spherical\" \"string mapping\" \"equirectangular\""},
        Case{"a_tree_of_lights", manyLamps() + ball(leaf), "Integrator \"volpath\" \"integer maxdepth\" 6 \"string lightsampler\" \"bvh\""},
        Case{"a_cut_out_lamp", lamp("Translate 0 1.5 0 Shape \"sphere\" \"float radius\" .3 \"float alpha\" .5") + ball("\"diffuse\""), ""},
        Case{"a_lamp_whose_normals_turn",
             lamp(R"(Shape "bilinearmesh" "point3 P" [-.3 1.7 -.3  .3 1.7 -.3  -.3 1.7 .3  .3 1.7 .3]
                         "normal N" [0 -1 0  .98 .2 0  0 -1 0  .98 .2 0])") + ball("\"diffuse\""), ""},
        Case{"a_sky", "LightSource \"infinite\" \"rgb L\" [.4 .5 .6]\n" + ball("\"dielectric\""), ""},
        Case{"a_spot", "LightSource \"spot\" \"rgb I\" [9 8 7] \"point3 from\" [.4 1.9 -.4] \"float coneangle\" 40\n" + ball("\"diffuse\""),
             ""}),
    [](const auto& info) { return info.param.name; });

/// A spotlight in the middle of a glass ball of index 1.5: rays meet the boundary at right angles, where a share R = 0.04 returns through
/// the middle to the other side. Of what the bare light would send, the floor gets (1 - R) (1 + R^2 + R^4 ...) = 1 / (1 + R), nearly all of
/// it with `maxdepth` 6. Paths from the camera find none of it.
TEST(LightPathsBehindGlass, LightTheFloorAsRefractionAllows) {
    View v;
    v.lookAt = "1.2 1 0  1.2 0 .01  0 0 1";  // floor beside the ball, seen from above
    v.fov = 10;
    v.width = v.height = 32;
    v.samples = 4096;
    v.maxDepth = 6;
    const std::string world = R"(LightSource "spot" "rgb I" [4 4 4] "point3 from" [0 1 0] "point3 to" [1.2 0 0] "float coneangle" 20
        Material "diffuse" "rgb reflectance" [.5 .5 .5]
        Shape "bilinearmesh" "point3 P" [-3 0 -3  3 0 -3  -3 0 3  3 0 3]
        AttributeBegin Translate 0 1 0 Material "dielectric" Shape "sphere" "float radius" .3 AttributeEnd)";
    const Rendered camera = render(sceneText(v, world)), both = render(withLightPaths(sceneText(v, world)));
    const double d2 = 1.2 * 1.2 + 1, expected = 0.5 / M_PI * 4 / std::pow(d2, 1.5) / 1.04;
    EXPECT_EQ(estimate(camera.image).mean.g, 0);
    const Estimate e = meanOf(both.image);
    EXPECT_NEAR(e.mean.g, expected, standardErrors * e.error.g + 2e-3 * expected /* the pixels see more than one point */);
    EXPECT_LT(e.error.g, 0.02 * expected) << "too few samples to tell";
    /* The variance that the film tells is that of its pixels: half the mean square of the difference of neighbours, 512 pairs */
    double squares = 0, variances = 0;
    for (size_t i = 0; i < both.image.pixelCount(); i += 2) {
        squares += std::pow(static_cast<double>(both.image.color[i].g - both.image.color[i + 1].g), 2) / 2;
        variances += static_cast<double>(both.image.variance[i] + both.image.variance[i + 1]) / 2;
    }
    EXPECT_NEAR(squares / variances, 1, standardErrors * std::sqrt(2. / 512));
}

/// Scenes that light paths cannot serve yet are rendered by paths from the camera, bit for bit.
TEST(LightPathsElsewhere, AreLeftOutWithAWarning) {
    const std::string text = sceneText(view(), room + panel),
                      narrow = sceneWith(view(), "PixelFilter \"box\" \"float xradius\" .05 \"float yradius\" .05", room + panel);
    EXPECT_THROW(packScene(withLightPaths(narrow)), std::invalid_argument);  // tests have no warnings
    EXPECT_TRUE(packScene(withLightPaths(text)).features.has(Feature::LIGHT_PATHS));
    EXPECT_FALSE(packScene(text).features.has(Feature::LIGHT_PATHS));
}

class LightPathsEquality : public testing::Test {
protected:
    static std::string text() {
        View v = view();
        v.samples = 24;
        v.sampler = "zsobol";
        return withLightPaths(
            sceneWith(v, "PixelFilter \"gaussian\"",
                      room + panel + ball("\"dielectric\"") + "LightSource \"point\" \"rgb I\" [2 2 2] \"point3 from\" [-.5 1.5 -.6]\n"));
    }
    const Rendered reference = render(text());
};

TEST_F(LightPathsEquality, WavesAndBatchesDoNotShow) { expectSameBitsInAnyWaves(packScene(text()), reference.image); }
TEST_F(LightPathsEquality, SamplesMayComeInParts) { expectSameBitsInRangesOfSamples(packScene(text()), reference.image); }
TEST_F(LightPathsEquality, ACropHasThePixelsOfTheWhole) { expectSameBitsInACrop(packScene(text()), reference.image); }
TEST_F(LightPathsEquality, AdaptiveSamplingEndsWithTheErrorAskedFor) {
    RenderSetup setup;
    PackedScene scene = packScene(text());
    scene.samples = 1024;
    setup.targetError = 0.05;
    const Rendered adaptive = render(scene, setup);
    ASSERT_TRUE(adaptive.result.error.has_value());
    EXPECT_LE(*adaptive.result.error, 0.05);
    const Estimate a = meanOf(adaptive.image), b = meanOf(reference.image);
    EXPECT_NEAR(a.mean.g, b.mean.g, standardErrors * std::hypot(a.error.g, b.error.g));
}

}  // namespace
}  // namespace eikonal
