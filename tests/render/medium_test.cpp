// Light on its way through participating media, against the laws of extinction and emission. A camera in front looks along z through the
// origin at a black wall at z = 5 that shines with L = 4.

#include "nanovdb_file.h"   // before include/eikonal

#include "rendering.h"
#include "color/spectrum.h"

#include "color/spectrum.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

namespace eikonal {
namespace {

constexpr double Le = 4, pi = M_PI;
const std::string wall = "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [4 4 4] Material \"diffuse\" \"rgb reflectance\" [0 0 0]\n"
    "Shape \"trianglemesh\" \"point3 P\" [-50 -50 5  -50 50 5  50 50 5  50 -50 5] \"integer indices\" [0 1 2 0 2 3] AttributeEnd\n";
std::string medium(const std::string& name, const std::string& parameters, const std::string& kind = "homogeneous") {
    return fmt::format("MakeNamedMedium \"{}\" \"string type\" \"{}\" {}\n", name, kind, parameters);
}
std::string ball(const std::string& inside, const std::string& outside, double radius, const std::string& material = "\"interface\"") {
    return fmt::format("AttributeBegin Material {} MediumInterface \"{}\" \"{}\" Shape \"sphere\" \"float radius\" {} AttributeEnd\n",
                       material, inside, outside, radius);
}
Rendered look(const std::string& world, int maxDepth = 100, const std::string& more = "") {
    View view;
    view.maxDepth = maxDepth;
    view.more = more;
    return render(sceneText(view, world), media());
}
const std::string everyColour = "\"rgb sigma_a\" [.2 .5 1] \"rgb sigma_s\" [0 0 0]";
glm::dvec3 transmittance(glm::dvec3 sigma, double d) { return glm::exp(-sigma * d); }

// Beer's law over the ball's diameter of 2, in each colour by itself.
TEST(Medium, WhatAbsorbsLeavesTheExponential) {
    expectRadiance(look(wall + medium("ink", everyColour) + ball("ink", "", 1)), Le * transmittance({.2, .5, 1}, 2), 0.02);
}

// A distant light shines through a medium around the scene from as far as a sphere around the scene is wide, as in pbrt-v4. Here that is
// 2 sqrt(2).
TEST(Medium, ADistantLightComesThroughTheScene) {
    const std::string world = "LightSource \"distant\" \"rgb L\" [3 3 3] \"point3 from\" [0 0 -1] \"point3 to\" [0 0 0]\n"
                              "MediumInterface \"ink\" \"ink\" Material \"diffuse\"\n"
                              "Shape \"bilinearmesh\" \"point3 P\" [-1 -1 0  1 -1 0  -1 1 0  1 1 0]";
    const std::string around = medium("ink", everyColour) + "MediumInterface \"\" \"ink\" Camera \"perspective\" \"float fov\" .02\n";
    expectRadiance(look(world, 100, around), 3 * 0.5 / pi * transmittance({.2, .5, 1}, 4 + 2 * std::sqrt(2.0)), 0.001);
}

// At wavelengths it is Beer's law at each of them, for smooth spectra of the colours: what the eye makes of that is not the exponential of
// three numbers. Absorbed or scattered out of the way, the hero wavelength's events stand for all four.
TEST(Medium, ExtinctionFollowsTheSpectrumAtWavelengths) {
    const DenseCurve sigma = Spectrum::rgb({.2, .5, 1}).dense(), white = whiteSpectrum(ColorSpace::srgb);
    glm::dvec3 expected(0);
    for (int i = 0; i < wavelengthCount; ++i)
        expected += rgbFromXyz(ColorSpace::srgb) * matchingFunctions()[i] * white[i] * std::exp(-2 * sigma[i]) * Le / integrateXyz(white).y;
    for (const char* name : {"a", "s"}) {
        View view;
        view.maxDepth = 0;
        view.sampler = "sobol";
        view.samples = 1024;
        const std::string other = name == std::string("a") ? "s" : "a";
        const std::string fog = medium("fog", fmt::format("\"rgb sigma_{}\" [.2 .5 1] \"rgb sigma_{}\" [0 0 0]", name, other));
        const glm::dvec3 seen =
            estimate(render(packScene(sceneText(view, wall + fog + ball("fog", "", 1)), ColorMode::spectral)).image).mean;
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c] / expected[c], 1, 0.005) << "sigma_" << name << " channel " << c;
    }
}

