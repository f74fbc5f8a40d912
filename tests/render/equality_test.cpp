// What must not change a bit of the image: how the work is cut and laid over the device, and what kernels could do besides.

#include "kind_features.h"
#include "rendering.h"
#include "run_program.h"

#include "image/image_file.h"
#include "kinds/medium_kind.h"

#include <fmt/format.h>

#include <algorithm>

namespace eikonal {
namespace {

View view() {
    View v;
    v.lookAt = "0 1 -5  0 0 0  0 1 0";
    v.fov = 40;
    v.width = 24; v.height = 20;
    v.samples = 8;
    v.maxDepth = 6;
    v.sampler = "zsobol";
    return v;
}

/// Every kind of surface, light and texture but images.
const std::string surfaceWorld = R"(
LightSource "infinite" "rgb L" [.3 .4 .5]
LightSource "point" "rgb I" [5 5 5] "point3 from" [1 3 -3]
LightSource "spot" "rgb I" [9 5 5] "point3 from" [-2 3 -3] "point3 to" [0 0 0]
LightSource "distant" "rgb L" [.3 .3 .1] "point3 from" [1 1 -1] "point3 to" [0 0 0]
AttributeBegin AreaLightSource "diffuse" "rgb L" [4 4 4] Translate 0 2 0 Rotate 90 1 0 0 Shape "disk" "float radius" .5 AttributeEnd
AttributeBegin AreaLightSource "diffuse" "rgb L" [2 4 4] "bool twosided" true
    Shape "bilinearmesh" "point3 P" [1.5 0 0  1.5 0 1  1.5 1 0  1.6 1 1] AttributeEnd
AttributeBegin AreaLightSource "diffuse" "rgb L" [4 4 1] Translate -1.6 .5 0 Shape "sphere" "float radius" .2 AttributeEnd
Texture "check" "spectrum" "checkerboard" "float uscale" 4 "float vscale" 4 "rgb tex1" [.8 .2 .1] "rgb tex2" [.1 .2 .8]
Texture "half" "spectrum" "scale" "texture tex" "check" "float scale" .5
Texture "mixed" "spectrum" "mix" "texture tex1" "check" "texture tex2" "half" "float amount" .3
Texture "holes" "float" "checkerboard" "float uscale" 8 "float vscale" 8 "float tex1" 0
Texture "waves" "float" "checkerboard" "float uscale" 9 "float vscale" 9 "float tex1" .02 "float tex2" 0
Texture "rough" "float" "mix" "float tex1" .1 "float tex2" .5 "float amount" .5
ObjectBegin "ball" Material "conductor" "texture roughness" "rough" Shape "sphere" "float radius" .4 ObjectEnd
AttributeBegin Translate -.9 .5 0 ObjectInstance "ball" Translate .2 .7 .5 Scale .5 .8 .5 ObjectInstance "ball" AttributeEnd
AttributeBegin Translate -.9 -.5 0 Material "dielectric" "float roughness" 0 Shape "sphere" "float radius" .4 AttributeEnd
AttributeBegin Translate 0 -.5 -.5 Material "dielectric" "float uroughness" .3 "float vroughness" .1 Shape "sphere" "float radius" .4
    AttributeEnd
AttributeBegin Translate .9 -.5 0 Material "coateddiffuse" "texture reflectance" "mixed" Shape "sphere" "float radius" .4 AttributeEnd
AttributeBegin Translate .9 .5 0 Material "conductor" "float roughness" 0 Shape "sphere" "float radius" .4 "float zmin" -.2 AttributeEnd
AttributeBegin Translate -.3 -.8 .4 ActiveTransform EndTime Translate .5 .4 0 Rotate 60 1 2 3 ActiveTransform All Material "diffuse"
    Shape "sphere" "float radius" .3 AttributeEnd
AttributeBegin Translate -.5 .9 .5 Material "subsurface" "rgb reflectance" [.8 .5 .3] "rgb mfp" [.2 .1 .05] Shape "sphere" "float radius" .3
    AttributeEnd
AttributeBegin Translate 0 .4 -.8 Material "thindielectric" Shape "disk" "float radius" .4 AttributeEnd
MakeNamedMaterial "paint" "string type" "diffuse" "texture reflectance" "mixed" "texture displacement" "waves"
MakeNamedMaterial "leaf" "string type" "diffusetransmission"
Material "mix" "string materials" ["paint" "leaf"] "float amount" .4
Shape "trianglemesh" "point3 P" [-2 -2 1  2 -2 1  2 2 1  -2 2 1] "integer indices" [0 1 2 0 2 3] "point2 uv" [0 0 1 0 1 1 0 1]
    "texture alpha" "holes"
Material "diffuse" Shape "bilinearmesh" "point3 P" [-3 -1 -3  3 -1 -3  -3 -1 3  3 -1 3]
)";
/// Media of both kinds in interfaces and glass, in each other, with a lamp inside.
const std::string mediumWorld = surfaceWorld + R"(
MakeNamedMedium "smoke" "string type" "homogeneous" "rgb sigma_a" [.1 .2 .3] "rgb sigma_s" [3 2 1] "float g" .4
MakeNamedMedium "flame" "string type" "uniformgrid" "integer nx" 2 "integer ny" 2 "integer nz" 1 "float density" [1 3 0 2]
    "point3 p0" [-.5 -.5 -.5] "point3 p1" [.5 .5 .5] "rgb Le" [1 .5 .2]
AttributeBegin Material "interface" Translate 0 .2 -1
    MediumInterface "smoke" "" Shape "sphere" "float radius" .9
    MediumInterface "flame" "smoke" Shape "sphere" "float radius" .5
AttributeEnd
AttributeBegin Translate -1.5 -.5 -1 Material "subsurface" "string method" "randomwalk" "float roughness" .2 "rgb reflectance" [.8 .5 .3]
    "rgb mfp" [.2 .1 .05] Shape "sphere" "float radius" .3 AttributeEnd
AttributeBegin Material "dielectric" MediumInterface "smoke" "" Translate 1.5 -.5 -1 Shape "sphere" "float radius" .4 AttributeEnd
AttributeBegin AreaLightSource "diffuse" "rgb L" [20 20 20] Material "diffuse" MediumInterface "" "smoke" Translate -.6 .2 -1.2
    Shape "sphere" "float radius" .05 AttributeEnd
)";

