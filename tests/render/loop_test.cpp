// The wavefront against the same functions in a plain loop for each path (kernels/stages/loop.cl): queues, routing and compaction must not
// show.

#include "rendering.h"

#include <gtest/gtest.h>

namespace eikonal {
namespace {

View view() {
    View v;
    v.lookAt = "0 1 -5  0 0 0  0 1 0";
    v.fov = 40;
    v.width = 24; v.height = 20;
    v.samples = 8;
    return v;
}

const char* const worlds[] = {
    R"(LightSource "infinite" "rgb L" [.3 .4 .5]
AttributeBegin AreaLightSource "diffuse" "rgb L" [9 8 7] Translate 0 3 0 Rotate 90 1 0 0 Shape "disk" AttributeEnd
Material "diffuse" "rgb reflectance" [.5 .6 .7] Shape "trianglemesh" "point3 P" [-5 -1 -5  5 -1 -5  5 -1 5  -5 -1 5]
    "integer indices" [0 1 2 0 2 3]
Material "coateddiffuse" "float roughness" .2 Shape "sphere"
AttributeBegin Translate 1.5 0 0 Material "conductor" "float uroughness" .1 "float vroughness" .4 Shape "sphere" "float radius" .5
    AttributeEnd
AttributeBegin Translate -1.5 0 0 Material "dielectric" "float roughness" .3 Shape "sphere" "float radius" .5 AttributeEnd)",
    R"(LightSource "infinite" "rgb L" [.3 .4 .5]
Material "diffuse" "rgb reflectance" [.5 .6 .7] Shape "trianglemesh" "point3 P" [-5 -1 -5  5 -1 -5  5 -1 5  -5 -1 5]
    "integer indices" [0 1 2 0 2 3]
Material "hair" Shape "sphere" "float radius" .8
AttributeBegin Translate 1.5 0 0 Material "coatedconductor" "float interface.roughness" .1 Shape "sphere" "float radius" .5 AttributeEnd)",
    R"(LightSource "point" "rgb I" [9 9 9] "point3 from" [2 3 -3]
MakeNamedMedium "m" "string type" "homogeneous" "rgb sigma_a" [.1 .5 1] "rgb sigma_s" [3 2 1] "float g" .5
Material "diffuse" Shape "trianglemesh" "point3 P" [-5 -1 -5  5 -1 -5  5 -1 5  -5 -1 5] "integer indices" [0 1 2 0 2 3]
MediumInterface "m" "" Material "interface" Shape "sphere" Translate 2 0 0 Material "dielectric" Shape "sphere" "float radius" .5
Texture "skin" "spectrum" "checkerboard" "float uscale" 9 "rgb tex1" [.8 .5 .3] "rgb tex2" [.4 .5 .6]
Translate -4 0 0 Material "subsurface" "texture reflectance" "skin" "rgb mfp" [.2 .1 .05] Shape "sphere" "float radius" .5
Translate 1 -.5 -1 Material "subsurface" "string method" "randomwalk" "float roughness" .2 "rgb reflectance" [.8 .5 .3]
    "rgb mfp" [.2 .1 .05] Shape "sphere" "float radius" .4)",
    R"(LightSource "point" "rgb I" [9 9 9] "point3 from" [2 3 -3]
MakeNamedMedium "m" "string type" "homogeneous" "rgb sigma_s" [3 2 1] AttributeBegin MediumInterface "m" "" Material "interface"
ActiveTransform EndTime Translate -1 0 0 ActiveTransform All Shape "sphere" AttributeEnd
ObjectBegin "a" Material "conductor" "float roughness" 0 Shape "sphere" "float radius" .4 ActiveTransform EndTime Rotate 70 1 2 3
    Shape "disk" ObjectEnd
AttributeBegin ActiveTransform EndTime Translate 0 1 0 ObjectInstance "a" AttributeEnd AttributeBegin Translate 1.5 0 0 ObjectInstance "a"
    AttributeEnd
Material "diffuse" Shape "trianglemesh" "point3 P" [-5 -1 -5  5 -1 -5  5 -1 5  -5 -1 5] "integer indices" [0 1 2 0 2 3])",
    R"(LightSource "infinite" "rgb L" [.3 .4 .5]
MakeNamedMedium "colours" "string type" "rgbgrid" "integer nx" 2 "rgb sigma_a" [.1 .5 1 1 .5 .1] "rgb sigma_s" [3 2 1 1 2 3]
    "rgb Le" [.01 0 0 0 .01 0]
