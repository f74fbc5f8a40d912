// Light on its way through participating media, against the laws of extinction and emission. A camera in front looks along z through the origin at a
// black wall at z = 5 that shines with L = 4.

#include "rendering.h"

#include <fmt/format.h>

#include <cmath>

namespace eikonal {
namespace {

constexpr double Le = 4, pi = M_PI;
const std::string wall = "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [4 4 4] Material \"diffuse\" \"rgb reflectance\" [0 0 0]\n"
    "Shape \"trianglemesh\" \"point3 P\" [-50 -50 5  -50 50 5  50 50 5  50 -50 5] \"integer indices\" [0 1 2 0 2 3] AttributeEnd\n";
std::string medium(const std::string& name, const std::string& parameters, const std::string& kind = "homogeneous") {
    return fmt::format("MakeNamedMedium \"{}\" \"string type\" \"{}\" {}\n", name, kind, parameters);
}
std::string ball(const std::string& inside, const std::string& outside, double radius, const std::string& material = "\"interface\"") {
    return fmt::format("AttributeBegin Material {} MediumInterface \"{}\" \"{}\" Shape \"sphere\" \"float radius\" {} AttributeEnd\n", material, inside, outside, radius);
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

// What scatters out of the way is lost as well, where nothing can be scattered in: maxdepth 0.
TEST(Medium, ScatteringExtinguishesToo) {
    expectRadiance(look(wall + medium("fog", "\"rgb sigma_a\" [.1 .3 .2] \"rgb sigma_s\" [.1 .2 .8]") + ball("fog", "", 1), 0), Le * transmittance({.2, .5, 1}, 2), 0.02);
}

// A ball in a ball: 2 of the way in the outer medium, 2 in the inner one. Interfaces are no depth: maxdepth 0 sees the wall.
TEST(Medium, NestedMediaFollowEachOther) {
    expectRadiance(look(wall + medium("ink", everyColour) + medium("water", "\"rgb sigma_a\" [.3 .1 .2] \"rgb sigma_s\" [0 0 0]") + ball("water", "", 2) + ball("ink", "water", 1), 0),
                   Le * transmittance(glm::dvec3(.2, .5, 1) + glm::dvec3(.3, .1, .2), 2), 0.02);
}

// The camera itself is in the medium, 4 away from the origin, 9 from the wall.
TEST(Medium, TheCameraMayBeInside) {
    View view;
    view.maxDepth = 0;
    const std::string text = "MakeNamedMedium \"haze\" \"string type\" \"homogeneous\" \"rgb sigma_a\" [.02 .1 .05] \"rgb sigma_s\" [0 0 0]\nMediumInterface \"\" \"haze\"\n" +
                             sceneText(view, "MediumInterface \"\" \"haze\"\n" + wall);
    expectRadiance(render(text, media()), Le * transmittance({.02, .1, .05}, 9), 0.02);
}

// Matter that shines and absorbs with sigma_a = .7 sends out L (1 - exp(-sigma_a d)).
TEST(Medium, WhatShinesReachesItsRadianceInDepth) {
    expectRadiance(look(medium("flame", "\"rgb sigma_a\" [.7 .7 .7] \"rgb sigma_s\" [0 0 0] \"rgb Le\" [3 2 1]") + ball("flame", "", 1)),
                   glm::dvec3(3, 2, 1) * (1 - std::exp(-1.4)), 0.02);
}

// A medium that scatters everything, under a sky of radiance 1: radiance 1 everywhere solves the volume transport equation, whatever the phase function.
TEST(Medium, AWhiteCloudUnderAWhiteSkyCannotBeSeen) {
    for (const char* g : {"0", ".6", "-.4"}) {
        SCOPED_TRACE(g);
        expectRadiance(look("LightSource \"infinite\" \"rgb L\" [1 1 1]\n" + medium("cloud", "\"rgb sigma_a\" [0 0 0] \"rgb sigma_s\" [2 2 2] \"float g\" " + std::string(g)) + ball("cloud", "", 1), 300), 1, 0.005);
    }
}
// The same with different coefficients in each colour: paths follow one and must be right for all.
TEST(Medium, AWhiteCloudMayScatterColoursDifferently) {
    expectRadiance(look("LightSource \"infinite\" \"rgb L\" [1 1 1]\n" + medium("cloud", "\"rgb sigma_a\" [0 0 0] \"rgb sigma_s\" [.5 1 3]") + ball("cloud", "", 1), 300), 1, 0.02);
}

// A white cloud in a glass ball, and one on a white diffuse core.
TEST(Medium, CloudsInGlassAndOnWhiteCannotBeSeenEither) {
    const std::string sky = "LightSource \"infinite\" \"rgb L\" [1 1 1]\n" + medium("cloud", "\"rgb sigma_a\" [0 0 0] \"rgb sigma_s\" [2 2 2]");
    expectRadiance(look(sky + ball("cloud", "", 1, "\"dielectric\" \"float eta\" 1.3"), 500), 1, 0.01);
    expectRadiance(look(sky + ball("cloud", "", 1) + ball("cloud", "cloud", .5, "\"diffuse\" \"rgb reflectance\" [1 1 1]"), 500), 1, 0.01);
}

// A grid of the same density everywhere is a homogeneous medium.
TEST(Medium, AnEvenGridIsHomogeneous) {
    const std::string sky = "LightSource \"infinite\" \"rgb L\" [1 .5 .2]\nLightSource \"point\" \"rgb I\" [5 5 5] \"point3 from\" [2 2 -2]\n";
    const std::string coefficients = "\"rgb sigma_a\" [.3 .2 .1] \"rgb sigma_s\" [1 1.5 2] \"float g\" .3 \"rgb Le\" [.2 .1 .3] ";
    std::string grid = "\"integer nx\" 3 \"integer ny\" 2 \"integer nz\" 4 \"point3 p0\" [-1 -1 -1] \"point3 p1\" [1 1 1] \"float density\" [";
    for (int i = 0; i < 24; ++i) grid += " .8";
    expectEqualMeans(look(sky + medium("smoke", coefficients + "\"float scale\" .8") + ball("smoke", "", 1)),
                     look(sky + medium("smoke", coefficients + grid + " ]", "uniformgrid") + ball("smoke", "", 1)), 0.03);
}

// Cells of density 1 and 0 with centres at z = -1/2 and 1/2, and nothing outside of the grid, between which density is interpolated (as in pbrt-v4): along
// the axis it rises from 1/2 at z = -1 to 1 at -1/2 and falls to 0 at 1/2. Its integral is 3/8 + 1/2.
TEST(Medium, AGridInterpolatesBetweenTheCentresOfItsCells) {
    expectRadiance(look(wall + medium("step", everyColour + "\"integer nx\" 1 \"integer ny\" 1 \"integer nz\" 2 \"point3 p0\" [-1 -1 -1] \"point3 p1\" [1 1 1] \"float density\" [1 0]", "uniformgrid") +
                        ball("step", "", 1.8)), Le * transmittance({.2, .5, 1}, 0.875), 0.02);
}

// Light from a point at (0, 2, -1) to a diffuse disk at the origin that faces it and the camera, all in fog that only absorbs: both ways cost.
TEST(Medium, ShadowRaysAreExtinguished) {
    View view;
    view.maxDepth = 1;
    const std::string text = "MakeNamedMedium \"haze\" \"string type\" \"homogeneous\" \"rgb sigma_a\" [.05 .2 .1] \"rgb sigma_s\" [0 0 0]\nMediumInterface \"\" \"haze\"\n" +
        sceneText(view, "MediumInterface \"haze\" \"haze\"\nLightSource \"point\" \"rgb I\" [9 9 9] \"point3 from\" [0 2 -1]\n"
                        "Material \"diffuse\" \"rgb reflectance\" [.5 .5 .5] Shape \"disk\" \"float radius\" 1");
    expectRadiance(render(text, media()), 0.5 / pi * 9 / std::pow(5, 1.5) * transmittance({.05, .2, .1}, 4 + std::sqrt(5.)), 0.02);
}

// The same light through balls of vacuum and ink on the way of the shadow ray: it finds its way through interfaces.
TEST(Medium, ShadowRaysPassInterfaces) {
    View view;
    view.maxDepth = 1;
    const std::string text = sceneText(view, "LightSource \"point\" \"rgb I\" [9 9 9] \"point3 from\" [0 4 -2]\nMaterial \"diffuse\" \"rgb reflectance\" [.5 .5 .5] Shape \"disk\" \"float radius\" 1\n" +
        medium("ink", everyColour) + "Translate 0 2 -1\n" + ball("ink", "", .5) + ball("", "ink", .25));
    expectRadiance(render(text, media()), 0.5 / pi * 9 * 2 / std::pow(20, 1.5) * transmittance({.2, .5, 1}, .5), 0.02);
}

// Six interfaces on the way of a path with one bounce.
TEST(Medium, AnInterfaceIsNoDepth) {
    View view;
    view.maxDepth = 1;
    const std::string scene = "LightSource \"point\" \"rgb I\" [9 9 9] \"point3 from\" [0 2 -1]\nAttributeBegin Material \"diffuse\" \"rgb reflectance\" [.5 .5 .5] Shape \"disk\" \"float radius\" 1 AttributeEnd\n";
    expectRadiance(render(sceneText(view, scene + medium("nothing", "\"rgb sigma_a\" [0 0 0] \"rgb sigma_s\" [0 0 0]") + ball("nothing", "", 1.3) + ball("nothing", "", 1.6) + ball("nothing", "", 1.9)), media()),
                   0.5 / pi * 9 / std::pow(5, 1.5));
}

}  // namespace
}  // namespace eikonal
