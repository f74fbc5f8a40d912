// Render passes: each holds the light that its name says, and they sum to the image.

#include "both_ends.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace eikonal {
namespace {

PackedScene packWithPasses(const std::string& text) {
    PackedScene scene = packScene(text);
    scene.require(Feature::RENDER_PASSES, "the test");
    return scene;
}
Rendered renderPasses(const std::string& text, const RenderSetup& setup = {}) { return render(packWithPasses(text), setup); }

/// In each pixel, within what rounding the sums changes: of colours of wavelengths, some are negative.
void expectSum(const FilmImage& image) {
    const auto absolute = [](glm::vec3 v) { return glm::abs(glm::dvec3(v)); };
    size_t wrong = 0;
    for (size_t i = 0; i < image.pixelCount(); ++i) {
        const glm::dvec3 sum = glm::dvec3(image.emission[i]) + glm::dvec3(image.direct[i]) + glm::dvec3(image.indirect[i]) +
                               glm::dvec3(image.volume[i]);
        const glm::dvec3 size = absolute(image.emission[i]) + absolute(image.direct[i]) + absolute(image.indirect[i]) +
                                absolute(image.volume[i]);
        for (int c = 0; c < 3; ++c)
            wrong += !(std::abs(sum[c] - static_cast<double>(image.color[i][c])) <= 1e-5 * std::max({size.r, size.g, size.b}));
    }
    EXPECT_EQ(wrong, 0u) << "values that are not the sum of their passes";
}

void expectGreen(const Rendered& r, double emission, double direct, double indirect, double volume, double tolerance) {
    EXPECT_NEAR(meanGreen(r.image.emission), emission, tolerance);
    EXPECT_NEAR(meanGreen(r.image.direct), direct, tolerance);
    EXPECT_NEAR(meanGreen(r.image.indirect), indirect, tolerance);
    EXPECT_NEAR(meanGreen(r.image.volume), volume, tolerance);
}

/// Every pixel sees the same point.
View narrow() { return {}; }

struct Case {
    std::string name, directive, world;
    bool isInMedium = false;   ///< whether the scene has light of a volume
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }
class RenderPasses : public testing::TestWithParam<Case> {};

const std::string sky = "LightSource \"infinite\" \"rgb L\" [.3 .4 .5]\n";
const std::string smoke = R"(MakeNamedMedium "smoke" "string type" "homogeneous" "rgb sigma_a" [.1 .2 .3] "rgb sigma_s" [3 2 1]
    MakeNamedMedium "flame" "string type" "uniformgrid" "integer nx" 2 "integer ny" 2 "integer nz" 1 "float density" [1 3 0 2]
        "point3 p0" [-.5 -.5 -.5] "point3 p1" [.5 .5 .5] "rgb Le" [1 .5 .2]
    AttributeBegin Material "interface" Translate 0 .9 -.4 MediumInterface "smoke" "" Shape "sphere" "float radius" .5
        MediumInterface "flame" "smoke" Shape "sphere" "float radius" .3 AttributeEnd
)";

/// The image is that without passes, bit for bit; and of any waves, ranges of samples and crops, the passes have the same bits.
TEST_P(RenderPasses, SumToTheImageAndKeepItsBits) {
    View v = view();
    v.samples = 32;
    const std::string text = sceneWith(v, GetParam().directive, room + panel + GetParam().world);
    RenderSetup setup;
    setup.contraction = false;
    const Rendered with = renderPasses(text, setup);
    EXPECT_EQ(with.invalid.count, 0u);
    expectSum(with.image);
    EXPECT_GT(meanGreen(with.image.direct), 0);
    EXPECT_EQ(meanGreen(with.image.volume) > 0, GetParam().isInMedium);
    expectSameBits(with.image, render(text, setup).image, "without passes");
    setup.shape.wavePaths = 1000;
    setup.splits = {24};
    expectSameBits(with.image, renderPasses(text, setup).image, "in small waves and two ranges of samples");
}

