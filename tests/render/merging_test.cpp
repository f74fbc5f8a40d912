// Merging of vertices: the same light as paths from the camera find where those find it; what no other strategy finds, against what can be
// derived; and the same bits, however the passes are divided.

#include "both_ends.h"

#include "pack/light_vertices.h"

#include <fmt/format.h>

#include <cmath>

namespace eikonal {
namespace {

/// Merges within a radius that is small beside all edges of the room.
std::string merging(const std::string& text, const std::string& radius = ".03") {
    return withIntegrator("\"sppm\" \"float radius\" " + radius, text);
}

struct Case {
    std::string name, world;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }
class Merging : public testing::TestWithParam<Case> {};

/// But for a bias of half a percent: edges within a radius, and neighbours whose sums share light paths, so that their mean is noisier than
/// the film says.
TEST_P(Merging, GivesTheImageOfPathsFromTheCamera) {
    const std::string text = sceneText(view(), room + GetParam().world);
    expectSameLight(text, merging(text), 5e-3);
}

INSTANTIATE_TEST_SUITE_P(
    With, Merging,
    testing::Values(Case{"matte", panel + ball("\"diffuse\"")}, Case{"clear_glass", panel + ball("\"dielectric\"")},
                    Case{"rough_glass", panel + ball("\"dielectric\" \"float roughness\" .3")},
                    Case{"rough_metal", panel + ball("\"conductor\" \"float roughness\" .2")},
                    Case{"a_coat", panel + ball("\"coateddiffuse\" \"float roughness\" 0")},
                    Case{"a_leaf", panel + ball("\"diffusetransmission\" \"rgb reflectance\" [.3 .3 .3] \"rgb transmittance\" [.5 .4 .3]")},
                    Case{"vertex_normals", panel + R"(Material "diffuse" Shape "trianglemesh"
                         "point3 P" [-.8 .3 .3  .8 .3 .3  0 1.6 .6] "normal N" [-1 0 -1  1 0 -1  0 1 -.5])"},
                    Case{"a_sky", "LightSource \"infinite\" \"rgb L\" [.4 .5 .6]\n" + ball("\"diffuse\"")},
                    Case{"a_spot", "LightSource \"spot\" \"rgb I\" [9 8 7] \"point3 from\" [.4 1.9 -.4] \"float coneangle\" 40\n" +
                                       ball("\"diffuse\"")},
                    Case{"a_moving_ball", panel + moving + ball("\"dielectric\"")},
                    Case{"a_turning_instance", panel + "ObjectBegin \"o\"" + ball("\"diffuse\"") +
                                                   "ObjectEnd ActiveTransform EndTime Rotate 60 0 1 0 Scale 1 1.3 1 ActiveTransform All "
                                                   "ObjectInstance \"o\""}),
    [](const auto& info) { return info.param.name; });

/// A ball of a few facets with the normals of a round one. Light that grazes a facet does not graze the next, which is within the radius.
std::string ballOfFacets() {
    constexpr int rows = 8, columns = 12;
    std::string points, normals, indices;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const double theta = M_PI * row / rows, phi = 2 * M_PI * column / columns;
            const glm::dvec3 n{std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
            points += fmt::format("{:.6f} {:.6f} {:.6f} ", .6 * n.x, .6 * n.y + .8, .6 * n.z);
            normals += fmt::format("{:.6f} {:.6f} {:.6f} ", n.x, n.y, n.z);
            if (row == rows) continue;
            const int here = row * columns + column, beside = row * columns + (column + 1) % columns;
            indices += fmt::format("{} {} {} {} {} {} ", here, beside, here + columns, beside, beside + columns, here + columns);
        }
    return fmt::format(R"(Material "diffuse" Shape "trianglemesh" "point3 P" [{}] "normal N" [{}] "integer indices" [{}])", points, normals,
                       indices);
}
TEST(MergingOnFacets, GivesTheImageOfPathsFromTheCamera) {
    const std::string floor = "Material \"diffuse\" Shape \"bilinearmesh\" \"point3 P\" [-5 0 -5  5 0 -5  -5 0 5  5 0 5]\n";
    const std::string light = lamp("Translate -1 2.5 .5 Rotate 90 1 0 0 Scale .5 .7 1 Shape \"bilinearmesh\" \"point3 P\" "
                                   "[-1 -1 0  1 -1 0  -1 1 0  1 1 0]");
    View v = view();
    v.width = v.height = 48;
    v.samples = 96;
    const std::string text = sceneText(v, light + floor + ballOfFacets());
    expectSameLight(text, merging(text, ".3"), 5e-3);
}

/// Mirrors and mixes that an option makes diffuse have vertices like all diffuse surfaces.
TEST(MergingOnMirrorsMadeDiffuse, GivesTheImageOfPathsFromTheCamera) {
    const std::string mixes = R"(MakeNamedMaterial "matte" "string type" "diffuse"
        MakeNamedMaterial "mirror" "string type" "conductor" "float roughness" 0
        MakeNamedMaterial "half" "string type" "mix" "string materials" ["matte" "mirror"] "float amount" .5
        AttributeBegin NamedMaterial "half" Translate -.5 .4 .3 Shape "sphere" "float radius" .3 AttributeEnd )";
    const std::string text = sceneWith(view(), "Option \"forcediffuse\" true",
                                       room + panel + mixes + ball("\"conductor\" \"float roughness\" 0"));
    expectSameLight(text, merging(text), 5e-3);
}

/// The floor of a pool under still water, lit from above and seen from above, both at right angles: the light passes the surface, is
/// scattered by the floor, and passes the surface again. `maxdepth` 3 leaves out what returns to the floor.
struct Pool {
    static constexpr double eta = 1.33, reflectance = .5, height = 2, depth = 1;
    static constexpr const char* matte = "Material \"diffuse\" \"rgb reflectance\" [.5 .5 .5]\n";
    static std::string text(const std::string& light, int samples, const std::string& floor = matte, const std::string& alpha = "") {
        View v;
        v.lookAt = "0 9 0  0 0 0  0 0 1";
        v.fov = .5;
        v.samples = samples;
        v.maxDepth = 3;
        return sceneText(v, light + floor + R"(
            Shape "bilinearmesh" "point3 P" [-3 -1 -3  3 -1 -3  -3 -1 3  3 -1 3] )" + alpha + R"(
            Material "dielectric" "float eta" 1.33 Shape "bilinearmesh" "point3 P" [-3 0 3  3 0 3  -3 0 -3  3 0 -3])");
    }
    /// What is seen of an irradiance at the floor. Radiance that leaves water is spread over more directions.
    static double radiance(double irradiance) { return irradiance * reflectance / M_PI * transmittance() / (eta * eta); }
    static double transmittance() { return 1 - std::pow((eta - 1) / (eta + 1), 2); }
};

/// radius: within which the floor is lit evenly.
void expectOnlyMergingFinds(const std::string& light, const std::string& radius, double radiance, const std::string& floor = Pool::matte,
                            const std::string& alpha = "", double mostError = .03) {
    const std::string few = Pool::text(light, 16, floor, alpha);
    EXPECT_EQ(estimate(render(few).image).mean.g, 0);
    EXPECT_EQ(estimate(render(withIntegrator("\"bdpt\"", few)).image).mean.g, 0);
    const Rendered merged = render(merging(Pool::text(light, 4096, floor, alpha), radius));
    /* All pixels see one point, so they share light paths: the error is that between passes, as each pixel tells */
    double variance = 0;
    for (const float v : merged.image.variance) variance += static_cast<double>(v) / static_cast<double>(merged.image.pixelCount());
    EXPECT_EQ(merged.invalid.count, 0u);
    EXPECT_NEAR(estimate(merged.image).mean.g, radiance, standardErrors * std::sqrt(variance) + 3e-3 * radiance);
    EXPECT_LT(std::sqrt(variance), mostError * radiance) << "too few samples to tell";
}

/// A light at a point: rays of a small angle a arrive at the distance a (height + depth / eta) from the middle.
TEST(MergingInAPool, FindsASpotlight) {
    const double irradiance = 4 * Pool::transmittance() / std::pow(Pool::height + Pool::depth / Pool::eta, 2);
    expectOnlyMergingFinds("LightSource \"spot\" \"rgb I\" [4 4 4] \"point3 from\" [0 2 0] \"point3 to\" [0 0 0]\n", ".2",
                           Pool::radiance(irradiance));
}
/// Of the floor a share is there, for paths from both ends: what is seen is that share, not its square.
TEST(MergingInAPool, CountsAShareOfTheFloorOnce) {
    const std::string light = "LightSource \"distant\" \"rgb L\" [4 4 4] \"point3 from\" [0 1 0] \"point3 to\" [0 0 0]\n";
    const double whole = Pool::radiance(4 * Pool::transmittance());
    expectOnlyMergingFinds(light, ".6", .3 * whole, Pool::matte, "\"float alpha\" .3", .1);
    const std::string materials = R"(MakeNamedMaterial "matte" "string type" "diffuse" "rgb reflectance" [.5 .5 .5]
        MakeNamedMaterial "mirror" "string type" "conductor" "float roughness" 0
        MakeNamedMaterial "half" "string type" "mix" "string materials" ["matte" "mirror"] "float amount" .5 )";
    expectOnlyMergingFinds(light, ".6", .25 * whole, materials + R"(MakeNamedMaterial "quarter" "string type" "mix"
        "string materials" ["mirror" "half"] "float amount" .5 NamedMaterial "quarter")", "", .1);
}
/// The sun: the floor is lit as evenly as the water.
TEST(MergingInAPool, FindsTheSun) {
    expectOnlyMergingFinds("LightSource \"distant\" \"rgb L\" [4 4 4] \"point3 from\" [0 1 0] \"point3 to\" [0 0 0]\n", ".6",
                           Pool::radiance(4 * Pool::transmittance()));
}

