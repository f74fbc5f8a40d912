// Paths from both ends in participating media: the same light as paths from the camera find where those find it; what only light paths
// find, against what can be derived; and the same bits, however they are divided.

#include "both_ends.h"

#include <cmath>

namespace eikonal {
namespace {

constexpr const char* anywhere = "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\" \"rgb sigma_s\" [.3 .35 .4] "
                                 "\"rgb sigma_a\" [.05 .02 .01] \"float g\" .3\nMediumInterface \"\" \"fog\"\n"
                                 "Camera \"perspective\" \"float fov\" 40\n";
const std::string bare = "MediumInterface \"\" \"\"\n";   // for shapes in the fog
std::string body(const std::string& medium, const std::string& shape) {
    return "MakeNamedMedium \"m\" " + medium + "\nAttributeBegin MediumInterface \"m\" \"\" Material \"interface\" " + shape +
           " AttributeEnd\n";
}
const std::string smoke = "\"string type\" \"homogeneous\" \"rgb sigma_s\" [1 2 4] \"rgb sigma_a\" [.1 .2 .1] \"float g\" .4";
const std::string globe = "Translate 0 1 0 Scale .8 .7 .8 Shape \"sphere\" \"float radius\" 1";
const std::string cube = R"(Shape "trianglemesh"
    "point3 P" [-.9 .1 -.9  .9 .1 -.9  .9 1.7 -.9  -.9 1.7 -.9  -.9 .1 .9  .9 .1 .9  .9 1.7 .9  -.9 1.7 .9]
    "integer indices" [0 2 1 0 3 2  4 5 6 4 6 7  0 1 5 0 5 4  3 7 6 3 6 2  0 4 7 0 7 3  1 2 6 1 6 5])";
const std::string grid = "\"string type\" \"uniformgrid\" \"rgb sigma_s\" [2 3 4] \"rgb sigma_a\" [.5 .2 .1] \"integer nx\" 2 "
                         "\"integer ny\" 2 \"integer nz\" 2 \"float density\" [0 1 1 0 .5 0 1 1] \"point3 p0\" [-.9 .1 -.9] "
                         "\"point3 p1\" [.9 1.7 .9]";
const std::string point = "LightSource \"point\" \"rgb I\" [2 2 1.5] \"point3 from\" [.3 1.4 -.2]\n";
const std::string sun = "LightSource \"distant\" \"rgb L\" [2 2 1.6] \"point3 from\" [1 3 -2] \"point3 to\" [0 0 0]\n";

struct Case {
    std::string name, world, directive = {};
    int samples = 256;
    bool merges = false;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }
class LightPathsInMedia : public testing::TestWithParam<Case> {};

TEST_P(LightPathsInMedia, GiveTheImageOfPathsFromTheCamera) {
    View v = view();
    v.samples = GetParam().samples;
    const std::string text = sceneWith(v, GetParam().directive, GetParam().world), both = withIntegrator("\"bdpt\"", text);
    ASSERT_TRUE(packScene(both).features.has(Feature::LIGHT_PATHS));
    expectSameLight(text, both);
    if (GetParam().merges) expectSameLight(text, withIntegrator("\"vcm\" \"float radius\" .03", text), 5e-3);
}

INSTANTIATE_TEST_SUITE_P(
    Of, LightPathsInMedia,
    testing::Values(Case{"fog_around_all", bare + room + panel + ball("\"diffuse\""), anywhere, 512},
                    Case{"a_globe_of_smoke", room + panel + body(smoke, globe), "", 256},
                    Case{"a_cube_with_a_ball",
                         room + panel + body(smoke, cube) + ball("\"dielectric\" \"float roughness\" .3"), "", 256, true},
                    Case{"a_grid", room + panel + body(grid, cube), "", 256},
                    Case{"a_point_light_in_it", room + point + body(smoke, cube), "", 512},
                    Case{"a_lamp_in_it",
                         room + lamp("Translate .1 1.2 0 Shape \"sphere\" \"float radius\" .2") + body(smoke, globe), "", 512},
                    Case{"the_sun", room + sun + body(smoke, cube), "", 256},
                    Case{"a_sky", room + "LightSource \"infinite\" \"rgb L\" [.4 .5 .6]\n" + body(smoke, globe)},
                    Case{"curves_in_it",
                         room + panel + body(smoke, cube) +
                             "Shape \"curve\" \"point3 P\" [-.5 .3 0  -.2 1.5 0  .2 .3 0  .5 1.5 0] \"float width\" .2",
                         "", 256}),
    [](const auto& info) { return info.param.name; });

/// Light that turns back thirty times: the frame of a direction is not made of the one before, or errors of their lengths would grow.
TEST(LightPathsInADeepMedium, GiveTheImageOfPathsFromTheCamera) {
    View v = view();
    v.samples = 768;
    v.maxDepth = 29;
    const std::string medium = "\"string type\" \"homogeneous\" \"rgb sigma_s\" [10 10 10] \"rgb sigma_a\" [.2 .2 .2] \"float g\" -.9";
    const std::string text = sceneText(v, lamp("Translate 2 3 -3 Shape \"sphere\" \"float radius\" .4") + body(medium, globe));
    expectSameLight(text, withIntegrator("\"bdpt\"", text));
}

/// At wavelengths, a path samples distances for one of them and counts for all.
TEST(LightPathsInMediaAtWavelengths, GiveTheImageOfPathsFromTheCamera) {
    View v = view();
    v.samples = 1024;
    const std::string text = sceneText(v, room + panel + body(smoke, globe));
    const FilmImage camera = render(packScene(text, ColorMode::spectral)).image,
                    both = render(packScene(withIntegrator("\"bdpt\"", text), ColorMode::spectral)).image;
    const Estimate a = meanOf(camera), b = meanOf(both);
    /* All paths of a pass have the same wavelengths: 1024 passes have more noise in common than their pixels say */
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(a.mean[c], b.mean[c], standardErrors * std::hypot(a.error.g, b.error.g) + 5e-3 * a.mean[c]);
}

/// A spotlight in the middle of a glass ball, as in LightPathsBehindGlass, in a medium that only absorbs: all light to the floor passes
/// the same distance of it, and then that to the camera.
TEST(LightPathsInMediaBehindGlass, LightTheFloorThroughWhatAbsorbs) {
    View v;
    v.lookAt = "1.2 1 0  1.2 0 .01  0 0 1";
    v.fov = 10;
    v.width = v.height = 32;
    v.samples = 4096;
    v.maxDepth = 6;
    constexpr double sigma = 0.8;
    const std::string world = R"(LightSource "spot" "rgb I" [4 4 4] "point3 from" [0 1 0] "point3 to" [1.2 0 0] "float coneangle" 20
        Material "diffuse" "rgb reflectance" [.5 .5 .5]
        Shape "bilinearmesh" "point3 P" [-3 0 -3  3 0 -3  -3 0 3  3 0 3]
        AttributeBegin Translate 0 1 0 MediumInterface "" "m" Material "dielectric" Shape "sphere" "float radius" .3 AttributeEnd)";
    const std::string medium = "MakeNamedMedium \"m\" \"string type\" \"homogeneous\" \"rgb sigma_s\" [0 0 0] \"rgb sigma_a\" [.8 .8 .8]\n"
                               "MediumInterface \"\" \"m\"\nCamera \"perspective\" \"float fov\" 10\n";
    v.more = medium;
    const std::string text = sceneText(v, bare + world);
    const Rendered both = render(withIntegrator("\"bdpt\"", text));
    const double d = std::sqrt(1.2 * 1.2 + 1), expected = 0.5 / M_PI * 4 / (d * d * d) / 1.04 * std::exp(-sigma * (d - .3 + 1));
    EXPECT_EQ(estimate(render(text).image).mean.g, 0);
    const Estimate e = meanOf(both.image);
    EXPECT_NEAR(e.mean.g, expected, standardErrors * e.error.g + 4e-3 * expected /* the pixels see more than one point */);
    EXPECT_LT(e.error.g, 0.02 * expected) << "too few samples to tell";
}