INSTANTIATE_TEST_SUITE_P(
    Of, RenderPasses,
    testing::Values(
        Case{"paths", "", sky + ball("\"dielectric\"")},
        Case{"wavelengths_a_filter_and_a_limit",
             "PixelFilter \"mitchell\" Film \"spectral\" \"integer xresolution\" 24 \"integer yresolution\" 24 "
             "\"float maxcomponentvalue\" .5",
             sky + ball("\"diffuse\"")},
        Case{"media", "", sky + smoke, true},
        Case{"a_subsurface_body", "", ball("\"subsurface\" \"rgb reflectance\" [.5 .5 .5] \"rgb mfp\" [.1 .1 .1]")},
        Case{"a_tree_of_rays", "Integrator \"whitted\"", sky + ball("\"dielectric\"")},
        Case{"light_paths", "Integrator \"bdpt\" \"integer maxdepth\" 6", sky + ball("\"dielectric\"")},
        Case{"merging", "Integrator \"vcm\" \"integer maxdepth\" 6", sky + ball("\"dielectric\"")}),
    [](const auto& info) { return info.param.name; });

/// Within a ball that emits 1 and reflects 0.5, light of n bounces is 0.5^n: of at most five.
TEST(RenderPassesOf, AFurnaceAreItsBounces) {
    View v = narrow();
    v.lookAt = "0 0 0  0 0 1  0 1 0";
    const std::string world =
        "AreaLightSource \"diffuse\" \"rgb L\" [1 1 1] Material \"diffuse\" \"rgb reflectance\" [.5 .5 .5] ReverseOrientation "
        "Shape \"sphere\"";
    expectGreen(renderPasses(sceneText(v, world)), 1, .5, .25 + .125 + .0625 + .03125, 0, 5e-3);
}

/// A surface that emits 3, behind a medium of thickness 1 that lets exp(-0.5) of it through, and itself emits (1 - exp(-0.5)) 2.
TEST(RenderPassesOf, AMediumThatEmitsAreOfTheVolume) {
    View v = narrow();
    const std::string world = R"(MakeNamedMedium "glow" "string type" "homogeneous" "rgb sigma_a" [.5 .5 .5]
            "rgb sigma_s" [0 0 0] "rgb Le" [2 2 2]
        AttributeBegin Material "interface" MediumInterface "glow" "" Shape "sphere" "float radius" .5 AttributeEnd
        AttributeBegin AreaLightSource "diffuse" "rgb L" [3 3 3] ReverseOrientation
        Material "diffuse" "rgb reflectance" [0 0 0] Shape "bilinearmesh" "point3 P" [-9 -9 2  9 -9 2  -9 9 2  9 9 2] AttributeEnd)";
    expectGreen(renderPasses(sceneText(v, world)), 3 * std::exp(-.5), 0, 0, 2 * (1 - std::exp(-.5)), 1e-4);
}

/// A mirror that shows a lamp, and a lamp before the camera: a surface comes first, and nothing.
TEST(RenderPassesOf, ALampInAMirrorIsDirectLight) {
    View v = narrow();
    const std::string mirror = R"(Material "conductor" "rgb reflectance" [.5 .5 .5] "float roughness" 0
        Shape "bilinearmesh" "point3 P" [-1 -1 0  1 -1 0  -1 1 0  1 1 0] LightSource "infinite" "rgb L" [2 2 2])";
    expectGreen(renderPasses(sceneText(v, mirror)), 0, 1, 0, 0, 2e-2);
    expectGreen(renderPasses(sceneText(v, "LightSource \"infinite\" \"rgb L\" [2 2 2]")), 2, 0, 0, 0, 1e-6);
}

/// Paths from both ends find the light of each pass, too: what they splat and merge is of the right one.
class PassesOfLightPaths : public testing::TestWithParam<const char*> {};
TEST_P(PassesOfLightPaths, AreThoseOfPathsFromTheCamera) {
    View v = view();
    v.width = v.height = 16;
    const std::string text = sceneWith(v, "", room + panel);
    const Rendered camera = renderPasses(text), both = renderPasses(withIntegrator(GetParam(), text));
    for (const auto pass : {&FilmImage::emission, &FilmImage::direct, &FilmImage::indirect})
        EXPECT_NEAR(meanGreen(both.image.*pass), meanGreen(camera.image.*pass), .01 * meanGreen(camera.image.*pass));
}
INSTANTIATE_TEST_SUITE_P(Of, PassesOfLightPaths, testing::Values("\"bdpt\"", "\"vcm\""),
                         [](const auto& info) { return std::string(info.param).substr(1, std::string(info.param).size() - 2); });

}  // namespace
}  // namespace eikonal
