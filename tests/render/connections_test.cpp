// Connections of paths from both ends. LightPaths.* say that "bdpt", which makes them, has the light of paths from the camera. Here: that
// they are made, that they pay where light arrives by way of another surface, and that neither waves nor parts show, with merging, too.

#include "both_ends.h"

#include "pack/cached_hits.h"

#include <cmath>

namespace eikonal {
namespace {

/// A narrow spotlight on the ceiling: all of the room is lit from a spot there, which few paths from the camera hit, and which is not seen.
const std::string indirect = R"(LightSource "spot" "rgb I" [40 36 30] "point3 from" [0 1.5 -2] "point3 to" [0 2 -2] "float coneangle" 15
    AttributeBegin Material "diffuse" "rgb reflectance" [.8 .8 .8]
    Shape "bilinearmesh" "point3 P" [-1 2 -3  -1 2 1  1 2 -3  1 2 1] AttributeEnd
)";

PackedScene withoutConnections(const std::string& text) {
    PackedScene scene = packScene(text);
    scene.features = scene.features.without(Feature::CONNECTIONS);
    return scene;
}

double varianceOf(const FilmImage& image) {
    double sum = 0;
    for (const float v : image.variance) sum += static_cast<double>(v);
    return sum;
}

TEST(Connections, LowerTheErrorWhereLightArrivesFromASurface) {
    View v = view();
    v.samples = 64;
    const std::string text = withIntegrator("\"bdpt\"", sceneText(v, room + indirect + ball("\"diffuse\"")));
    const FilmImage with = render(text).image, without = render(withoutConnections(text)).image;
    const Estimate a = meanOf(with), b = meanOf(without);
    EXPECT_NEAR(a.mean.g, b.mean.g, standardErrors * std::hypot(a.error.g, b.error.g));
    EXPECT_LT(varianceOf(with), varianceOf(without) / 2);
}

TEST(Connections, AreMadeByBdptAndVcm) {
    const auto connects = [](const std::string& integrator, const std::string& world) {
        return packScene(withIntegrator(integrator, sceneText(view(), room + panel + world))).features.has(Feature::CONNECTIONS);
    };
    EXPECT_TRUE(connects("\"bdpt\"", ""));
    EXPECT_TRUE(connects("\"vcm\"", ""));
    EXPECT_FALSE(connects("\"sppm\"", ""));
    EXPECT_FALSE(connects("\"volpath\"", ""));
    EXPECT_TRUE(connects("\"bdpt\"", "ActiveTransform EndTime Translate .1 0 0 ActiveTransform All " + ball("\"diffuse\"")));
}

class ConnectionsEquality : public testing::TestWithParam<ColorMode> {
protected:
    PackedScene scene() const {
        View v = view();
        v.samples = 24;
        return packScene(withIntegrator("\"vcm\" \"float radius\" .03", sceneText(v, room + indirect + ball("\"dielectric\""))),
                         GetParam());
    }
    const Rendered reference = render(scene());
};

TEST_P(ConnectionsEquality, WavesAndBatchesDoNotShow) { expectSameBitsInAnyWaves(scene(), reference.image); }
TEST_P(ConnectionsEquality, SamplesMayComeInParts) { expectSameBitsInRangesOfSamples(scene(), reference.image); }
TEST_P(ConnectionsEquality, ACropHasThePixelsOfTheWhole) { expectSameBitsInACrop(scene(), reference.image); }
INSTANTIATE_TEST_SUITE_P(In, ConnectionsEquality, testing::Values(ColorMode::rgb, ColorMode::spectral),
                         [](const auto& info) { return std::string(info.param == ColorMode::rgb ? "rgb" : "wavelengths"); });

/// Glass that disperses leaves paths from both ends a single wavelength each, which counts for all just once.
TEST(ConnectionsOfWavelengths, HaveTheLightOfPathsFromTheCamera) {
    const std::string text = sceneText(view(), room + panel + ball("\"dielectric\" \"spectrum eta\" \"glass-F11\""));
    const Rendered camera = render(packScene(text, ColorMode::spectral)),
                   both = render(packScene(withIntegrator("\"bdpt\"", text), ColorMode::spectral));
    const Estimate a = meanOf(camera.image), b = meanOf(both.image);
    EXPECT_NEAR(a.mean.g, b.mean.g, standardErrors * std::hypot(a.error.g, b.error.g) + 3e-3 * a.mean.g);   // passes share wavelengths
    EXPECT_LT(a.error.g, 0.01 * a.mean.g);
}

/// Where more than the camera moves, the paths of a pass have the same time.
TEST(ConnectionsInTime, HaveTheLightOfPathsFromTheCamera) {
    const std::string text = sceneText(view(), room + panel + moving + ball("\"diffuse\""));
    expectSameLight(text, withIntegrator("\"bdpt\"", text), 5e-3);
}

/// Of many light paths, few are kept, and each camera path finds one: the light is the same.
TEST(ConnectionsOfAShare, HaveTheLightOfAll) {
    const std::string text = withIntegrator("\"bdpt\"", sceneText(view(), room + indirect + ball("\"diffuse\"")));
    PackedScene few = packScene(text);
    few.frame().cached_share = 5;   // 576 pixels: groups of 32
    const Estimate a = meanOf(render(packScene(text)).image), b = meanOf(render(few).image);
    EXPECT_NEAR(a.mean.g, b.mean.g, standardErrors * std::hypot(a.error.g, b.error.g));
}

/// What is kept at a time stays below a GiB, whatever the image and the length of paths; and a pass has room for all that it keeps.
TEST(ConnectionsPlan, IsBounded) {
    for (const auto& [side, depth] : {std::pair(1, 5), {24, 5}, {2900, 5}, {2900, 100}, {16000, 1000}}) {
        View v = view();
        v.width = v.height = side;
        v.maxDepth = depth;
        const PackedScene scene = packScene(withIntegrator("\"bdpt\"", sceneText(v, room + panel)));
        const HitCachePlan plan = planHitCache(scene);
        EXPECT_LT(plan.hits, size_t{1} << 22) << side;
        EXPECT_GE(plan.hits, plan.paths * static_cast<size_t>(std::min(depth, 11))) << side;
        EXPECT_EQ(plan.paths, plan.passes * std::max<size_t>(static_cast<size_t>(side) * side >> scene.frame().cached_share, 1));
        EXPECT_GE(plan.passes, 1u);
    }
}

}  // namespace
}  // namespace eikonal