/// What light paths bring counts for the layer of what the camera meets first.
TEST(LightPathsInMediaPasses, AreThoseOfPathsFromTheCamera) {
    View v = view();
    v.samples = 512;
    const std::string text = sceneText(v, room + panel + body(smoke + " \"float scale\" .2", cube) + ball("\"diffuse\""));
    const auto passesOf = [](const std::string& scene) {
        PackedScene packed = packScene(scene);
        packed.require(Feature::RENDER_PASSES, "the test");
        return render(packed).image;
    };
    const FilmImage camera = passesOf(text), both = passesOf(withIntegrator("\"bdpt\"", text));
    const double error = std::hypot(meanOf(camera).error.g, meanOf(both).error.g);
    double sum = 0;
    for (const auto layer : {&FilmImage::emission, &FilmImage::direct, &FilmImage::indirect, &FilmImage::volume}) {
        EXPECT_NEAR(meanGreen(camera.*layer), meanGreen(both.*layer), standardErrors * error);
        EXPECT_GT(meanGreen(camera.*layer), layer == &FilmImage::emission ? -1. : 5 * error);
        sum += meanGreen(both.*layer);
    }
    EXPECT_NEAR(sum, meanOf(both).mean.g, 1e-5 * sum);
}

class LightPathsInMediaEquality : public testing::TestWithParam<const char*> {
protected:
    static std::string text() {
        View v = view();
        v.samples = 24;
        return withIntegrator(GetParam(), sceneText(v, room + panel + body(smoke, cube) + ball("\"dielectric\"")));
    }
};
TEST_P(LightPathsInMediaEquality, WavesPartsAndCropsDoNotShow) {
    const PackedScene scene = packScene(text());
    const Rendered reference = render(text());
    expectSameBitsInAnyWaves(scene, reference.image);
    expectSameBitsInRangesOfSamples(scene, reference.image);
    expectSameBitsInACrop(scene, reference.image);
}
INSTANTIATE_TEST_SUITE_P(Of, LightPathsInMediaEquality, testing::Values("\"bdpt\"", "\"vcm\""),
                         [](const auto& info) { return std::string(info.param).substr(1, std::string(info.param).size() - 2); });

}  // namespace
}  // namespace eikonal