// What scatters out of the way is lost as well, where nothing can be scattered in: maxdepth 0.
TEST(Medium, ScatteringExtinguishesToo) {
    expectRadiance(look(wall + medium("fog", "\"rgb sigma_a\" [.1 .3 .2] \"rgb sigma_s\" [.1 .2 .8]") + ball("fog", "", 1), 0),
                   Le * transmittance({.2, .5, 1}, 2), 0.02);
}

// A ball in a ball: 2 of the way in the outer medium, 2 in the inner one. Interfaces are no depth: maxdepth 0 sees the wall.
TEST(Medium, NestedMediaFollowEachOther) {
    expectRadiance(look(wall + medium("ink", everyColour) + medium("water", "\"rgb sigma_a\" [.3 .1 .2] \"rgb sigma_s\" [0 0 0]") +
                            ball("water", "", 2) + ball("ink", "water", 1),
                        0),
                   Le * transmittance(glm::dvec3(.2, .5, 1) + glm::dvec3(.3, .1, .2), 2), 0.02);
}

// The camera itself is in the medium, 4 away from the origin, 9 from the wall.
TEST(Medium, TheCameraMayBeInside) {
    View view;
    view.maxDepth = 0;
    const std::string text =
        "MakeNamedMedium \"haze\" \"string type\" \"homogeneous\" \"rgb sigma_a\" [.02 .1 .05] \"rgb sigma_s\" [0 0 0]\nMediumInterface "
        "\"\" \"haze\"\n" +
        sceneText(view, "MediumInterface \"\" \"haze\"\n" + wall);
    expectRadiance(render(text, media()), Le * transmittance({.02, .1, .05}, 9), 0.02);
}

// Matter that shines and absorbs with sigma_a = .7 sends out L (1 - exp(-sigma_a d)).
TEST(Medium, WhatShinesReachesItsRadianceInDepth) {
    expectRadiance(look(medium("flame", "\"rgb sigma_a\" [.7 .7 .7] \"rgb sigma_s\" [0 0 0] \"rgb Le\" [3 2 1]") + ball("flame", "", 1)),
                   glm::dvec3(3, 2, 1) * (1 - std::exp(-1.4)), 0.02);
}

// A medium that scatters everything, under a sky of radiance 1: radiance 1 everywhere solves the volume transport equation, whatever the
// phase function.
TEST(Medium, AWhiteCloudUnderAWhiteSkyCannotBeSeen) {
    for (const char* g : {"0", ".6", "-.4"}) {
        SCOPED_TRACE(g);
        expectRadiance(look("LightSource \"infinite\" \"rgb L\" [1 1 1]\n" +
                                medium("cloud", "\"rgb sigma_a\" [0 0 0] \"rgb sigma_s\" [2 2 2] \"float g\" " + std::string(g)) +
                                ball("cloud", "", 1),
                            300),
                       1, 0.005);
    }
}
// A white cloud in a ball that shines with a radiance of 1 cannot be seen. A point light too weak to be seen changes how distances are
// sampled, and nothing else: light samples and paths share the light of the ball.
TEST(Medium, APointLightTakesNothingFromALamp) {
    const std::string point = "AttributeBegin MediumInterface \"\" \"cloud\" LightSource \"point\" \"rgb I\" [1e-9 1e-9 1e-9] "
                              "\"point3 from\" [0 0 .1] AttributeEnd\n";
    const std::string lamp = "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [1 1 1] \"bool twosided\" true Material \"diffuse\" "
                             "\"rgb reflectance\" [0 0 0] Shape \"sphere\" \"float radius\" 9 AttributeEnd\n";
    expectRadiance(look(medium("cloud", "\"rgb sigma_a\" [0 0 0] \"rgb sigma_s\" [1 1 1]") + point + lamp + ball("cloud", "", 1), 300), 1,
                   0.005);
}
// The same with different coefficients in each colour: paths follow one and must be right for all.
TEST(Medium, AWhiteCloudMayScatterColoursDifferently) {
    expectRadiance(look("LightSource \"infinite\" \"rgb L\" [1 1 1]\n" +
                            medium("cloud", "\"rgb sigma_a\" [0 0 0] \"rgb sigma_s\" [.5 1 3]") + ball("cloud", "", 1),
                        300),
                   1, 0.02);
}

