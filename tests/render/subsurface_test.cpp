// Bodies that light enters, wanders in and leaves, under skies for which the answer is known, by a walk and by a profile. None of them has
// depth for more than one event: what happens inside is not counted.

#include "rendering.h"
#include "color/diffuse_albedo.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace eikonal {
namespace {

const std::string whiteSky = "LightSource \"infinite\" \"rgb L\" [1 1 1]\n";
std::string ball(const std::string& parameters, double radius = 1) {
    return fmt::format("AttributeBegin Material \"subsurface\" {} Shape \"sphere\" \"float radius\" {} AttributeEnd\n", parameters, radius);
}
const std::string walk = "\"string method\" \"randomwalk\" ", white = walk + "\"rgb sigma_a\" [0 0 0] \"rgb sigma_s\" [2 3 4] ";
Rendered look(const std::string& world, const std::string& more = "") {
    View view;
    view.maxDepth = 1;
    view.samples = 64;   // long walks
    view.more = more;
    return render(sceneText(view, world), media());
}

// Radiance 1 everywhere solves the transport equation where nothing absorbs, whatever the boundary's index, the coefficients and the phase
// function.
TEST(Subsurface, AWhiteBallUnderAWhiteSkyCannotBeSeen) {
    for (const char* boundary : {"\"float eta\" 1", "\"float eta\" 1.5 \"float g\" .7", "\"float eta\" .8"}) {
        SCOPED_TRACE(boundary);
        expectRadiance(look(whiteSky + ball(white + boundary)), 1, 0.02);
    }
}

// A rough boundary sends all light but what bounces between its facets, each time that a path meets it: about 6 % at roughness 0.01
// (docs/subsurface.md).
TEST(Subsurface, ARoughBoundaryLetsLightInAndOut) {
    const Estimate seen = estimate(look(whiteSky + ball(white + "\"float eta\" 1.4 \"float roughness\" .01")).image);
    for (int c = 0; c < 3; ++c) {
        EXPECT_LT(seen.mean[c], 1 + standardErrors * seen.error[c]);
        EXPECT_GT(seen.mean[c], 0.92 - standardErrors * seen.error[c]);
        EXPECT_LT(seen.error[c], 0.02);
    }
}

// A deep slab, seen straight on under a white sky: the boundary reflects F = ((eta - 1) / (eta + 1))^2, and of what enters the reflectance
// leaves. It is no closed mesh, and its normal points to the camera.
TEST(Subsurface, ASlabHasTheReflectanceThatItIsGiven) {
    const std::string slab =
        "Material \"subsurface\" \"rgb reflectance\" [.6 .4 .2] \"rgb mfp\" [.05 .03 .04] \"float g\" {} \"string method\" \"{}\"\n"
        "Shape \"trianglemesh\" \"point3 P\" [-50 -50 0  -50 50 0  50 50 0  50 -50 0] \"integer indices\" [0 1 2 0 2 3]\n";
    const double F = 0.33 * 0.33 / (2.33 * 2.33);
    for (const auto& [g, method] : {std::pair("0", "randomwalk"), std::pair(".7", "randomwalk"), std::pair("0", "diffusion")}) {
        SCOPED_TRACE(std::string(method) + " " + g);
        expectRadiance(look(whiteSky + fmt::format(fmt::runtime(slab), g, method)), F + (1 - F) * glm::dvec3(.6, .4, .2), 0.02);
    }
}

// Six bodies in one another, as many as a path remembers the surroundings of (MOST_NESTED_BODIES), that refract nothing and absorb, each in
// its own way: along the axis of all, exp(-sum of sigma_a times the way in each) is left.
TEST(Subsurface, BodiesInOneAnotherAreLeftInTurn) {
    const double radii[] = {1, .85, .7, .55, .4, .25, 0}, sigma[] = {.2, 3, .1, 2, .4, 1};
    std::string world = whiteSky;
    double depth = 0;
    for (int k = 0; k < 6; ++k) {
        world += ball(fmt::format("{}\"rgb sigma_a\" [{} .5 1] \"rgb sigma_s\" [0 0 0] \"float eta\" 1", walk, sigma[k]), radii[k]);
        depth += sigma[k] * 2 * (radii[k] - radii[k + 1]);
    }
    View view;
    view.fov = .02;
    view.maxDepth = 20;
    view.samples = 1024;
    expectRadiance(render(sceneText(view, world), media()), glm::exp(-glm::dvec3(depth, .5 * 2, 1 * 2)), 0.02);
}

// Of a sphere of radius R, pi r^2 lie within the distance r of any of its points, as of a plane, as long as r < 2 R: a profile that ends
// before spreads over all of itself. So a ball is as bright as a slab, and a white one cannot be seen; whichever axes its probes have, each
// of which meets it twice.
TEST(Subsurface, AProfileIsWholeOnABall) {
    const std::string diffused = "\"string method\" \"diffusion\" \"rgb mfp\" [.02 .03 .04] ";
    expectRadiance(look(whiteSky + ball(diffused + "\"rgb reflectance\" [1 1 1] \"float eta\" 1.5")), 1, 0.02);
    expectRadiance(look(whiteSky + ball(diffused + "\"rgb reflectance\" [.8 .5 .2] \"float eta\" 1")), glm::dvec3(.8, .5, .2), 0.02);
}

// A texture that says the same everywhere is as good as a number; and of a board of two colours, whose squares are far larger than what is
// seen, each is a slab by itself.
TEST(Subsurface, TheReflectanceMayBeATexture) {
    const auto slab = [](const std::string& texture, const std::string& uv) {
        return "Texture \"t\" \"spectrum\" " + texture +
               " Material \"subsurface\" \"texture reflectance\" \"t\" \"rgb mfp\" [.05 .03 .04]\n"
               "Shape \"trianglemesh\" \"point3 P\" [-50 -50 0  -50 50 0  50 50 0  50 -50 0] \"integer indices\" [0 1 2 0 2 3] \"point2 "
               "uv\" [" +
               uv + "]\n";
    };
    const double F = 0.33 * 0.33 / (2.33 * 2.33);
    const glm::dvec3 one(.6, .4, .2), other(.2, .8, .9);
    const std::string uv = "0 0 0 1 1 1 1 0", far = "0 0 0 1e-4 1e-4 1e-4 1e-4 0";
    expectRadiance(look(whiteSky + slab("\"constant\" \"rgb value\" [.6 .4 .2]", uv)), F + (1 - F) * one, 0.02);
    const std::string board = "\"checkerboard\" \"rgb tex1\" [.6 .4 .2] \"rgb tex2\" [.2 .8 .9]";
    expectRadiance(look(whiteSky + slab(board, far)), F + (1 - F) * one, 0.02);
    expectRadiance(look(whiteSky + slab(board + " \"float udelta\" 1", far)), F + (1 - F) * other, 0.02);
}

// Beside a lit spot all light comes from below: how much, is a matter of the profile's width, which follows from the textures.
TEST(Subsurface, ATextureSaysHowFarLightSpreads) {
    const auto beside = [](const std::string& parameters) {
        View view;
        view.maxDepth = 1;
        view.samples = 4096;   // of which few find the way to the light
        return render(sceneText(view,
                                "LightSource \"spot\" \"point3 from\" [.5 0 -3] \"point3 to\" [.5 0 0] \"float coneangle\" 4 \"float "
                                "conedeltaangle\" .1 \"rgb I\" [50 50 50]\n"
                                "Texture \"t\" \"spectrum\" \"checkerboard\" \"rgb tex1\" [.8 .5 .3] \"rgb tex2\" [.8 .5 .3]\n"
                                "Texture \"path\" \"spectrum\" \"checkerboard\" \"rgb tex1\" [.12 .08 .1] \"rgb tex2\" [.12 .08 .1]\n"
                                "Material \"subsurface\" \"float roughness\" .2 " +
                                    parameters + " Shape \"bilinearmesh\" \"point3 P\" [-50 -50 0  -50 50 0  50 -50 0  50 50 0]\n"),
                      media());
    };
    const auto plain = beside("\"rgb reflectance\" [.8 .5 .3] \"rgb mfp\" [.12 .08 .1]");
    expectEqualMeans(beside("\"texture reflectance\" \"t\" \"rgb mfp\" [.12 .08 .1]"), plain, 0.05);
    expectEqualMeans(beside("\"rgb reflectance\" [.8 .5 .3] \"texture mfp\" \"path\""), plain, 0.05);
    expectEqualMeans(beside("\"texture reflectance\" \"t\" \"texture mfp\" \"path\""), plain, 0.05);
}

/// A body of given coefficients beside a lit spot, where all light comes from below, by diffusion.
Rendered besideASpot(const std::string& parameters, ColorMode color, const std::string& textures = "") {
    View view;
    view.maxDepth = 1;
    view.samples = 1024;
    return render(packScene(sceneText(view,
                                      "LightSource \"spot\" \"point3 from\" [.5 0 -3] \"point3 to\" [.5 0 0] \"float coneangle\" 9 \"float "
                                      "conedeltaangle\" .1 \"rgb I\" [50 50 50]\n" +
                                          textures + " Material \"subsurface\" \"float roughness\" .2 \"float g\" .4 \"float scale\" 2 " +
                                          parameters + " Shape \"bilinearmesh\" \"point3 P\" [-50 -50 0  -50 50 0  50 -50 0  50 50 0]\n"),
                            color),
                  color == ColorMode::rgb ? media() : RenderSetup{});
}
/// The mean distance of pixels, in their mean.
double distance(const FilmImage& a, const FilmImage& b) {
    double difference = 0, sum = 0;
    for (size_t i = 0; i < a.color.size(); ++i)
        for (const auto& [x, y] :
             {std::pair(a.color[i].r, b.color[i].r), std::pair(a.color[i].g, b.color[i].g), std::pair(a.color[i].b, b.color[i].b)}) {
            difference += std::abs(x - y);
            sum += y;
        }
    return difference / sum;
}

// Textures that say the same everywhere make the paths that numbers make, to rounding: in RGB, and at wavelengths from spectra and from
// colours. Each of both may be a number.
TEST(Subsurface, CoefficientsMayBeTextures) {
    const auto compare = [](ColorMode color, const std::string& type, const std::string& a, const std::string& s) {
        const auto given = [&](const std::string& name, const std::string& value) {
            return "\"" + type + " " + name + "\" " + value + " ";
        };
        const std::string textures =
            "Texture \"a\" \"spectrum\" \"constant\" " + given("value", a) + "Texture \"s\" \"spectrum\" \"constant\" " + given("value", s);
        const Rendered plain = besideASpot(given("sigma_a", a) + given("sigma_s", s), color);
        EXPECT_GT(estimate(plain.image).mean.g, 0.01);
        for (const std::string& body :
             {std::string("\"texture sigma_a\" \"a\" \"texture sigma_s\" \"s\""), "\"texture sigma_a\" \"a\" " + given("sigma_s", s),
              given("sigma_a", a) + "\"texture sigma_s\" \"s\""})
            EXPECT_LT(distance(besideASpot(body, color, textures).image, plain.image), 1e-3) << body;
    };
    compare(ColorMode::rgb, "rgb", "[.1 .3 1.5]", "[6 4 2]");
    compare(ColorMode::spectral, "rgb", "[.1 .3 1.5]", "[6 4 2]");
    compare(ColorMode::spectral, "spectrum", "[400 1.5 550 .3 700 .1]", "[400 2 550 4 700 6]");
}

// Of a board of two bodies, whose squares are far larger than what is seen, each is a slab by itself.
TEST(Subsurface, ABoardHasTheAlbedosOfItsCoefficients) {
    const auto slab = [](const std::string& more) {
        return "Texture \"board\" \"spectrum\" \"checkerboard\" \"rgb tex1\" [.9 .5 .3] \"rgb tex2\" [.1 .4 .8] " + more +
               " Texture \"s\" \"spectrum\" \"scale\" \"texture tex\" \"board\" \"float scale\" 50\n"
               "Material \"subsurface\" \"rgb sigma_a\" [1 2 3] \"texture sigma_s\" \"s\" \"float g\" .3\n"
               "Shape \"trianglemesh\" \"point3 P\" [-50 -50 0  -50 50 0  50 50 0  50 -50 0] \"integer indices\" [0 1 2 0 2 3] \"point2 "
               "uv\" [0 0 0 1e-4 1e-4 1e-4 1e-4 0]\n";
    };
    const double F = 0.33 * 0.33 / (2.33 * 2.33);
    const auto expected = [&](glm::dvec3 sigmaS) {
        glm::dvec3 A(0);
        for (int c = 0; c < 3; ++c) A[c] = diffuseAlbedo(sigmaS[c] / (sigmaS[c] + 1 + c), .3, 1.33);
        return F + (1 - F) * A;
    };
    expectRadiance(look(whiteSky + slab("")), expected({45, 25, 15}), 0.02);
    expectRadiance(look(whiteSky + slab("\"float udelta\" 1")), expected({5, 20, 40}), 0.02);
}

// A body that nothing happens in keeps out what is around it: of the 9 from the camera to the wall, light goes 7 through the haze, whether
// the camera says that it is there or a ball of radius 3 around both, of which it is 4. Shapes name no media.
TEST(Subsurface, WhatIsAroundABodyGoesOnBehindIt) {
    const std::string wall =
        "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [4 4 4] Material \"diffuse\" \"rgb reflectance\" [0 0 0]\n"
        "Shape \"trianglemesh\" \"point3 P\" [-50 -50 5  -50 50 5  50 50 5  50 -50 5] \"integer indices\" [0 1 2 0 2 3] AttributeEnd\n";
    const std::string haze =
        "MakeNamedMedium \"haze\" \"string type\" \"homogeneous\" \"rgb sigma_a\" [.02 .1 .05] \"rgb sigma_s\" [0 0 0]\n";
    const std::string hole = ball(walk + "\"rgb sigma_a\" [0 0 0] \"rgb sigma_s\" [0 0 0] \"float eta\" 1");
    const glm::dvec3 sigma(.02, .1, .05);
    View view;
    view.maxDepth = 1;
    const std::string text = haze + "MediumInterface \"\" \"haze\"\n" + sceneText(view, "MediumInterface \"\" \"\"\n" + hole + wall);
    expectRadiance(render(text, media()), 4.0 * glm::exp(-sigma * 7.0), 0.02);
    const std::string cloud =
        "AttributeBegin MediumInterface \"haze\" \"\" Material \"interface\" Shape \"sphere\" \"float radius\" 3 AttributeEnd\n";
    expectRadiance(render(sceneText(view, haze + cloud + hole + wall), media()), 4.0 * glm::exp(-sigma * 4.0), 0.02);
}

// A body in a body in a body, none of which scatters, bends or names what is around it: of the way to the wall, 2 * .4 is in the first,
// 2 * .35 in the second and .5 in the third. When a path leaves the third, it is in the second again, and then in the first.
TEST(Subsurface, BodiesStandInBodies) {
    const std::string wall =
        "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [4 4 4] Material \"diffuse\" \"rgb reflectance\" [0 0 0]\n"
        "Shape \"trianglemesh\" \"point3 P\" [-50 -50 5  -50 50 5  50 50 5  50 -50 5] \"integer indices\" [0 1 2 0 2 3] AttributeEnd\n";
    const auto clear = [](const std::string& sigma, double radius) {
        return ball(walk + "\"rgb sigma_s\" [0 0 0] \"float eta\" 1 \"rgb sigma_a\" " + sigma, radius);
    };
    expectRadiance(look(wall + clear("[.1 .2 .3]", 1) + clear("[.4 .3 .1]", .6) + clear("[.2 .2 .9]", .25)),
                   4.0 * glm::exp(-(.8 * glm::dvec3(.1, .2, .3) + .7 * glm::dvec3(.4, .3, .1) + .5 * glm::dvec3(.2, .2, .9))), 0.02);
}

// With boundaries that reflect from both sides, bodies are what dielectric balls are that say which media lie between them.
TEST(Subsurface, ABodyInABodyIsABallOfTwoMedia) {
    View view;
    view.lookAt = "0 0 -4  .1 .05 0  0 1 0";
    view.maxDepth = 50;
    const std::string first = "\"rgb sigma_a\" [.4 .1 .2] \"rgb sigma_s\" [0 0 0]",
                      second = "\"rgb sigma_a\" [0 .2 1] \"rgb sigma_s\" [.2 .2 .2]",
                      named = "MakeNamedMedium \"a\" \"string type\" \"homogeneous\" " + first +
                              "\nMakeNamedMedium \"b\" \"string type\" \"homogeneous\" " + second + "\n";
    const auto glass = [](const std::string& inside, const std::string& outside, double radius) {
        return fmt::format("AttributeBegin MediumInterface \"{}\" \"{}\" Material \"dielectric\" \"float eta\" 1.4 Shape \"sphere\" "
                           "\"float radius\" {} AttributeEnd\n", inside, outside, radius);
    };
    const std::string boundary = walk + "\"float eta\" 1.4 ";
    const Rendered bodies = render(sceneText(view, whiteSky + ball(boundary + first) + ball(boundary + second, .5)), media());
    expectEqualMeans(bodies, render(sceneText(view, named + whiteSky + glass("a", "", 1) + glass("b", "a", .5)), media()), 0.02);
}

// A body rendered by diffusion in one rendered by a walk: as white as a white diffuse ball, from all of which it cannot be told where
// the same light arrives everywhere on it.
TEST(Subsurface, ADiffusingBodyStandsInABody) {
    const std::string outer = ball(walk + "\"rgb sigma_s\" [0 0 0] \"rgb sigma_a\" [.1 .4 .9] \"float eta\" 1");
    const std::string inner = ball("\"string method\" \"diffusion\" \"rgb reflectance\" [1 1 1] \"rgb mfp\" [.01 .01 .01] "
                                   "\"float eta\" 1", .5),
                      paint = "Material \"diffuse\" \"rgb reflectance\" [1 1 1] Shape \"sphere\" \"float radius\" .5\n";
    View view;
    view.maxDepth = 3;
    const auto seen = [&](const std::string& core) { return render(sceneText(view, whiteSky + outer + core), media()); };
    expectEqualMeans(seen(inner), seen(paint), 0.02);
}

// A mix of a white body and white paint is white: light that enters leaves wherever the mix may be the body, also where a mix is in a mix.
TEST(Subsurface, AMixWithADiffusingBodyLosesNothing) {
    const std::string world =
        whiteSky + "MakeNamedMaterial \"body\" \"string type\" \"subsurface\" \"rgb reflectance\" [1 1 1] \"rgb mfp\" [.02 .02 .02]\n"
                   "MakeNamedMaterial \"paint\" \"string type\" \"diffuse\" \"rgb reflectance\" [1 1 1]\n"
                   "MakeNamedMaterial \"half\" \"string type\" \"mix\" \"string materials\" [\"body\" \"paint\"] \"float amount\" .5\n"
                   "Material \"mix\" \"string materials\" [\"paint\" \"{}\"] \"float amount\" .6 Shape \"sphere\" \"float radius\" 1\n";
    for (const char* second : {"body", "half"}) expectRadiance(look(fmt::format(fmt::runtime(world), second)), 1, 0.02);
}

// Uniform directions also enter a body, through a boundary that squeezes radiance by the square of its index.
TEST(Subsurface, UniformDirectionsEnterABody) {
    const std::string body = whiteSky + ball("\"rgb reflectance\" [1 1 1] \"rgb mfp\" [.02 .02 .02] \"float roughness\" .5 "
                                             "\"float eta\" 1.5 \"bool energycompensation\" true");
    View view;
    view.maxDepth = 6;
    const Rendered followed = render(sceneText(view, body));
    view.samples = 4096;
    view.more = "Integrator \"simplepath\" \"bool samplebsdf\" false \"integer maxdepth\" 6";
    expectEqualMeans(render(sceneText(view, body)), followed, 0.03);
}

// Ray trees have a coated diffuse surface instead, of the same albedo. The boundary's reflection is of a mirror, which trees follow, too.
TEST(Subsurface, ATreeOfRaysSeesTheSameAlbedo) {
    View view;
    view.samples = 256;
    view.maxDepth = 1;
    view.more = "Integrator \"whitted\"";
    const std::string body =
        "Material \"subsurface\" \"rgb reflectance\" [.6 .4 .2] \"float eta\" 1.33\n"
        "Shape \"disk\" \"float radius\" 50\n";
    const double F = 0.33 * 0.33 / (2.33 * 2.33);
    const glm::dvec3 seen = estimate(render(packScene(sceneText(view, whiteSky + body), ColorMode::rgb, Warnings::allowed)).image).mean;
    const double expected[] = {.6, .4, .2};
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], F + (1 - F) * expected[c], 0.02);
}

}  // namespace
}  // namespace eikonal
