// A sphere that is given by a formula is a sphere: whatever is done to it, the image is that of the quadric.

#include "kind_features.h"
#include "rendering.h"

#include <fmt/format.h>

#include <cmath>

namespace eikonal {
namespace {

const std::string quadric = "Shape \"sphere\"",
                  formula = "Shape \"implicit\" \"string F\" \"x^2 + y^2 + z^2 - 1\" \"point3 bounds\" [-1.1 -1.1 -1.1  1.1 1.1 1.1]";

/// Nearly every path finds the same points, so that the images are far closer to each other than to their expectation.
void expectSameImage(const std::string& before, const std::string& after) {
    View view;
    view.lookAt = "0 2 -6  0 .6 0  0 1 0";
    view.fov = 35;
    view.width = view.height = 32;
    view.samples = 64;
    view.maxDepth = 8;
    const std::string room = R"(LightSource "infinite" "rgb L" [.3 .4 .5]
        AttributeBegin AreaLightSource "diffuse" "rgb L" [20 18 15] Translate 1 4 -1 Rotate 90 1 0 0 Shape "disk" "float radius" .5
            AttributeEnd
        Material "diffuse" "rgb reflectance" [.6 .5 .4] Shape "bilinearmesh" "point3 P" [-5 -.5 -5  5 -.5 -5  -5 -.5 5  5 -.5 5] )";
    /* The same kernels for both, in which directions along the surface, which are not the same, have no part */
    RenderSetup both;
    both.forced.require(KindFeature::SHAPE_SPHERE).require(KindFeature::SHAPE_IMPLICIT).require(Feature::INSTANCES);
    const Rendered a = render(sceneText(view, room + before + quadric + after), both),
                   b = render(sceneText(view, room + before + formula + after), both);
    EXPECT_EQ(a.invalid.count + b.invalid.count, 0u);
    const Estimate x = estimate(a.image), y = estimate(b.image);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(x.mean[c], y.mean[c], 0.01 * x.mean[c]) << before;
    size_t different = 0;
    for (size_t i = 0; i < a.image.color.size(); ++i)
        different += std::abs(a.image.color[i].g - b.image.color[i].g) > 0.02f * a.image.color[i].g;
    EXPECT_LT(different, a.image.color.size() / 10) << before;
}

TEST(Implicit, ABallIsABall) {
    /* Not mirrored, which turns quadrics inside out, as in pbrt-v4 */
    const std::string stretched = "Translate .3 .7 0 Rotate 40 1 2 3 Scale 1.2 .7 .9 ";
    /* Not a coat, whose walk draws its numbers from the bits of directions */
    expectSameImage("Material \"conductor\" \"float roughness\" .3 ReverseOrientation " + stretched, "");
    expectSameImage("Translate 0 .6 0 Material \"dielectric\" \"float eta\" 1.5 ", "");
    expectSameImage("Material \"diffuse\" ObjectBegin \"a\" " + stretched,
                    "ObjectEnd ObjectInstance \"a\" Translate -1.5 0 1 Scale .5 .5 .5 ObjectInstance \"a\"");
}

/// The same ball as a root that only touches zero; and a ring around the y axis, whose tube rays along z meet twice.
const std::string thin = "Shape \"implicit\" \"string F\" \"(x^2 + y^2 + z^2 - 1)^2\" \"point3 bounds\" [-1.1 -1.1 -1.1  1.1 1.1 1.1]";
const std::string ring =
    "Shape \"implicit\" \"string F\" \"(x^2 + y^2 + z^2 + a^2 - b^2)^2 - 4 * a^2 * (x^2 + z^2)\" \"float a\" .7 \"float b\" .35 \"point3 "
    "bounds\" [-1.1 -.4 -1.1  1.1 .4 1.1]";

/// The ring of triangles, with its normals.
std::string ringOfTriangles() {
    constexpr int n = 96, m = 48;
    std::string p, normals, indices;
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < m; ++k) {
            const double around = 2 * M_PI * i / n, across = 2 * M_PI * k / m, c = std::cos(across), s = std::sin(across);
            p += fmt::format(" {} {} {}", (.7 + .35 * c) * std::cos(around), .35 * s, (.7 + .35 * c) * std::sin(around));
            normals += fmt::format(" {} {} {}", c * std::cos(around), s, c * std::sin(around));
            const int a = i * m + k, b = i * m + (k + 1) % m, d = (i + 1) % n * m + k, e = (i + 1) % n * m + (k + 1) % m;
            indices += fmt::format(" {} {} {} {} {} {}", a, b, d, b, e, d);
        }
    return "Shape \"trianglemesh\" \"integer indices\" [" + indices + "] \"point3 P\" [" + p + "] \"normal N\" [" + normals + "]";
}