// A white cloud in a glass ball, and one on a white diffuse core.
TEST(Medium, CloudsInGlassAndOnWhiteCannotBeSeenEither) {
    const std::string sky =
        "LightSource \"infinite\" \"rgb L\" [1 1 1]\n" + medium("cloud", "\"rgb sigma_a\" [0 0 0] \"rgb sigma_s\" [2 2 2]");
    expectRadiance(look(sky + ball("cloud", "", 1, "\"dielectric\" \"float eta\" 1.3"), 500), 1, 0.01);
    expectRadiance(look(sky + ball("cloud", "", 1) + ball("cloud", "cloud", .5, "\"diffuse\" \"rgb reflectance\" [1 1 1]"), 500), 1, 0.01);
}

// Ink in glass in haze, straight through the middle: what the boundaries let pass, R = 0.04 each, and what goes to and fro between them, is
// thinned by the ink each time; the haze takes its share of the 3 before and the 4 behind.
TEST(Medium, MediaInGlassInMediaFollowEachOther) {
    View view;
    const glm::dvec3 t = transmittance({.2, .5, 1}, 2);
    const std::string text =
        "MakeNamedMedium \"haze\" \"string type\" \"homogeneous\" \"rgb sigma_a\" [.02 .1 .05] \"rgb sigma_s\" [0 0 0]\nMediumInterface "
        "\"\" \"haze\"\n" +
        sceneText(view, "MediumInterface \"\" \"haze\"\n" + wall + medium("ink", everyColour) +
                            ball("ink", "haze", 1, "\"dielectric\" \"float eta\" 1.5"));
    expectRadiance(render(text, media()), Le * transmittance({.02, .1, .05}, 7) * .96 * .96 * t / (1. - .0016 * t * t), 0.02);
}

// A grid of the same density everywhere is a homogeneous medium: well within its bounds, beyond whose outermost centres density and
// emission fall off.
TEST(Medium, AnEvenGridIsHomogeneous) {
    const std::string sky =
        "LightSource \"infinite\" \"rgb L\" [1 .5 .2]\nLightSource \"point\" \"rgb I\" [5 5 5] \"point3 from\" [2 2 -2]\n";
    const std::string coefficients = "\"rgb sigma_a\" [.3 .2 .1] \"rgb sigma_s\" [1 1.5 2] \"float g\" .3 \"rgb Le\" [.2 .1 .3] ";
    std::string grid =
        "\"integer nx\" 6 \"integer ny\" 5 \"integer nz\" 7 \"point3 p0\" [-3 -3 -3] \"point3 p1\" [3 3 3] \"float density\" [";
    for (int i = 0; i < 6 * 5 * 7; ++i) grid += " .8";
    grid += " ] \"float Lescale\" [";
    for (int i = 0; i < 6 * 5 * 7; ++i) grid += " 1";
    expectEqualMeans(look(sky + medium("smoke", coefficients + "\"float scale\" .8") + ball("smoke", "", 1)),
                     look(sky + medium("smoke", coefficients + grid + " ]", "uniformgrid") + ball("smoke", "", 1)), 0.03);
}

// Cells of density 1 and 0 with centres at z = -1/2 and 1/2, and nothing outside of the grid, between which density is interpolated (as in
// pbrt-v4): along the axis it rises from 1/2 at z = -1 to 1 at -1/2 and falls to 0 at 1/2. Its integral is 3/8 + 1/2. Two by two cells
// across, so that it does not vary near the axis.
TEST(Medium, AGridInterpolatesBetweenTheCentresOfItsCells) {
    expectRadiance(look(wall +
                        medium("step",
                               everyColour + "\"integer nx\" 2 \"integer ny\" 2 \"integer nz\" 2 \"point3 p0\" [-1 -1 -1] "
                                             "\"point3 p1\" [1 1 1] \"float density\" [1 1 1 1 0 0 0 0]",
                               "uniformgrid") +
                        ball("step", "", 1.8)),
                   Le * transmittance({.2, .5, 1}, 0.875), 0.02);
}

// Light from a point at (0, 2, -1) to a diffuse disk at the origin that faces it and the camera, all in fog that only absorbs: both ways
// cost.
TEST(Medium, ShadowRaysAreExtinguished) {
    View view;
    view.maxDepth = 1;
    const std::string text =
        "MakeNamedMedium \"haze\" \"string type\" \"homogeneous\" \"rgb sigma_a\" [.05 .2 .1] \"rgb sigma_s\" [0 0 0]\nMediumInterface "
        "\"\" \"haze\"\n" +
        sceneText(view,
                  "MediumInterface \"haze\" \"haze\"\nLightSource \"point\" \"rgb I\" [9 9 9] \"point3 from\" [0 2 -1]\n"
                  "Material \"diffuse\" \"rgb reflectance\" [.5 .5 .5] Shape \"disk\" \"float radius\" 1");
    expectRadiance(render(text, media()), 0.5 / pi * 9 / std::pow(5, 1.5) * transmittance({.05, .2, .1}, 4 + std::sqrt(5.)), 0.02);
}