/// A black plate leaves the lamp and the camera free for three quarters of the time, both at once: paths that merge have the same time.
/// With times of their own it would be 9/16.
TEST(MergingInAPool, FindsASpotlightBesideAMovingPlate) {
    const double irradiance = 4 * Pool::transmittance() / std::pow(Pool::height + Pool::depth / Pool::eta, 2);
    const std::string plate = R"(AttributeBegin ActiveTransform EndTime Translate -20 0 0 ActiveTransform All
        Material "diffuse" "rgb reflectance" [0 0 0] Shape "bilinearmesh" "point3 P" [-99 1 -9  5 1 -9  -99 1 9  5 1 9] AttributeEnd )";
    expectOnlyMergingFinds("LightSource \"spot\" \"rgb I\" [4 4 4] \"point3 from\" [0 2 0] \"point3 to\" [0 0 0]\n" + plate, ".2",
                           Pool::radiance(irradiance) * 3 / 4);
}

class MergingEquality : public testing::TestWithParam<const char*> {
protected:
    static std::string text() {
        View v = view();
        v.samples = 24;
        v.sampler = GetParam();
        return merging(
            sceneWith(v, "PixelFilter \"gaussian\"",
                      room + panel + "LightSource \"point\" \"rgb I\" [2 2 2] \"point3 from\" [-.5 1.5 -.6]\n" + moving +
                          ball("\"dielectric\"")));
    }
    /// At wavelengths and times, which the paths of a pass share.
    static PackedScene scene() { return packScene(text(), ColorMode::spectral); }
    const Rendered reference = render(scene());
};