/// Every feature but those that choose another method, where the same image is only the same on average: wavelengths, a filter's table, a
/// sampler, a lens of radius 0, a camera of another kind or one that moves nowhere, frames along the surface, curves (with them, light is
/// sampled from where the next ray starts), another integrator, and media, with which strategies are weighted by the balance heuristic
/// instead of the power heuristic.
Features allButMethods() {
    using enum Feature;
    Features methods;
    for (Feature f : {SPECTRAL, SPECTRAL_FILM, DISPERSION, ANISOTROPY, STRIPS, KindFeature::SHAPE_CURVE, KindFeature::SHAPE_IMPLICIT,
                      FILTER, SOBOL, JOINT_PAIRS, LENS, CAMERA_MOTION, MEDIA, EQUIANGULAR, AMBIENT_OCCLUSION, RAY_SPLITTING,
                      UNIFORM_DIRECTIONS, FORCE_DIFFUSE, FIREFLIES, LIGHT_PATHS, CONNECTIONS, MERGING})
        methods.require(f);
#define REQUIRE(name, FEATURE) methods.require(KindFeature::FEATURE);
#define REQUIRE_CAMERA(name, FEATURE, CODE, RAYS) REQUIRE(name, FEATURE)
    CAMERAS(REQUIRE_CAMERA)
#undef REQUIRE_CAMERA
#undef REQUIRE
    for (const MediumKind& e : mediumKindList()) methods.require(e.feature);
    Features features;
    for (size_t i = 0; i < featureCount(); ++i)
        if (!methods.has(static_cast<Feature>(i))) features.require(static_cast<Feature>(i));
    return features;
}