MakeNamedMedium "cloud" "string type" "cloud" "rgb sigma_s" [5 5 5] "rgb sigma_a" [0 0 0]
MakeNamedMedium "fire" "string type" "uniformgrid" "float density" 3 "float temperature" 4000 "float Lescale" .05
MediumInterface "colours" "" Material "interface" Translate -.5 -.5 -.5 Shape "sphere"
MediumInterface "cloud" "colours" Shape "sphere" "float radius" .5 MediumInterface "fire" "cloud" Shape "sphere" "float radius" .3)",
    R"(LightSource "infinite" "rgb L" [.3 .4 .5] "point3 portal" [-2 -1 4  -2 2 4  2 2 4  2 -1 4]
AttributeBegin AreaLightSource "diffuse" "rgb L" [9 8 7] Translate 0 3 0 Rotate 90 1 0 0 Shape "disk" AttributeEnd
LightSource "point" "rgb I" [2 2 2] "point3 from" [2 1 -3] LightSource "spot" "rgb I" [9 2 2] "point3 from" [-2 3 -1] "point3 to" [0 0 0]
AttributeBegin AreaLightSource "diffuse" "rgb L" [30 30 30] Translate -2 0 -1 Shape "sphere" "float radius" .1 AttributeEnd
Material "diffuse" "rgb reflectance" [.5 .6 .7] Shape "trianglemesh" "point3 P" [-5 -1 -5  5 -1 -5  5 -1 5  -5 -1 5]
    "integer indices" [0 1 2 0 2 3]
Material "conductor" "float roughness" .2 Shape "sphere")"};

/// The last of these worlds chooses its lights by a tree.
std::string textOf(const char* world) {
    View v = view();
    if (world == std::end(worlds)[-1]) v.more = "Integrator \"volpath\" \"string lightsampler\" \"bvh\"";
    return sceneText(v, world);
}

void expectSameBitsIn(const char* world) {
    PackedScene scene = packScene(textOf(world));
    scene.require(Feature::AOVS, "the test");
    RenderSetup setup;
    setup.contraction = false;
    expectSameBits(render(scene, setup).image, renderInLoop(scene, setup), world);
}

/* Each world is two sets of kernels to compile: some are left to the slow tests */
TEST(Loop, GivesTheSameBitsAsTheWavefront) {
    for (size_t i : {0, 2, 3}) expectSameBitsIn(worlds[i]);
}
TEST(SlowLoop, GivesTheSameBitsOfRarerThings) {
    for (size_t i : {1, 4, 5}) expectSameBitsIn(worlds[i]);
}

TEST(SlowLoop, GivesTheSameBitsOfSurfacesThatAreForcedToBeDiffuse) {
    for (size_t i : {0, 1}) {
        PackedScene scene = packScene("Option \"forcediffuse\" true " + textOf(worlds[i]));
        scene.require(Feature::AOVS, "the test");
        RenderSetup setup;
        setup.contraction = false;
        expectSameBits(render(scene, setup).image, renderInLoop(scene, setup), worlds[i]);
    }
}

TEST(SlowLoop, GivesTheSameBitsAtWavelengths) {
    /* The second scene has glass that disperses */
    std::string dispersive = worlds[1];
    dispersive += "\nTranslate -4 0 0 Material \"dielectric\" \"spectrum eta\" \"glass-F11\" Shape \"sphere\"";
    for (const std::string& world : {std::string(worlds[0]), dispersive}) {
        const PackedScene scene = packScene(sceneText(view(), world), ColorMode::spectral);
        RenderSetup setup;
        setup.contraction = false;
        expectSameBits(render(scene, setup).image, renderInLoop(scene, setup), world);
    }
}

// With the shipped flags a*b+c may be fused in one program and not in the other.
TEST(SlowLoop, AgreesWithTheShippedFlags) {
    for (const char* world : worlds) {
        const PackedScene scene = packScene(textOf(world));
        const RenderSetup setup;
        const Estimate wave = estimate(render(scene, setup).image), loop = estimate(renderInLoop(scene, setup));
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(loop.mean[c] / wave.mean[c], 1, 1e-4) << world;
    }
}

/// Adaptive sampling gives both the same batches: several blocks, of different numbers of samples.
TEST(Loop, GivesTheSameBitsInAdaptiveSampling) {
    PackedScene scene = packScene(textOf(worlds[0]));
    scene.require(Feature::AOVS, "the test");
    scene.samples = 64;
    RenderSetup setup;
    setup.contraction = false;
    setup.targetError = 0.1;
    expectSameBits(render(scene, setup).image, renderInLoop(scene, setup), "adaptive");
}

}  // namespace
}  // namespace eikonal