/// Stretched, mirrored, turned and moved, in an object and out of one: between a lamp and a floor, on which half of what is seen is its
/// shadow.
TEST(Implicit, ARingIsItsTriangles) {
    View view;
    view.lookAt = "0 3 -5  0 .3 0  0 1 0";
    view.fov = 35;
    view.width = view.height = 32;
    view.samples = 64;
    const std::string room =
        R"(AttributeBegin AreaLightSource "diffuse" "rgb L" [20 18 15] Translate 1 4 -1 Rotate 90 1 0 0 Shape "disk" "float radius" .5
            AttributeEnd
        LightSource "infinite" "rgb L" [.05 .05 .05] Material "diffuse"
            Shape "bilinearmesh" "point3 P" [-5 -.5 -5  5 -.5 -5  -5 -.5 5  5 -.5 5] )";
    RenderSetup both = surfaces();
    both.forced.require(KindFeature::SHAPE_IMPLICIT);
    const auto seen = [&](const std::string& shape) {
        return render(
            sceneText(view, room + "ObjectBegin \"ring\" Material \"conductor\" \"float roughness\" .3 Rotate 70 1 0 0 Scale 1 .8 -1.2 " +
                                shape +
                                " ObjectEnd AttributeBegin Translate .8 .7 0 Scale -.7 1 .7 ObjectInstance \"ring\" AttributeEnd\n"
                                "AttributeBegin Material \"dielectric\" Translate -.8 .6 0 Rotate 50 1 1 0 Scale 1 -1 .7 " +
                                shape + " AttributeEnd"),
            both);
    };
    const Rendered a = seen(ring), b = seen(ringOfTriangles());
    EXPECT_EQ(a.invalid.count + b.invalid.count, 0u);
    const Estimate x = estimate(a.image), y = estimate(b.image);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(x.mean[c], y.mean[c], 0.01 * y.mean[c]);
    size_t different = 0;
    for (size_t i = 0; i < a.image.color.size(); ++i)
        different += std::abs(a.image.color[i].g - b.image.color[i].g) > 0.05f * a.image.color[i].g;
    EXPECT_LT(different, a.image.color.size() / 5);
}

/// Ink fills a ring that is stretched by two and mirrored along the line of sight: 4 times .35 of it, twice as far.
TEST(Implicit, HoldsAMedium) {
    View view;
    view.maxDepth = 0;
    const glm::dvec3 left = 4. * glm::exp(-glm::dvec3(.2, .5, 1) * (2 * 4 * .35));
    const Estimate seen = estimate(
        render(sceneText(view,
                         "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [4 4 4] Translate 0 0 5 ReverseOrientation Shape \"disk\" "
                         "\"float radius\" 9 AttributeEnd\n"
                         "MakeNamedMedium \"ink\" \"string type\" \"homogeneous\" \"rgb sigma_a\" [.2 .5 1] \"rgb sigma_s\" [0 0 0]\n"
                         "Material \"interface\" MediumInterface \"ink\" \"\" Scale 1 1 -2 " +
                             ring))
            .image);
    /* Absorption alone has no noise. Rays start and end within the intervals that hold the surface, up to 2^-21 of the coordinates */
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen.mean[c], left[c], 2e-5 * left[c]);
}

/// Half of its points are cut out; which half a ray meets is drawn by its bits, so that only means agree.
TEST(Implicit, IsCutOutByAlpha) {
    View view;
    view.lookAt = "0 0 -4  .2 .1 0  0 1 0";
    const auto seen = [&](const std::string& shape) {
        return render(sceneText(view, "LightSource \"infinite\" \"rgb L\" [1 .5 0] Material \"diffuse\" \"rgb reflectance\" [0 0 0] " +
                                          shape + " \"float alpha\" .5"),
                      surfaces());
    };
    /* Black, but for a fourth of the rays that pass its front and its back; a ring has two of each */
    expectRadiance(seen(formula), glm::dvec3(.25, .125, 0), 0.02);
    expectRadiance(seen(thin), glm::dvec3(.25, .125, 0), 0.02);
    expectRadiance(seen(ring), glm::dvec3(.25, .125, 0) / 4., 0.04);
}

/// Black in a white world, it covers the pixel while it passes: a fourth of the time.
TEST(Implicit, Moves) {
    View view;
    view.samples = 1024;
    for (const std::string& ball : {formula, thin})
        expectRadiance(render(sceneText(view, R"(LightSource "infinite" "rgb L" [1 1 1] Material "diffuse" "rgb reflectance" [0 0 0]
            ActiveTransform EndTime Translate 8 0 0 ActiveTransform All Translate -4 0 0 )" + ball)), 0.75);
}

}  // namespace
}  // namespace eikonal