/// Contracted or not, kernels are the same in all of these; without contraction they are shared with the tests of features below.
RenderSetup plain() {
    RenderSetup setup;
    setup.contraction = false;
    return setup;
}

class Equality : public testing::TestWithParam<std::string> {
protected:
    const std::string text = sceneText(view(), GetParam() == "media" ? mediumWorld : surfaceWorld);
    const Rendered reference = render(text, plain());
};

TEST_P(Equality, TheSceneIsWorthComparing) {
    EXPECT_EQ(reference.invalid.count, 0u);
    size_t lit = 0;
    for (const glm::vec3& c : reference.image.color) lit += c.r > 0;
    EXPECT_EQ(lit, reference.image.color.size());
}
TEST_P(Equality, TwoRunsAreTheSame) { expectSameBits(reference.image, render(text, plain()).image, "again"); }

TEST_P(Equality, WaveSizeAndTilesDoNotShow) {
    for (unsigned paths : {64u, 1000u, 65472u}) {
        RenderSetup setup = plain();
        setup.shape.wavePaths = paths;
        expectSameBits(reference.image, render(text, setup).image, fmt::format("{} paths in a wave", paths));
    }
}

TEST_P(Equality, HowManyBatchesAreInFlightDoesNotShow) {
    for (unsigned batches : {1u, 3u, static_cast<unsigned>(MOST_BATCHES)}) {
        RenderSetup setup = plain();
        setup.shape.wavePaths = 1000;
        setup.shape.batches = batches;
        expectSameBits(reference.image, render(text, setup).image, fmt::format("{} batches", batches));
    }
}

// What is in flight when a render is ended is finished: each pixel is that of a render of as many samples as it got.
TEST_P(Equality, AnEndedRenderHasWholeSamples) {
    RenderSetup setup = plain();
    setup.shape.wavePaths = 300;
    setup.batches = 10;
    const Rendered ended = render(text, setup);
    EXPECT_FALSE(ended.result.isFinished);
    const auto [fewest, most] = std::ranges::minmax(ended.image.sampleCount);
    EXPECT_GE(fewest, static_cast<float>(ended.result.samples));
    ASSERT_LT(fewest, reference.image.sampleCount.front());
    ASSERT_GT(most, 0);
    PackedScene scene = packScene(text);
    for (int n = static_cast<int>(std::max(fewest, 1.0f)); n <= static_cast<int>(most); ++n) {
        scene.samples = n;
        const FilmImage whole = render(scene, plain()).image;
        for (size_t i = 0; i < whole.pixelCount(); ++i)
            if (ended.image.sampleCount[i] == static_cast<float>(n)) {
                ASSERT_EQ(ended.image.color[i], whole.color[i]) << n << " samples, pixel " << i;
            }
    }
}

TEST_P(Equality, SamplesMayComeInParts) {
    for (const std::vector<unsigned>& splits : {std::vector<unsigned>{1}, {3, 4, 7}}) {
        RenderSetup setup = plain();
        setup.splits = splits;
        expectSameBits(reference.image, render(text, setup).image, fmt::format("in {} parts", splits.size() + 1));
    }
}

TEST_P(Equality, ACropHasThePixelsOfTheWhole) {
    PackedScene scene = packScene(text);
    scene.pixels = {5, 3, 18, 16};
    const Rendered crop = render(scene, plain());
    ASSERT_EQ(crop.image.pixelCount(), 13u * 13u);
    expectSameBits(reference.image, crop.image, "the crop");
}

