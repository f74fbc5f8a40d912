// Implicit surfaces that emit: as much as the same surface in another form, and by whichever strategy a path finds them.

#include "lit_floor.h"

#include "kind_features.h"
#include "test_paths.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace eikonal {
namespace {

const std::string ball = "Shape \"implicit\" \"string F\" \"x^2 + y^2 + z^2 - 1\" \"point3 bounds\" [-1.1 -1.1 -1.1  1.1 1.1 1.1] ",
                  quadric = "Shape \"sphere\" ", lamp = "Translate 0 2 0 Scale .8 .8 .8 ";

std::string shining(const std::string& shape, const std::string& more = "") { return emitter(shape, more) + "\n"; }

/// These tests share their kernels.
RenderSetup withLamps() {
    RenderSetup setup = surfaces();
    setup.forced.require(KindFeature::SHAPE_IMPLICIT).require(KindFeature::LIGHT_IMPLICIT);
    return setup;
}
/// The light sampler never picks a light.
RenderSetup byBsdf() {
    RenderSetup setup = withLamps();
    setup.edit = [](PackedScene& s) { for (light& l : s.tables.lights) l.pmf = 0; };
    return setup;
}
Rendered floorUnder(const std::string& lights, const RenderSetup& setup = withLamps(), int samples = 256) {
    View view = atTheOrigin();
    view.samples = samples;
    return render(sceneText(view, lights + "\n" + floorShape), setup);
}

// E = pi L (r / d)^2, as of any sphere (light_test.cpp): by both strategies, by light samples alone (an alpha of 0 hides a lamp from rays)
// and by BSDF samples alone.
TEST(ImplicitLight, ABallShinesLikeASphere) {
    const double expected = rho * Le * .16;
    expectRadiance(floorUnder(shining(lamp + ball)), expected);
    expectRadiance(floorUnder(shining(lamp + ball + "\"float alpha\" 0")), expected);
    expectRadiance(floorUnder(shining(lamp + ball), byBsdf(), 1024), expected, .03);
}

// Two balls in one surface, of which neither hides the other: E = 2 pi L (r / d)^2 cos, d^2 = 5, cos = 2 / d.
TEST(ImplicitLight, TwoBallsShineLikeTwo) {
    const std::string two = "Translate 0 2 0 Shape \"implicit\" \"string F\" \"min((x - 1)^2 + y^2 + z^2, (x + 1)^2 + y^2 + z^2) - .16\" "
                            "\"point3 bounds\" [-1.5 -.5 -.5  1.5 .5 .5]";
    expectRadiance(floorUnder(shining(two), withLamps(), 1024), rho * Le * 2 * .16 / 5 * 2 / std::sqrt(5));
}

// The point of the floor is the centre of a ball of radius 3, whose inside is dark, unless it is turned or has two sides: E = pi L.
TEST(ImplicitLight, FromInsideOnlyTheInsideIsSeen) {
    const std::string dome = "Scale 3 3 3 " + ball;
    EXPECT_EQ(estimate(floorUnder(shining(dome)).image).mean, glm::dvec3(0));
    expectRadiance(floorUnder(shining("ReverseOrientation " + dome)), rho * Le);
    expectRadiance(floorUnder(shining(dome, "\"bool twosided\" true")), rho * Le);
}

// Half of the points are cut out: rays that pass the front half of the time see the inside, which shines if both sides do.
TEST(ImplicitLight, IsCutOutByAlpha) {
    const std::string holes = lamp + ball + "\"float alpha\" .5";
    for (const RenderSetup& setup : {withLamps(), byBsdf()}) {
        expectRadiance(floorUnder(shining(holes), setup, 1024), rho * Le * .16 * .5, .03);
        expectRadiance(floorUnder(shining(holes, "\"bool twosided\" true"), setup, 1024), rho * Le * .16 * .75, .03);
    }
}

// The power is that of the area, which the host's mesh knows to 0.2 %.
TEST(ImplicitLight, HasThePowerThatIsAskedFor) {
    const Estimate seen = estimate(floorUnder(shining(lamp + ball, "\"float power\" 100")).image);
    const double expected = rho * Le * .16 * 100 / (pi * 4 * pi * .64);
    EXPECT_NEAR(seen.mean.g, expected, standardErrors * seen.error.g + .002 * expected);
    EXPECT_LT(seen.error.g, .005 * expected);
}

// Nothing of it passes a wall.
TEST(ImplicitLight, AWallBlocksIt) {
    const std::string wall = "AttributeBegin Translate 0 1.1 0 Rotate 90 1 0 0 Shape \"disk\" \"float radius\" 9 AttributeEnd\n";
    View view = atTheOrigin();
    view.lookAt = "0 .5 -1  0 0 0  0 1 0";
    EXPECT_EQ(estimate(render(sceneText(view, shining(lamp + ball) + wall + floorShape), withLamps()).image).mean, glm::dvec3(0));
}

/// Both strategies together, and BSDF sampling alone, which knows nothing of how lights are sampled.
void expectStrategiesAgree(const std::string& lights, const std::string& integrator = "") {
    View view = atTheOrigin();
    view.samples = 512;
    view.more = integrator;
    const std::string scene = sceneText(view, lights + floorShape);
    RenderSetup bsdfOnly = withLamps();
    bsdfOnly.edit = [](PackedScene& s) {
        for (light& l : s.tables.lights) l.pmf = 0;
        s.frame().lights_in_tree = s.frame().infinite_count = 0;
    };
    const Rendered both = render(scene, withLamps()), bsdf = render(scene, bsdfOnly);
    expectEqualMeans(both, bsdf, .03);
    EXPECT_LT(estimate(both.image).error.g, estimate(bsdf.image).error.g);
}

const std::string ring = "Translate .4 1.5 0 Rotate 50 1 2 3 Scale 1 .8 -1.2 Shape \"implicit\" \"string F\" "
                         "\"(x^2 + y^2 + z^2 + a^2 - b^2)^2 - 4*a^2*(x^2 + z^2)\" \"float a\" .7 \"float b\" .25 "
                         "\"point3 bounds\" [-1.1 -.4 -1.1  1.1 .4 1.1] ";

// A ring, which rays meet up to four times, stretched and mirrored; with an image; with a sheet that ends at its box and shines on both
// sides; chosen by a tree.
TEST(ImplicitLight, StrategiesAgree) {
    expectStrategiesAgree(shining(ring));
    expectStrategiesAgree("AttributeBegin AreaLightSource \"diffuse\" \"bool twosided\" true \"float scale\" 2 \"string filename\" \""
                          EIKONAL_SOURCE_DIR "/scenes/assets/tiles.png\" " + ring + " AttributeEnd\n");
    const std::string sheet = shining("Translate 0 1 .5 Shape \"implicit\" \"string F\" \"y - x*z\" \"point3 bounds\" [-1 -.9 -1  1 .9 1]",
                                      "\"bool twosided\" true");
    expectStrategiesAgree(sheet);
    expectStrategiesAgree(sheet + shining(ring) + shining("Translate -2 1 0 Scale .3 .3 .3 " + ball),
                          "Integrator \"volpath\" \"integer maxdepth\" 1 \"string lightsampler\" \"bvh\"");
}

/// The same scene with the ball and with the sphere.
void expectLikeASphere(const std::string& before, const std::string& after, const RenderSetup& setup, double resolution) {
    View view = atTheOrigin(6);
    view.samples = 1024;
    const auto seen = [&](const std::string& shape) {
        return render(sceneText(view, before + shining(lamp + "Scale 1 .7 1.2 " + shape) + after), setup);
    };
    expectEqualMeans(seen(ball), seen(quadric), resolution);
}

// In a shell of glass only rays that the glass refracts find it; in fog light samples from all over the fog do, too.
TEST(ImplicitLight, ShinesThroughGlassAndFog) {
    expectLikeASphere("", "AttributeBegin Translate 0 2 0 Material \"dielectric\" Shape \"sphere\" \"float radius\" 1.2 AttributeEnd\n" +
                      floorShape, withLamps(), .05);
    expectLikeASphere("MakeNamedMedium \"fog\" \"string type\" \"homogeneous\" \"rgb sigma_a\" [.1 .1 .1] \"rgb sigma_s\" [.3 .3 .3] "
                      "MediumInterface \"\" \"fog\" ",
                      "MediumInterface \"fog\" \"\" AttributeBegin Translate 0 2 0 Material \"interface\" "
                      "Shape \"sphere\" \"float radius\" 1.9 AttributeEnd MediumInterface \"\" \"\" " + floorShape, {}, .03);
}

// The image does not depend on how many paths are in flight.
TEST(ImplicitLight, KeepsItsBits) {
    View view = atTheOrigin(4);
    view.fov = 60;
    view.samples = 8;
    const std::string scene = sceneText(view, shining(lamp + ball + "\"float alpha\" .5") + shining(ring) + floorShape);
    RenderSetup few = withLamps();
    few.shape.wavePaths = 700;
    expectSameBits(render(scene, withLamps()).image, render(scene, few).image, "waves");
}

}  // namespace
}  // namespace eikonal