// The same light through balls of vacuum and ink on the way of the shadow ray: it finds its way through interfaces.
TEST(Medium, ShadowRaysPassInterfaces) {
    View view;
    view.maxDepth = 1;
    const std::string text = sceneText(view,
                                       "LightSource \"point\" \"rgb I\" [9 9 9] \"point3 from\" [0 4 -2]\nMaterial \"diffuse\" \"rgb "
                                       "reflectance\" [.5 .5 .5] Shape \"disk\" \"float radius\" 1\n" +
                                           medium("ink", everyColour) + "Translate 0 2 -1\n" + ball("ink", "", .5) + ball("", "ink", .25));
    expectRadiance(render(text, media()), 0.5 / pi * 9 * 2 / std::pow(20, 1.5) * transmittance({.2, .5, 1}, .5), 0.02);
}

// Six interfaces on the way of a path with one bounce.
TEST(Medium, AnInterfaceIsNoDepth) {
    View view;
    view.maxDepth = 1;
    const std::string scene =
        "LightSource \"point\" \"rgb I\" [9 9 9] \"point3 from\" [0 2 -1]\nAttributeBegin Material \"diffuse\" \"rgb reflectance\" [.5 .5 "
        ".5] Shape \"disk\" \"float radius\" 1 AttributeEnd\n";
    expectRadiance(render(sceneText(view, scene + medium("nothing", "\"rgb sigma_a\" [0 0 0] \"rgb sigma_s\" [0 0 0]") +
                                              ball("nothing", "", 1.3) + ball("nothing", "", 1.6) + ball("nothing", "", 1.9)),
                          media()),
                   0.5 / pi * 9 / std::pow(5, 1.5));
}

// ---- media that vary ------------------------------------------------------------------------------------------------

std::string repeated(const std::string& value, int times) {
    std::string text = "[";
    for (int i = 0; i < times; ++i) text += " " + value;
    return text + " ]";
}
/// 4^3 values on the cube of side 4: the same everywhere within 1.5 of the middle, where the ball is.
const std::string around = "\"integer nx\" 4 \"integer ny\" 4 \"integer nz\" 4 \"point3 p0\" [-2 -2 -2] \"point3 p1\" [2 2 2] ";
std::string evenDensity(const std::string& more) { return around + "\"float density\" " + repeated("1", 64) + more; }

std::string nanoVdbFile() {
    const std::string path = (std::filesystem::temp_directory_path() / fmt::format("eikonal-render-{}.nvdb", ::getpid())).string();
    writeNanoVdb(path, {{"density", 8, 0.25, [](int, int, int) { return 1.f; }}, {"heat", 8, 0.25, [](int, int, int) { return 1000.f; }}});
    return "\"string filename\" \"" + path + "\" \"string temperaturename\" \"heat\" ";
}

// Beer's law in whatever is the same everywhere along the axis: a grid of colours, the mist below a cloud (density is 1 where y < 0), a
// sparse grid.
TEST(VaryingMedia, WhatDoesNotVaryFollowsBeersLaw) {
    const glm::dvec3 expected = Le * transmittance({.2, .5, 1}, 2);
    expectRadiance(
        look(wall +
             medium("ink",
                    around + "\"float scale\" .1 \"rgb sigma_a\" " + repeated("2 5 10", 64) + "\"rgb sigma_s\" " + repeated("0 0 0", 64),
                    "rgbgrid") +
             ball("ink", "", 1)),
        expected, 0.03);
    expectRadiance(look(wall + "TransformBegin Translate 0 4 0\n" +
                        medium("ink", everyColour + "\"point3 p0\" [-2 -6 -2] \"point3 p1\" [2 -2 2]", "cloud") + "TransformEnd\n" +
                        ball("ink", "", 1)),
                   expected, 0.02);
    expectRadiance(look(wall + medium("ink", everyColour + nanoVdbFile() + "\"float Lescale\" 0", "nanovdb") + ball("ink", "", 1)),
                   expected, 0.03);
}