// Adaptive sampling decides from what the film holds after whole passes, and the film is the same however the passes were cut.
TEST_P(Equality, WaveSizeDoesNotShowInAdaptiveSampling) {
    PackedScene scene = packScene(text);
    RenderSetup setup = plain();
    setup.targetError = 1e-9;
    scene.samples = 16;
    const double first = render(scene, setup).result.error.value();
    scene.samples = 512;
    /* An error that some of the blocks need more samples for */
    Rendered adaptive;
    float fewest = 0, most = 0;
    for (double share = 0.99; share > 0.1 && fewest == most; share *= 0.9) {
        setup.targetError = share * first;
        adaptive = render(scene, setup);
        fewest = std::ranges::min(adaptive.image.sampleCount);
        most = std::ranges::max(adaptive.image.sampleCount);
    }
    ASSERT_LT(fewest, most) << "nothing to decide";
    for (unsigned paths : {64u, 1000u, 65472u}) {
        setup.shape.wavePaths = paths;
        expectSameBits(adaptive.image, render(scene, setup).image, fmt::format("{} paths in a wave", paths));
    }

    /* A pixel with n samples is that pixel of a render of n */
    for (int n = 16; n <= 512; n *= 2) {
        scene.samples = n;
        const FilmImage uniform = render(scene, plain()).image;
        for (size_t i = 0; i < uniform.pixelCount(); ++i)
            if (adaptive.image.sampleCount[i] == static_cast<float>(n)) {
                ASSERT_EQ(adaptive.image.color[i], uniform.color[i]) << n << " samples, pixel " << i;
            }
    }
}

INSTANTIATE_TEST_SUITE_P(Of, Equality, testing::Values("surfaces", "media"));

/// With kernels built anew, which takes most of the time: one world holds both.
class OtherKernels : public testing::Test {
protected:
    const std::string text = sceneText(view(), mediumWorld);
    const Rendered reference = render(text, plain());
};

using SlowKernels = OtherKernels;

// The number of slots in a run and the size of work-groups decide who handles an item, never what becomes of it.
TEST_F(SlowKernels, LocalSizeAndRunDoNotShow) {
    RenderSetup setup = plain();
    setup.shape.localSize = 16;
    setup.shape.itemsPerWorkItem = 8;
    expectSameBits(reference.image, render(text, setup).image, "groups of 16, runs of 8");
}

// Kernels that know only what the scene requires, and kernels that know everything there is.
TEST_F(OtherKernels, FeaturesThatTheSceneDoesNotRequireDoNotShow) {
    RenderSetup everything = plain();
    everything.forced = allButMethods();
    everything.allStages = true;
    expectSameBits(reference.image, render(text, everything).image, "all features");
}

// Simple scenes, where nearly everything is left out.
TEST(MinimalFeatures, GiveTheSameImageAsAll) {
    for (
        const char* world :
        {R"(LightSource "point" "rgb I" [9 9 9] "point3 from" [2 3 -3] Material "diffuse"
            Shape "trianglemesh" "point3 P" [-2 -1 1  2 -1 1  2 2 1  -2 2 1] "integer indices" [0 1 2 0 2 3])",
         R"(LightSource "infinite" "rgb L" [1 1 1] Material "conductor" "float roughness" .2 Shape "sphere")",
         R"(AreaLightSource "diffuse" "rgb L" [1 1 1] Material "diffuse" ReverseOrientation Shape "sphere" "float radius" 9)"}) {
        RenderSetup minimal, everything;
        minimal.contraction = everything.contraction = false;
        everything.forced = allButMethods();
        everything.allStages = true;
        const std::string text = sceneText(view(), world);
        expectSameBits(render(text, minimal).image, render(text, everything).image, world);
    }
}

// Threads are PoCL's, and decided when it starts: two processes.
class Threads : public ProgramTest {};
TEST_F(Threads, DoNotShow) {
    write("scene.pbrt", sceneText(view(), mediumWorld));
    for (const char* threads : {"1", "2"}) {
        const Outcome run = this->run({"render", "scene.pbrt", "-o", std::string(threads) + ".exr", "--aov", "all", "--nthreads", threads,
                                       "--contraction", "off", "--spp", "64", "--target-error", "0.15"});
        ASSERT_EQ(run.status, 0) << run.error;
    }
    expectSameBits(readImage(path("1.exr")).image, readImage(path("2.exr")).image, "one thread and two");
}

}  // namespace
}  // namespace eikonal
