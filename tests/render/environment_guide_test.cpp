// A room with a window under an even sky: light samples that aim at the window by the environment guide change the noise and nothing else.

#include "rendering.h"

namespace eikonal {
namespace {

/// A room of 4 x 4 x 4, of whose ceiling an eighth is missing. Enough samples for a survey.
std::string room(const std::string& inside, const std::string& integrator) {
    View view;
    view.lookAt = "0 -1.5 0  1.2 -2 .7  0 1 0";
    view.width = view.height = 64;
    view.samples = 96;
    view.sampler = "sobol";
    view.more = "Integrator " + integrator + " \"integer maxdepth\" 4\n";
    return sceneText(view, R"(LightSource "infinite" "rgb L" [1 2 3]
        Material "diffuse" "rgb reflectance" [.6 .5 .4]
        Shape "trianglemesh" "point3 P" [-2 -2 -2  2 -2 -2  2 2 -2  -2 2 -2  -2 -2 2  2 -2 2  2 2 2  -2 2 2]
            "integer indices" [0 1 2 0 2 3  4 5 6 4 6 7  0 4 7 0 7 3  1 5 6 1 6 2  0 1 5 0 5 4]
        Shape "trianglemesh" "point3 P" [-2 2 -2  1 2 -2  1 2 2  -2 2 2] "integer indices" [0 1 2 0 2 3]
        Shape "trianglemesh" "point3 P" [1 2 -2  2 2 -2  2 2 0  1 2 0] "integer indices" [0 1 2 0 2 3])" +
                               inside);
}

const std::string withLights = "\"volpath\"", withoutLights = "\"simplepath\" \"bool samplelights\" false";

TEST(EnvironmentGuide, ARoomIsAsBrightAsWithoutIt) {
    for (const std::string inside : {"",
                                     "\nMaterial \"diffusetransmission\" AttributeBegin Translate 0 -1.5 0 Rotate 30 1 0 0 Translate .6 "
                                     "-.1 .4 Shape \"disk\" \"float radius\" .5 AttributeEnd"}) {
        const PackedScene guided = packScene(room(inside, withLights)), alone = packScene(room(inside, withoutLights));
        ASSERT_TRUE(guided.features.has(Feature::ENVIRONMENT_GUIDE));
        ASSERT_FALSE(alone.features.has(Feature::ENVIRONMENT_GUIDE));
        const Rendered with = render(guided), without = render(alone);
        expectEqualMeans(with, without, 0.02);
        EXPECT_LT(estimate(with.image).error.g, 0.9 * estimate(without.image).error.g);
    }
}

// In a medium, points look in all directions.
TEST(EnvironmentGuide, FogInARoomIsAsBrightAsWithoutIt) {
    const std::string fog =
        "\nAttributeBegin Material \"interface\" MakeNamedMedium \"fog\" \"string type\" \"homogeneous\" \"rgb sigma_a\" [.1 .1 .1] \"rgb "
        "sigma_s\" [.3 .3 .3] "
        "MediumInterface \"fog\" \"\" Translate 1 -1.8 .6 Shape \"sphere\" \"float radius\" 1.1 AttributeEnd";
    const PackedScene guided = packScene(room(fog, withLights));
    ASSERT_TRUE(guided.features.has(Feature::ENVIRONMENT_GUIDE));
    RenderSetup unsampled;   // a sky that light samples never choose
    unsampled.shape.wavePaths = 16384;
    PackedScene alone = guided;
    alone.samples = 64;      // too few for a survey
    expectEqualMeans(render(guided), render(alone, unsampled), 0.02);
}

TEST(EnvironmentGuide, WavesAndPartsOfTheImageHaveTheSameBits) {
    expectSameBitsInWavesAndParts(packScene(room("", withLights)), {20, 10, 41, 33});
}

// In the open there is nothing to learn: paths find the sky, and no shadow ray is cast.
TEST(EnvironmentGuide, LeavesOpenScenesAlone) {
    View view;
    view.width = view.height = 64;
    view.samples = 96;
    PackedScene scene = packScene(
        sceneText(view, "LightSource \"infinite\" \"rgb L\" [1 1 1]\nMaterial \"diffuse\" \"rgb reflectance\" [1 1 1] Shape \"sphere\""));
    ASSERT_TRUE(scene.features.has(Feature::ENVIRONMENT_GUIDE));
    expectRadiance(render(scene), 1, 0.001);
    for (const glm::vec3& c : render(scene).image.color) ASSERT_NEAR(c.g, 1, 1e-5);
    scene.isAlwaysGuided = true;
    expectRadiance(render(scene), 1, 0.01);
}

}  // namespace
}  // namespace eikonal
