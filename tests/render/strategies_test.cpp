// Three ways to the same number: BSDF sampling, light sampling, and both weighted against each other.

#include "kind_features.h"
#include "lit_floor.h"
#include "test_paths.h"

#include <algorithm>

namespace eikonal {
namespace {

// Direct light on a rough metal and a diffuse floor under a large and a small lamp, by both strategies weighted against each other, by BSDF
// sampling alone (the light sampler never picks a light: `pmf` 0 in its table, include/eikonal/light.h), and by light sampling alone
// (lamps with an alpha of 0 cannot be hit, but shine, as in pbrt-v4). All have the same expectation.
void expectStrategiesAgree(const std::string& material, const std::string& lamps) {
    View view = atTheOrigin(1);
    view.samples = 1024;
    const auto scene = [&](const std::string& alpha) {
        std::string shining = lamps;
        for (size_t at; (at = shining.find("@")) != std::string::npos;) shining.replace(at, 1, alpha);
        return sceneText(view, shining + "\nMaterial " + material + "\nShape \"disk\" \"float radius\" 9 ");
    };
    view.more = "";
    RenderSetup bsdfOnly = surfaces();
    bsdfOnly.edit = [](PackedScene& s) { for (light& l : s.tables.lights) l.pmf = 0; };
    const Rendered both = render(scene(""), surfaces()), bsdf = render(scene(""), bsdfOnly),
                   light = render(scene("\"float alpha\" 0"), surfaces());
    expectEqualMeans(both, bsdf, 0.03);
    expectEqualMeans(both, light, 0.03);
    /* And weighting pays: neither strategy alone has less noise than both by more than chance */
    const double noise = estimate(both.image).error.g;
    EXPECT_LT(noise, 1.5 * std::min(estimate(bsdf.image).error.g, estimate(light.image).error.g));
}

const std::string lamps = R"(Rotate -90 1 0 0
    AttributeBegin AreaLightSource "diffuse" "rgb L" [1 1 1] Translate 0 -2 1.4 Rotate 60 1 0 0 Shape "sphere" "float radius" .8 @
        AttributeEnd
    AttributeBegin AreaLightSource "diffuse" "rgb L" [9 9 9] Translate .3 1 2 ReverseOrientation Shape "disk" "float radius" .4 @
        AttributeEnd
    AttributeBegin AreaLightSource "diffuse" "rgb L" [2 2 2] "bool twosided" true Shape "trianglemesh" "point3 P" [-1 1 1  -1 3 1  -1.5 2 2]
        @ AttributeEnd)";

TEST(Strategies, AgreeOnADiffuseFloor) { expectStrategiesAgree("\"diffuse\"", lamps); }
TEST(Strategies, AgreeOnRoughMetal) { expectStrategiesAgree("\"conductor\" \"float roughness\" .3", lamps); }

// The same with a light tree: what a path finds by itself has the probability of the tree, which depends on where it came from.
TEST(Strategies, AgreeWithALightTree) {
    View view = atTheOrigin(2);
    view.samples = 1024;
    view.more = "Integrator \"volpath\" \"integer maxdepth\" 2 \"string lightsampler\" \"bvh\"";
    RenderSetup bsdfOnly = surfaces();
    bsdfOnly.edit = [](PackedScene& s) {
        for (light& l : s.tables.lights) l.pmf = 0;
        s.frame().lights_in_tree = s.frame().infinite_count = 0;
    };
    for (const char* material : {"\"diffuse\"", "\"conductor\" \"float roughness\" .3"}) {
        SCOPED_TRACE(material);
        std::string shining = lamps;
        for (size_t at; (at = shining.find("@")) != std::string::npos;) shining.replace(at, 1, "");
        const std::string text = sceneText(view, shining + "\nMaterial " + material + "\nShape \"disk\" \"float radius\" 9 ");
        const Rendered both = render(text, surfaces()), bsdf = render(text, bsdfOnly);
        expectEqualMeans(both, bsdf, 0.03);
        EXPECT_LT(estimate(both.image).error.g, 1.5 * estimate(bsdf.image).error.g);
    }
}

// A curve whose width is no small part of the distance to the lamps behind it. Rays begin a width away from the curve, on their side of it:
// light samples have to know how the lamps are seen from there.
TEST(Strategies, AgreeOnACurveLitFromBehind) {
    View view;
    view.lookAt = "0 -2 0  0 0 .02  0 0 1";
    view.samples = 1024;
    view.maxDepth = 1;
    RenderSetup both = surfaces();
    both.forced.require(KindFeature::SHAPE_IMPLICIT);   // then the kernels are those of Furnace.WhiteThingsOfEveryShapeCannotBeSeen
    RenderSetup bsdfOnly = both;
    bsdfOnly.edit = [](PackedScene& s) { for (light& l : s.tables.lights) l.pmf = 0; };
    for (const std::string lamp : {"Translate .1 .6 .1 Shape \"sphere\" \"float radius\" .25",
                                   "Translate .1 .4 .1 Rotate 70 1 0 0 ReverseOrientation Shape \"disk\" \"float radius\" .3"}) {
        SCOPED_TRACE(lamp);
        const std::string text = sceneText(view, emitter(lamp) + R"(
            Material "diffusetransmission" "rgb reflectance" [.3 .3 .3] "rgb transmittance" [.7 .7 .7]
            Shape "curve" "string type" "cylinder" "float width" .1 "point3 P" [-1 0 0  -.5 0 0  .5 0 0  1 0 0])");
        expectEqualMeans(render(text, both), render(text, bsdfOnly), 0.01);
    }
}

// Where a patch folds, both of its sides look down, and each point emits on its own side; where vertex normals turn over, each point emits
// on theirs.
TEST(Strategies, AgreeOnFoldedLamps) {
    View view = atTheOrigin(1);
    view.samples = 1024;
    RenderSetup bsdfOnly = surfaces();
    bsdfOnly.edit = [](PackedScene& s) {
        for (light& l : s.tables.lights) l.pmf = 0;
        s.frame().lights_in_tree = 0;
    };
    const std::string below = "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [1 1 1] ReverseOrientation Translate .5 2 0 "
                              "Rotate -90 1 0 0 Shape \"disk\" \"float radius\" .2 AttributeEnd\n";
    for (const char* lamp : {R"(Shape "bilinearmesh" "point3 P" [-1 1.5 -1  -1 1.6 1  1 1.5 -1  -.6 1.3 0])",
                             R"(Shape "trianglemesh" "point3 P" [-1 1 -1  -1 1 1  1 1 0] "normal N" [.1 -1 0  .1 -1 0  .1 3 0])",
                             R"(Shape "bilinearmesh" "point3 P" [-1 1 -1  -1 1 1  1 1 -1  1 1 1]
                                 "normal N" [0 1 0  .1 1 0  .1 -2 0  .1 -1 0])"}) {
        SCOPED_TRACE(lamp);
        const std::string text = sceneText(view, floorShape + below + emitter(lamp));
        const Rendered both = render(text, surfaces());
        EXPECT_GT(estimate(both.image).mean.g, .01);
        expectEqualMeans(both, render(text, bsdfOnly), 0.02);
    }
}

// Two skies: paths find by themselves the one that is the same everywhere, and light samples go to that of an image. Where directions do
// not follow the BSDF, both are sampled. Both have the same expectation.
TEST(Strategies, AgreeUnderASky) {
    View following = atTheOrigin(1);
    following.samples = 1024;
    View uniform = following;
    uniform.more = "Integrator \"simplepath\" \"bool samplebsdf\" false \"integer maxdepth\" 1";
    const std::string world =
        "LightSource \"infinite\" \"rgb L\" [.3 .3 .3]\nLightSource \"infinite\" \"string filename\" \"" EIKONAL_SOURCE_DIR
        "/scenes/assets/tiles.png\"\n"
        "Material \"conductor\" \"float roughness\" .3\nTranslate 0 -1 0 Shape \"sphere\"";
    expectEqualMeans(render(sceneText(following, world), surfaces()), render(sceneText(uniform, world), surfaces()), 0.01);
}

}  // namespace
}  // namespace eikonal
