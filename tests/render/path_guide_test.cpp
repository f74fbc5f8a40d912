// A path guide learns from where light comes; then paths that follow it change the noise, and nothing else.

#include "pack/pack.h"
#include "pack/path_guide.h"
#include "read/pbrt/read_pbrt.h"
#include "rendering.h"

#include <cmath>

namespace eikonal {
namespace {

/// A closed box, lit by a lamp that shines on its ceiling from behind a screen: what the camera sees has light after two bounces.
std::string box(const std::string& inside) {
    View view;
    view.lookAt = "-1.5 0 -1.7  1 0 -.4  0 0 1";
    view.width = view.height = 48;
    view.samples = 128;
    view.sampler = "sobol";
    view.more = "Integrator \"volpath\" \"integer maxdepth\" 6\n";
    return sceneText(view, R"(Material "diffuse" "rgb reflectance" [.7 .6 .5]
        Shape "trianglemesh" "point3 P" [-2 -2 -2  2 -2 -2  2 2 -2  -2 2 -2  -2 -2 2  2 -2 2  2 2 2  -2 2 2]
            "integer indices" [0 1 2 0 2 3  4 5 6 4 6 7  0 4 7 0 7 3  1 5 6 1 6 2  0 1 5 0 5 4  3 2 6 3 6 7]
        Shape "trianglemesh" "point3 P" [.3 -2 -1  .3 2 -1  .3 2 2  .3 -2 2] "integer indices" [0 1 2 0 2 3]
        AttributeBegin AreaLightSource "diffuse" "rgb L" [30 30 30]
        Shape "trianglemesh" "point3 P" [1 -.2 1.2  1.4 -.2 1.2  1.4 .2 1.2  1 .2 1.2] "integer indices" [0 1 2 0 2 3] AttributeEnd)" +
                               inside);
}

PackedScene guided(const std::string& inside) {
    Diagnostics diagnostics(LogLevel::silent);
    Scene scene = readPbrtText(box(inside), "test.pbrt", ".", diagnostics);
    scene.colorMode = ColorMode::rgb;
    scene.integrator.guiding = PathGuiding::on;
    PackedScene packed = packScene(scene, diagnostics);
    EXPECT_TRUE(packed.features.has(Feature::PATH_GUIDE));
    return packed;
}

TEST(PathGuide, ABoxIsAsBrightAsWithoutIt) {
    for (const std::string inside :
         {"", "\nMaterial \"conductor\" \"float roughness\" .3 AttributeBegin Translate -.6 .5 -1.5 Shape \"sphere\" \"float radius\" .5 "
              "AttributeEnd",
          "\nMaterial \"dielectric\" \"float roughness\" .3 AttributeBegin Translate -.6 .5 -1.5 Shape \"sphere\" \"float radius\" .5 "
          "AttributeEnd",
          "\nMaterial \"coateddiffuse\" AttributeBegin Translate -.6 .5 -1.5 Shape \"sphere\" \"float radius\" .5 AttributeEnd",
          "\nMaterial \"diffusetransmission\" AttributeBegin Translate -.6 0 -1 Shape \"disk\" \"float radius\" .5 AttributeEnd"}) {
        SCOPED_TRACE(inside);
        const Rendered with = render(guided(inside)), without = render(packScene(box(inside), ColorMode::rgb));
        expectEqualMeans(with, without, 0.03);
    }
}

TEST(PathGuide, HasLessNoise) {
    EXPECT_LT(render(guided("")).error.error, 0.8 * render(box("")).error.error);
}

TEST(PathGuide, WavesAndPartsOfTheImageHaveTheSameBits) {
    expectSameBitsInWavesAndParts(guided(""), {10, 10, 31, 23});
}

/// What an optional guide gains is what it is found to gain, within a factor of two.
TEST(PathGuide, TellsWhatItGains) {
    PackedScene scene = guided("");
    scene.isGuideOptional = true;
    scene.samples = 512;
    const Rendered with = render(scene), without = render(packScene(box("")));
    const double measured = std::pow(without.error.error / with.error.error, 2) * 128 / scene.samples;
    EXPECT_GT(with.guideGain, measured / 2);
    EXPECT_LT(with.guideGain, measured * 2);
}

/// Without light that is hard to find, there is nothing to gain.
TEST(PathGuide, GainsNothingUnderTheSky) {
    View view;
    view.width = view.height = 48;
    view.samples = 256;
    PackedScene scene = packScene(sceneText(view, "LightSource \"infinite\" \"rgb L\" [1 1 1]\nShape \"sphere\"\n"
                                                  "Shape \"disk\" \"float radius\" 9 \"float height\" 1\n"));
    scene.require(Feature::PATH_GUIDE, "the test");
    scene.isGuideOptional = true;
    packUnlearnedPathGuide(scene.tables);
    scene.frame().guided_share = .5f;
    EXPECT_LT(render(scene).guideGain, 1.5);
}

}  // namespace
}  // namespace eikonal