// Two layers along z, [6 3 1] / 5 and nothing, with their centres at -1/2 and 1/2, as in AGridInterpolatesBetweenTheCentresOfItsCells.
TEST(VaryingMedia, ColoursAreInterpolated) {
    expectRadiance(look(wall +
                        medium("step",
                               "\"integer nx\" 2 \"integer ny\" 2 \"integer nz\" 2 \"point3 p0\" [-1 -1 -1] \"point3 p1\" [1 1 1] \"rgb "
                               "sigma_a\" [1.2 .6 .2  1.2 .6 .2  1.2 .6 .2  1.2 .6 .2  0 0 0  0 0 0  0 0 0  0 0 0] \"rgb sigma_s\" " +
                                   repeated("0 0 0", 8),
                               "rgbgrid") +
                        ball("step", "", 1.8)),
                   Le * transmittance({1.2, .6, .2}, 0.875), 0.03);
}

// What is not given of a grid's two coefficients is 1 all through its box, as in pbrt-v4: the way through it is 2.
TEST(VaryingMedia, ACoefficientThatIsNotGivenIsOne) {
    expectRadiance(
        look(wall + medium("one", "\"point3 p0\" [-1 -1 -1] \"point3 p1\" [1 1 1] \"float scale\" .5 \"rgb sigma_s\" [0 0 0]", "rgbgrid") +
             ball("one", "", 1.8)),
        Le * std::exp(-1), 0.02);
}

// Colours that shine and absorb with sigma_a = .7 send out L (1 - exp(-sigma_a d)), times what pbrt-v4 leaves in: the integral of the
// matching function y.
TEST(VaryingMedia, ColoursShine) {
    const std::string parameters = around + "\"rgb sigma_a\" " + repeated(".7 .7 .7", 64) + "\"rgb sigma_s\" " + repeated("0 0 0", 64) +
                                   "\"rgb Le\" " + repeated("3 2 1", 64) + "\"float Lescale\" .5";
    expectRadiance(look(medium("flame", parameters, "rgbgrid") + ball("flame", "", 1)),
                   106.857 * 0.5 * glm::dvec3(3, 2, 1) * (1 - std::exp(-1.4)), 0.02);
}

// Black bodies of (1000 - 100) * 3 = 2700 K: the integral of Planck's law, its maximum taken as 1, against the matching functions.
TEST(VaryingMedia, HeatShines) {
    const glm::dvec3 body = rgbFromXyz(ColorSpace::srgb) * integrateXyz(Spectrum::blackbody(2700).dense());
    const std::string sigma = "\"rgb sigma_a\" [.7 .7 .7] \"rgb sigma_s\" [0 0 0] ",
                      glow = "\"float temperatureoffset\" 100 \"float temperaturescale\" 3 ";
    const std::string grid =
        sigma + evenDensity(glow + "\"float temperature\" " + repeated("1000", 64) + "\"float Lescale\" " + repeated(".02", 64));
    expectRadiance(look(medium("fire", grid, "uniformgrid") + ball("fire", "", 1)), 0.02 * body * (1 - std::exp(-1.4)), 0.02);
    expectRadiance(look(medium("fire", sigma + glow + nanoVdbFile() + "\"float Lescale\" .02", "nanovdb") + ball("fire", "", 1)),
                   0.02 * body * (1 - std::exp(-1.4)), 0.02);
}

// Under a white sky a cloud that absorbs nothing cannot be seen, however it varies and whatever its colours.
TEST(VaryingMedia, WhiteOnesUnderAWhiteSkyCannotBeSeen) {
    const std::string sky = "LightSource \"infinite\" \"rgb L\" [1 1 1]\n", white = "\"rgb sigma_a\" [0 0 0] \"rgb sigma_s\" [4 4 4] ";
    std::string spots = "[";
    for (int i = 0; i < 64; ++i) spots += fmt::format(" {} {} {}", i % 3, i % 2, i % 5);
    expectRadiance(
        look(sky + medium("cloud", around + "\"rgb sigma_a\" " + repeated("0 0 0", 64) + "\"rgb sigma_s\" " + spots + " ]", "rgbgrid") +
                 ball("cloud", "", 1),
             300),
        1, 0.03);
    expectRadiance(look(sky + medium("cloud", white + "\"point3 p0\" [-1 0 -1] \"float frequency\" 3 \"float density\" 2", "cloud") +
                            ball("cloud", "", 1),
                        300),
                   1, 0.01);
}

}  // namespace
}  // namespace eikonal
