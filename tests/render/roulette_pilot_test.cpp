// Russian roulette by a rule that a few pilot paths have chosen: it changes the noise and the time, and nothing else.

#include "rendering.h"

namespace eikonal {
namespace {

/// Of an image with 16 samples or more there is a pilot.
constexpr int side = 256;

/// Inside of a sphere that a small one lights.
std::string hall(double reflectance, int samples = 16, const std::string& integrator = "\"volpath\" \"integer maxdepth\" 12") {
    View view;
    view.lookAt = "0 0 0  .3 -.2 1  0 1 0";
    view.fov = 60;
    view.width = view.height = side;
    view.samples = samples;
    view.sampler = "sobol";
    view.more = "Integrator " + integrator + "\n";
    const std::string rho = std::to_string(reflectance);
    return sceneText(
        view,
        "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [5 5 5] Translate 0 .8 0 Shape \"sphere\" \"float radius\" .1 AttributeEnd\n"
        "Material \"diffuse\" \"rgb reflectance\" [" +
            rho + " " + rho + " " + rho + "] ReverseOrientation Shape \"sphere\"");
}

bool isSame(const Roulette& a, const Roulette& b) { return a.rule == b.rule && a.scale == b.scale && a.depth == b.depth; }

TEST(RoulettePilot, KeepsTheExpectation) {
    const PackedScene chosen = packScene(hall(.6));
    PackedScene fixed = chosen;
    fixed.roulette = {RouletteRule::root, 1, 1000};
    setRoulette(fixed.frame(), *fixed.roulette);
    const Rendered with = render(chosen), without = render(fixed);
    EXPECT_FALSE(isSame(with.roulette, {})) << "the pilot has not been heard";
    EXPECT_TRUE(isSame(without.roulette, *fixed.roulette)) << "what the user asks for counts";
    expectEqualMeans(with, without, 0.02);
}

// Surfaces that take nearly everything away have their paths ended sooner than those that take little.
TEST(RoulettePilot, HeedsTheScene) {
    const Roulette dark = render(hall(.1)).roulette, bright = render(hall(.8)).roulette;
    EXPECT_FALSE(isSame(dark, bright)) << dark.scale << " from " << dark.depth;
}

TEST(RoulettePilot, WavesPartsAndSeedsHaveTheSameRule) {
    const PackedScene scene = packScene(hall(.6));
    const Rendered whole = render(scene);
    RenderSetup smaller;
    smaller.shape.wavePaths = 1024;   // a pilot of several batches
    const Rendered small = render(scene, smaller);
    expectSameBits(whole.image, small.image, "smaller waves");
    PackedScene part = scene;
    part.pixels = {20, 10, 241, 133};
    expectSameBits(whole.image, render(part).image, "a part of the image");
    PackedScene other = scene;
    other.frame().seed = 77;
    EXPECT_TRUE(isSame(render(other).roulette, whole.roulette));
    EXPECT_TRUE(isSame(small.roulette, whole.roulette));
}

// Short renders, and integrators without roulette, keep the default.
TEST(RoulettePilot, LeavesTheRestAlone) {
    for (const std::string integrator : {"\"whitted\"", "\"direct\"", "\"ambientocclusion\""})
        EXPECT_TRUE(isSame(render(hall(.6, 16, integrator)).roulette, {})) << integrator;
    EXPECT_TRUE(isSame(render(hall(.6, 15)).roulette, {}));
}

}  // namespace
}  // namespace eikonal
