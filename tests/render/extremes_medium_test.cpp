// Media at the extremes of optical depth, where they only absorb and emit: what they do is known in closed form, and one sample shows it.

#include "rendering.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace eikonal {
namespace {

View oneSample() {
    View v;
    v.samples = 1;
    return v;
}
constexpr const char* sky = "LightSource \"infinite\" \"rgb L\" [1 1 1]\n";

/// A ball of radius 1, seen through its middle: rays cross 2 units of the medium.
std::string ball(double sigma, double Le) {
    return fmt::format("MakeNamedMedium \"m\" \"string type\" \"homogeneous\" \"rgb sigma_a\" [{0} {0} {0}] \"rgb sigma_s\" [0 0 0] "
                       "\"rgb Le\" [{1} {1} {1}]\nMaterial \"interface\" MediumInterface \"m\" \"\" Shape \"sphere\"\n",
                       sigma, Le);
}

/// 4 x 4 x 4 voxels of density 1 in a box of 2 units. As in pbrt-v4, the density falls to 1/2 over the last half of a voxel, so its mean
/// along an axis through the middle is (3 + 2 * 0.75 / 2) / 4 = 0.9375.
constexpr double meanDensity = 0.9375;
/// "Lescale" falls off in the same way: the mean of its product with the density is (3 + 2 * (1 - 1/8) / 3) / 4.
constexpr double meanEmission = (3 + 2 * 0.875 / 3) / 4;
std::string grid(double sigma, double Le) {
    std::string ones;
    for (int i = 0; i < 64; ++i) ones += " 1";
    return fmt::format("MakeNamedMedium \"m\" \"string type\" \"uniformgrid\" \"integer nx\" 4 \"integer ny\" 4 \"integer nz\" 4 "
                       "\"float density\" [{2}] \"float Lescale\" [{2}] \"point3 p0\" [-1 -1 -1] \"point3 p1\" [1 1 1] \"rgb sigma_a\" "
                       "[{0} {0} {0}] \"rgb sigma_s\" [0 0 0] \"rgb Le\" [{1} {1} {1}]\nMaterial \"interface\" MediumInterface \"m\" \"\" "
                       "Shape \"sphere\" \"float radius\" 3\n",
                       sigma, Le, ones);
}

void expectEveryPixel(const Rendered& r, double expected, double tolerance) {
    for (const glm::vec3& c : r.image.color) ASSERT_NEAR(c.g, expected, tolerance * expected);
}

/// exp(-tau) has the relative error of tau's absolute one, which is tau times a few roundings.
TEST(ExtremeMedia, AbsorptionIsExactWithOneSample) {
    for (const double tau : {1e-8, 1e-3, 1., 20., 80.}) {
        SCOPED_TRACE(tau);
        expectEveryPixel(render(sceneText(oneSample(), sky + ball(tau / 2, 0)), media()), std::exp(-tau), 1e-6 * (1 + tau));
        expectEveryPixel(render(sceneText(oneSample(), sky + grid(tau / 2 / meanDensity, 0)), media()), std::exp(-tau), 1e-6 * (4 + tau));
    }
}

/// Shadow rays in a cloud end by chance where little of them is left: of what they began with, whatever the light's brightness. So a light
/// with 2^-12 of the power makes exactly 2^-12 of the image.
TEST(ExtremeMedia, ABrighterLightMakesTheSameImageInACloud) {
    const auto cloudUnder = [](double intensity) {
        std::string densities;
        for (int i = 0; i < 64; ++i) densities += i % 3 ? " 1" : " 0.25";
        const std::string text = fmt::format(
            "LightSource \"point\" \"point3 from\" [2 3 2] \"rgb I\" [{0} {0} {0}]\n"
            "MakeNamedMedium \"m\" \"string type\" \"uniformgrid\" \"integer nx\" 4 \"integer ny\" 4 \"integer nz\" 4 "
            "\"float density\" [{1}] \"point3 p0\" [-1 -1 -1] \"point3 p1\" [1 1 1] \"rgb sigma_a\" [0 0 0] \"rgb sigma_s\" [9 9 9]\n"
            "Material \"interface\" MediumInterface \"m\" \"\" Shape \"sphere\" \"float radius\" 3\n",
            intensity, densities);
        return render(sceneText(oneSample(), text), media());
    };
    const Rendered bright = cloudUnder(64), dim = cloudUnder(64.0 / 4096);
    float brightest = 0;
    for (size_t i = 0; i < bright.image.color.size(); ++i) {
        ASSERT_EQ(bright.image.color[i].g, 4096 * dim.image.color[i].g) << "pixel " << i;
        brightest = std::max(brightest, bright.image.color[i].g);
    }
    EXPECT_GT(brightest, 0.1f);
}

/// A white floor in the middle of a medium, under light from everywhere: the eye, outside, sees 1 times what is left on the way there and
/// back, 1 unit each in the ball. A uniform sky is found by samples of the BSDF, a lamp by samples of the light as well.
TEST(ExtremeMedia, AbsorbedLightOnASurfaceIsTheSameByEveryStrategy) {
    View v;
    v.samples = 256;
    v.lookAt = "0 0 3.5  0 0 0  0 1 0";
    v.maxDepth = 1;
    const std::string floor = "MediumInterface \"m\" \"m\" Material \"diffuse\" \"rgb reflectance\" [1 1 1] Shape \"disk\" "
                              "\"float radius\" .01\n",
                      lamp = "AttributeBegin ReverseOrientation AreaLightSource \"diffuse\" \"rgb L\" [1 1 1] Shape \"sphere\" "
                             "\"float radius\" 4 AttributeEnd\n";
    for (const std::string& lit : {std::string(sky), lamp})
        expectRadiance(render(sceneText(v, lit + ball(2, 0) + floor), media()), std::exp(-2 * 2.), 0.02);
    expectEqualMeans(render(sceneText(v, sky + grid(2, 0) + floor), media()),
                     render(sceneText(v, lamp + grid(2, 0) + floor), media()), 0.02);
}

/// tau Le is 1, whatever tau: L = Le (1 - exp(-tau)).
TEST(ExtremeMedia, EmissionOfThinMediaIsThereWithOneSample) {
    for (const double tau : {1e-12, 1e-8, 1e-5, 1e-2}) {
        SCOPED_TRACE(tau);
        expectEveryPixel(render(sceneText(oneSample(), ball(tau / 2, 1 / tau)), media()), -std::expm1(-tau) / tau, 1e-5);
        if (tau > 1e-4) continue;
        expectRadiance(render(sceneText(oneSample(), grid(tau / 2, 1 / tau)), media()), meanEmission, 0.01);
    }
}

/// A thick medium that glows is as bright as its Le.
TEST(ExtremeMedia, EmissionOfThickMediaIsLe) {
    for (const double tau : {20., 1e3, 1e6})
        expectEveryPixel(render(sceneText(oneSample(), ball(tau / 2, 2)), media()), 2, 1e-5);
}

/// What overflows is an error that names the parameter.
TEST(ExtremeMedia, OverflowNamesTheParameter) {
    const auto complaint = [](const std::string& world) -> std::string {
        try {
            packScene(sceneText(oneSample(), world + "Shape \"sphere\""));
        } catch (const std::exception& error) { return error.what(); }
        return "";
    };
    EXPECT_NE(complaint(ball(1e60, 0)).find("\"sigma_a\" of medium \"m\""), std::string::npos);
    EXPECT_NE(complaint(ball(1, 1e60)).find("\"Le\" of medium \"m\""), std::string::npos);
    EXPECT_NE(complaint("LightSource \"point\" \"rgb I\" [1e60 1e60 1e60]\n").find("\"I\" of a light"), std::string::npos);
    EXPECT_NE(complaint("AreaLightSource \"diffuse\" \"rgb L\" [1e60 1e60 1e60]\n").find("\"L\" of an area light"), std::string::npos);
}

}  // namespace
}  // namespace eikonal