TEST_P(MergingEquality, WavesAndBatchesDoNotShow) { expectSameBitsInAnyWaves(scene(), reference.image); }
TEST_P(MergingEquality, SamplesMayComeInParts) { expectSameBitsInRangesOfSamples(scene(), reference.image); }
TEST_P(MergingEquality, ACropHasThePixelsOfTheWhole) { expectSameBitsInACrop(scene(), reference.image); }
INSTANTIATE_TEST_SUITE_P(Of, MergingEquality, testing::Values("zsobol", "independent"),
                         [](const auto& info) { return std::string(info.param); });

/// Blocks with different numbers of samples merge with the light paths of the same passes.
TEST(MergingAdaptively, EndsWithTheErrorAskedFor) {
    RenderSetup setup;
    PackedScene scene = packScene(merging(sceneWith(view(), "", room + panel + ball("\"dielectric\""))));
    scene.samples = 1024;
    setup.targetError = 0.05;
    const Rendered adaptive = render(scene, setup);
    ASSERT_TRUE(adaptive.result.error.has_value());
    EXPECT_LE(*adaptive.result.error, 0.05);
    const Estimate a = meanOf(adaptive.image),
                   b = meanOf(render(merging(sceneWith(view(), "", room + panel + ball("\"dielectric\"")))).image);
    EXPECT_NEAR(a.mean.g, b.mean.g, standardErrors * std::hypot(a.error.g, b.error.g) + 5e-3 * b.mean.g);
}

/// What is stored at a time stays below a GiB, whatever the image and the length of paths; and a pass has room for all that it stores.
TEST(MergingPlan, IsBounded) {
    for (const auto& [side, depth] : {std::pair(1, 5), {24, 5}, {2900, 5}, {2900, 100}, {16000, 1000}}) {
        View v = view();
        v.width = v.height = side;
        v.maxDepth = depth;
        const PackedScene scene = packScene(merging(sceneText(v, room + panel)));
        const VertexPlan plan = planVertices(scene);
        EXPECT_LT(static_cast<double>(plan.vertices) * 100 + static_cast<double>(plan.buckets) * 4, 1 << 30) << side;
        const double paths = std::ldexp(static_cast<double>(side) * side, -static_cast<int>(scene.frame().stored_share));
        EXPECT_GE(static_cast<double>(plan.vertices), plan.passes * paths * std::min(depth, 11)) << side;
        EXPECT_GE(plan.passes, 1u);
    }
}

}  // namespace
}  // namespace eikonal
