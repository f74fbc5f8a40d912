// Light from every kind of source on a diffuse floor, against closed forms. The camera looks at the origin of the floor y = 0, whose
// reflectance is rho = 1/2: what it sees is L = rho E / pi, with the irradiance E derived in each test.

#include "rendering.h"

#include <fmt/format.h>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace eikonal {
namespace {

constexpr double rho = 0.5, pi = M_PI;
const std::string floorShape = "Material \"diffuse\" \"rgb reflectance\" [.5 .5 .5]\n"
    "Shape \"trianglemesh\" \"point3 P\" [-50 0 -50  50 0 -50  50 0 50  -50 0 50] \"integer indices\" [0 1 2 0 2 3]\n";

View atTheOrigin(int maxDepth = 1) {
    View view;
    view.lookAt = "0 1 -2  0 0 0  0 1 0";
    view.maxDepth = maxDepth;
    return view;
}
Rendered onTheFloor(const std::string& light) { return render(sceneText(atTheOrigin(), light + "\n" + floorShape), surfaces()); }

std::string emitter(const std::string& shape, const std::string& more = "") {
    return "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [4 4 4] " + more + " Material \"diffuse\" \"rgb reflectance\" [0 0 0]\n" + shape + "\nAttributeEnd";
}
constexpr double Le = 4;

// E = I cos / d^2 from (1, 2, .5): d^2 = 5.25, cos = 2 / d.
TEST(Light, APointFallsOffWithTheSquareOfTheDistance) {
    expectRadiance(onTheFloor("LightSource \"point\" \"rgb I\" [3 2 1] \"point3 from\" [1 2 .5]"), rho / pi * glm::dvec3(3, 2, 1) * 2. / std::pow(5.25, 1.5));
}

// From straight above at height 2 with the axis turned away by an angle: all of I inside of the inner cone (20 degrees), none outside of the outer
// one (30), and smoothstep of the cosine between them.
TEST(Light, ASpotHasACone) {
    const double inner = std::cos(20 * pi / 180), outer = std::cos(30 * pi / 180);
    for (double angle : {0., 15., 24., 27., 35.}) {
        SCOPED_TRACE(angle);
        const double cosine = std::cos(angle * pi / 180), t = std::clamp((cosine - outer) / (inner - outer), 0., 1.);
        const Rendered r = onTheFloor(fmt::format("LightSource \"spot\" \"rgb I\" [3 3 3] \"float coneangle\" 30 \"float conedeltaangle\" 10 \"point3 from\" [0 2 0] \"point3 to\" [{} 0 0]",
                                                  2 * std::tan(angle * pi / 180)));
        /* The cosine is rounded to a float: near the rim that shows */
        const Estimate e = estimate(r.image);
        EXPECT_NEAR(e.mean.g, rho / pi * 3 / 4 * t * t * (3 - 2 * t), 2e-5);
    }
}

// E = L cos, whatever the distance.
TEST(Light, ADistantOneLosesTheCosine) {
    expectRadiance(onTheFloor("LightSource \"distant\" \"rgb L\" [3 2 1] \"point3 from\" [3 4 0] \"point3 to\" [0 0 0]"), rho / pi * glm::dvec3(3, 2, 1) * 0.8);
}

// E = pi L for a sky all over.
TEST(Light, ASkyLightsTheFloorEvenly) { expectRadiance(onTheFloor("LightSource \"infinite\" \"rgb L\" [1 1 1]"), rho); }

// A disk of radius R parallel to the floor at height h: E = pi L R^2 / (R^2 + h^2).
TEST(Light, ADisk) {
    expectRadiance(onTheFloor(emitter("Translate 0 2 0 Rotate 90 1 0 0 Shape \"disk\" \"float radius\" 1.5")), rho * Le * 2.25 / (2.25 + 4));
}
// A ring is the difference of two.
TEST(Light, ARing) {
    expectRadiance(onTheFloor(emitter("Translate 0 2 0 Rotate 90 1 0 0 Shape \"disk\" \"float radius\" 1.5 \"float innerradius\" 1")),
                   rho * Le * (2.25 / (2.25 + 4) - 1. / (1 + 4)));
}

// A sphere of radius r with its centre at height d: E = pi L (r / d)^2, as if all of it came from straight above.
TEST(Light, ASphere) {
    expectRadiance(onTheFloor(emitter("Translate 0 2 0 Shape \"sphere\" \"float radius\" .8")), rho * Le * 0.16);
}

// A wall around the point, from height a to b at distance R, fills a band of angles: E = pi L (sin^2 - sin^2) = pi L R^2 (1 / (R^2 + a^2) - 1 / (R^2 + b^2))
// where it is whole, and as much of that as of the circle. Its outside does not shine.
TEST(Light, ACylinder) {
    const double band = 9 / (9 + .25) - 9 / (9 + 9.);
    const std::string wall = "Rotate -90 1 0 0 Shape \"cylinder\" \"float radius\" 3 \"float zmin\" .5 \"float zmax\" 3";
    expectRadiance(onTheFloor(emitter("ReverseOrientation " + wall)), rho * Le * band);
    expectRadiance(onTheFloor(emitter("ReverseOrientation " + wall + " \"float phimax\" 270")), rho * Le * band * 0.75);
    expectRadiance(onTheFloor(emitter(wall)), 0);
}

// A rectangle parallel to the floor at height 1 with a corner above the origin, sides a and b (Howell's catalogue of configuration factors, B-4):
// E = L / 2 (a / sqrt(1 + a^2) atan(b / sqrt(1 + a^2)) + b / sqrt(1 + b^2) atan(a / sqrt(1 + b^2))).
double irradianceOfRectangle(double a, double b) {
    const double p = std::sqrt(1 + a * a), q = std::sqrt(1 + b * b);
    return Le / 2 * (a / p * std::atan(b / p) + b / q * std::atan(a / q));
}
TEST(Light, ARectangleOfTriangles) {
    expectRadiance(onTheFloor(emitter("Shape \"trianglemesh\" \"point3 P\" [0 1 0  1.2 1 0  1.2 1 .7  0 1 .7] \"integer indices\" [0 1 2 0 2 3]")),
                   rho / pi * irradianceOfRectangle(1.2, .7));
}
TEST(Light, ARectangleAsABilinearPatch) {
    expectRadiance(onTheFloor(emitter("Shape \"bilinearmesh\" \"point3 P\" [0 1 0  1.2 1 0  0 1 .7  1.2 1 .7]")), rho / pi * irradianceOfRectangle(1.2, .7));
}

// Only one side shines, unless both are asked to.
TEST(Light, TheBackOfAnEmitterIsDarkUnlessItIsTwoSided) {
    const std::string away = "Shape \"trianglemesh\" \"point3 P\" [0 1 0  0 1 .7  1.2 1 .7  1.2 1 0] \"integer indices\" [0 1 2 0 2 3]";
    EXPECT_EQ(estimate(onTheFloor(emitter(away)).image).mean, glm::dvec3(0));
    expectRadiance(onTheFloor(emitter(away, "\"bool twosided\" true")), rho / pi * irradianceOfRectangle(1.2, .7));
}

// ---- what does not shine alike all over -------------------------------------------------------------------------------------

const std::string leftHalf = "Texture \"half\" \"float\" \"checkerboard\" \"float uscale\" 2\n";
const std::string rectanglePatch = "Shape \"bilinearmesh\" \"point3 P\" [0 1 0  1.2 1 0  0 1 .7  1.2 1 .7] ";
const std::string rectangleTriangles = "Shape \"trianglemesh\" \"point3 P\" [0 1 0  1.2 1 0  1.2 1 .7  0 1 .7] \"point2 uv\" [0 0  1 0  1 1  0 1] \"integer indices\" [0 1 2 0 2 3] ";

// Where alpha is 0 nothing shines: half of a rectangle; half of a disk or a sphere above the floor, by symmetry; and any alpha between takes its share.
TEST(LightPattern, WhatIsCutOutIsDark) {
    const std::string half = "\"texture alpha\" \"half\"";
    for (const std::string& rectangle : {rectanglePatch, rectangleTriangles}) {
        SCOPED_TRACE(rectangle);
        expectRadiance(onTheFloor(leftHalf + emitter(rectangle + half)), rho / pi * irradianceOfRectangle(.6, .7));
        expectRadiance(onTheFloor(emitter(rectangle + "\"float alpha\" .3")), rho / pi * .3 * irradianceOfRectangle(1.2, .7));
    }
    expectRadiance(onTheFloor(leftHalf + emitter("Translate 0 2 0 Rotate 90 1 0 0 Shape \"disk\" \"float radius\" 1.5 " + half)), rho * Le * 2.25 / (2.25 + 4) / 2);
    expectRadiance(onTheFloor(leftHalf + emitter("Translate 0 2 0 Rotate 90 1 0 0 Shape \"sphere\" \"float radius\" .8 " + half)), rho * Le * 0.16 / 2);
}

// Without its lower half (u < 1/2 is y > 0), a sphere that shines inside as well looks like a disk of its radius at its centre.
TEST(LightPattern, TheFarSideOfASphereIsSeenThroughItsHole) {
    expectRadiance(onTheFloor(leftHalf + emitter("Translate 0 2 0 Shape \"sphere\" \"float radius\" .8 \"texture alpha\" \"half\"", "\"bool twosided\" true")),
                   rho * Le * 0.64 / (0.64 + 4));
}

// An image of a red and a blue texel on the rectangle: blue rises from u = 1/4 to u = 3/4, red falls; E by quadrature.
TEST(LightPattern, AnImageShinesWhereItIsBright) {
    const auto file = std::filesystem::temp_directory_path() / fmt::format("eikonal_light_{}.ppm", ::getpid());
    std::ofstream(file) << "P3\n2 1\n255\n255 0 0 0 0 255\n";
    glm::dvec3 E(0);
    constexpr int n = 400;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const double u = (i + .5) / n, blue = std::clamp(2 * u - .5, 0., 1.), d2 = 1 + std::pow(1.2 * u, 2) + std::pow(.7 * (j + .5) / n, 2);
            E += glm::dvec3(1 - blue, 0, blue) * Le * (1.2 * .7 / (n * n)) / (d2 * d2);
        }
    for (const std::string& rectangle : {rectanglePatch, rectangleTriangles}) {
        SCOPED_TRACE(rectangle);
        const std::string L = fmt::format("AreaLightSource \"diffuse\" \"string filename\" \"{}\" ", file.string());
        const auto lit = [&](const std::string& more) {
            return onTheFloor("AttributeBegin " + L + more + " Material \"diffuse\" \"rgb reflectance\" [0 0 0]\n" + rectangle + "\nAttributeEnd");
        };
        expectRadiance(lit("\"float scale\" 4"), rho / pi * E);
        /* In watts, of each triangle or patch (as in pbrt-v4): pi times the area times the mean luminance, of which red has 0.2126 and blue 0.0722 */
        const double elements = rectangle == rectangleTriangles ? 2 : 1;
        expectRadiance(lit("\"float power\" 3"), rho / pi * E / Le * 3. * elements / (pi * 1.2 * .7 * (0.2126 + 0.0722) / 2));
    }
    std::filesystem::remove(file);
}

// What shines looks as bright from everywhere, and no light is added to it at maxdepth 0.
TEST(Light, AnEmitterLooksAsBrightAsItIs) {
    for (const char* shape : {"Shape \"sphere\" \"float radius\" .3", "Rotate 20 1 1 0 ReverseOrientation Shape \"disk\" \"float radius\" .3"}) {
        SCOPED_TRACE(shape);
        View view;
        view.maxDepth = 0;
        expectRadiance(render(sceneText(view, emitter(shape)), surfaces()), Le);
    }
}

// Lights add up, whichever is picked how often.
TEST(Light, ManyLightsAddUp) {
    expectRadiance(onTheFloor("LightSource \"point\" \"rgb I\" [3 3 3] \"point3 from\" [0 2 0]\nLightSource \"distant\" \"rgb L\" [.1 .1 .1] \"point3 from\" [1 1 0] \"point3 to\" [0 0 0]\n" +
                              emitter("Translate 0 2.5 0 Shape \"sphere\" \"float radius\" .1") + "\nLightSource \"point\" \"rgb I\" [.01 .01 .01] \"point3 from\" [0 .1 0]"),
                   rho / pi * (3. / 4 + 0.1 * std::sqrt(0.5) + Le * pi * 0.0016 + 1), 0.06);
}

// ---- lights with an image, portals, and light samplers --------------------------------------------------------------------

/// Three times three texels, of which only the middle one is not black.
class ImageLights : public testing::Test {
protected:
    ImageLights() { std::ofstream(file_) << "P3\n3 3\n255\n0 0 0 0 0 0 0 0 0\n0 0 0 255 188 137 0 0 0\n0 0 0 0 0 0 0 0 0\n"; }
    ~ImageLights() override { std::filesystem::remove(file_); }
    /// At height 2, its +z turned by an angle from the floor's origin, in degrees.
    std::string slide(double angle) const {
        return fmt::format("AttributeBegin Translate 0 2 0 Rotate {} 1 0 0 LightSource \"projection\" \"float fov\" 90 \"float scale\" 3 \"string filename\" \"{}\" AttributeEnd\n", 90 + angle, file_.string());
    }
    /// The same with its +y.
    std::string lamp(double angle) const {
        return fmt::format("AttributeBegin Translate 0 2 0 Rotate {} 1 0 0 LightSource \"goniometric\" \"rgb I\" [3 1 2] \"string filename\" \"{}\" AttributeEnd\n", 180 + angle, file_.string());
    }
    static double linear(double byte) { return std::pow((byte / 255 + 0.055) / 1.055, 2.4); }
    static inline const glm::dvec3 texel{1, linear(188), linear(137)};
    static inline const glm::dvec3 fromSlide = rho / pi * 3. / 4 * texel, fromLamp = rho / pi / 4 * (texel.x + texel.y + texel.z) / 3 * glm::dvec3(3, 1, 2);

private:
    const std::filesystem::path file_ = std::filesystem::temp_directory_path() / fmt::format("eikonal_light_image_{}.ppm", ::getpid());
};

// E = I / d^2. The middle texel of the slide ends at atan(1/3) = 18.4 degrees. That of the lamp, a third of the square, is met in its middle:
// there z = 1 - (1/3)^2 in Clarberg's mapping, which is at 27.3 degrees.
TEST_F(ImageLights, SendAsTheirImageSays) {
    expectRadiance(onTheFloor(slide(0)), fromSlide);
    expectRadiance(onTheFloor(slide(17)), fromSlide);
    expectRadiance(onTheFloor(slide(20)), glm::dvec3(0));
    expectRadiance(onTheFloor(lamp(0)), fromLamp);
    expectRadiance(onTheFloor(lamp(26)), fromLamp);
    expectRadiance(onTheFloor(lamp(29)), glm::dvec3(0));
}

// All of them at wavelengths, with a portal and a light tree.
TEST_F(ImageLights, AreTheSameAtWavelengths) {
    View view = atTheOrigin();
    view.sampler = "sobol";
    view.samples = 1024;
    view.more = "Integrator \"volpath\" \"integer maxdepth\" 1 \"string lightsampler\" \"bvh\"";
    const std::string sky = "LightSource \"infinite\" \"rgb L\" [4 3 1] \"point3 portal\" [0 1 0  1.2 1 0  1.2 1 .7  0 1 .7]\n";
    const glm::dvec3 seen = estimate(render(packScene(sceneText(view, slide(0) + lamp(0) + sky + floorShape), ColorMode::spectral)).image).mean;
    const glm::dvec3 expected = fromSlide + fromLamp + rho / pi * irradianceOfRectangle(1.2, .7) / Le * glm::dvec3(4, 3, 1);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c] / expected[c], 1, 0.01) << "channel " << c;
}

// A sky of radiance Le that comes in through a rectangle lights the floor as a rectangle of that radiance does, and is as bright.
TEST(Light, APortalIsARectangleOfSky) {
    const std::string sky = "LightSource \"infinite\" \"rgb L\" [4 4 4] ";
    expectRadiance(onTheFloor(sky + "\"point3 portal\" [0 1 0  0 1 .7  1.2 1 .7  1.2 1 0]"), glm::dvec3(0));
    expectRadiance(onTheFloor(sky + "\"point3 portal\" [0 1 0  1.2 1 0  1.2 1 .7  0 1 .7]"), rho / pi * irradianceOfRectangle(1.2, .7));
    View view;
    view.maxDepth = 0;
    expectRadiance(render(sceneText(view, sky + "\"point3 portal\" [-1 -1 1  -1 1 1  1 1 1  1 -1 1]"), surfaces()), Le);
    expectRadiance(render(sceneText(view, sky + "\"point3 portal\" [1 -1 1  1 1 1  2 1 1  2 -1 1]"), surfaces()), glm::dvec3(0));
}

// Whoever chooses the lights, they add up to the same.
TEST(Light, EverySamplerAddsUpToTheSame) {
    for (const char* sampler : {"bvh", "power", "uniform"}) {
        SCOPED_TRACE(sampler);
        View view = atTheOrigin();
        view.more = fmt::format("Integrator \"volpath\" \"integer maxdepth\" 1 \"string lightsampler\" \"{}\"", sampler);
        const std::string lights = "LightSource \"infinite\" \"rgb L\" [.2 .2 .2]\nLightSource \"point\" \"rgb I\" [3 3 3] \"point3 from\" [0 2 0]\n"
            "LightSource \"distant\" \"rgb L\" [.1 .1 .1] \"point3 from\" [1 1 0] \"point3 to\" [0 0 0]\n" +
            emitter("Translate 0 2.5 0 Shape \"sphere\" \"float radius\" .1") + "\nLightSource \"point\" \"rgb I\" [.01 .01 .01] \"point3 from\" [0 .1 0]";
        /* The lamp hides a part of the sky: that of its cone, which is (r / h)^2 of the cosine-weighted half */
        expectRadiance(render(sceneText(view, lights + "\n" + floorShape), surfaces()), rho / pi * (3. / 4 + 0.1 * std::sqrt(0.5) + Le * pi * 0.0016 + 1 + 0.2 * pi * (1 - 0.0016)), 0.06);
    }
}

// ---- what stands between ------------------------------------------------------------------------------------------------

const std::string brightWall = "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [4 4 4] Material \"diffuse\" \"rgb reflectance\" [0 0 0]\n"
    "Shape \"trianglemesh\" \"point3 P\" [-50 -50 5  -50 50 5  50 50 5  50 -50 5] \"integer indices\" [0 1 2 0 2 3] AttributeEnd\n";
const std::string card = "Shape \"trianglemesh\" \"point3 P\" [-9 -9 Z  9 -9 Z  9 9 Z  -9 9 Z] \"integer indices\" [0 1 2 0 2 3]\n";
std::string cardAt(double z, const std::string& material, const std::string& more = "") {
    std::string text = card;
    for (size_t at; (at = text.find('Z')) != std::string::npos;) text.replace(at, 1, fmt::format("{}", z));
    text.pop_back();
    return "AttributeBegin Material " + material + "\n" + text + " " + more + " AttributeEnd\n";
}
Rendered throughCards(const std::string& cards, int maxDepth = 100) {
    View view;
    view.maxDepth = maxDepth;
    return render(sceneText(view, brightWall + cards), surfaces());
}

// Black paper with half of it (at random) not there, twice: a quarter of the wall is seen.
TEST(Light, HalfOfAlphaIsHalfOfTheLight) {
    const std::string black = "\"diffuse\" \"rgb reflectance\" [0 0 0]";
    expectRadiance(throughCards(cardAt(0, black, "\"float alpha\" .5")), Le / 2);
    expectRadiance(throughCards(cardAt(0, black, "\"float alpha\" .5") + cardAt(1, black, "\"float alpha\" .5")), Le / 4, 0.02);
}

// Shadow rays see the same holes.
TEST(Light, AlphaLetsShadowRaysPass) {
    expectRadiance(onTheFloor("LightSource \"point\" \"rgb I\" [3 3 3] \"point3 from\" [0 2 0]\nAttributeBegin Material \"diffuse\" Translate 0 1.5 0 Rotate 90 1 0 0 "
                              "Shape \"disk\" \"float radius\" .2 \"float alpha\" .25 AttributeEnd"), rho / pi * 3. / 4 * 0.75);
}

// Straight on, a boundary reflects R = ((eta - 1) / (eta + 1))^2 = 0.04 for eta = 1.5; between two of them light goes to and fro, so that
// (1 - R)^2 (1 + R^2 + R^4 + ...) = (1 - R) / (1 + R) gets through. One thin sheet is the same as a slab of two boundaries.
TEST(Light, APaneTransmitsWhatTwoBoundariesDo) {
    const double R = 0.04, T = (1 - R) / (1 + R);
    expectRadiance(throughCards(cardAt(0, "\"thindielectric\" \"float eta\" 1.5")), Le * T);
    expectRadiance(throughCards("AttributeBegin Material \"dielectric\" \"float eta\" 1.5 Scale 9 9 .5 Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3 4 6 5 4 7 6] "
                                "\"point3 P\" [-1 -1 -1  -1 1 -1  1 1 -1  1 -1 -1  -1 -1 1  -1 1 1  1 1 1  1 -1 1] AttributeEnd"), Le * T);
}

// A mix is each of its materials as often as it says: under a sky, the mean of what they reflect.
TEST(Light, AMixReflectsTheMean) {
    View view;
    view.maxDepth = 1;
    expectRadiance(render(sceneText(view, R"(LightSource "infinite" "rgb L" [1 1 1]
        MakeNamedMaterial "dark" "string type" "diffuse" "rgb reflectance" [.2 .2 .2]
        MakeNamedMaterial "bright" "string type" "diffuse" "rgb reflectance" [.8 .8 .8]
        Material "mix" "string materials" ["dark" "bright"] "float amount" .25 Shape "sphere")"), surfaces()), 0.75 * 0.2 + 0.25 * 0.8);
}

// ---- three ways to the same number ----------------------------------------------------------------------------------------

// Direct light on a rough metal and a diffuse floor under a large and a small lamp, by both strategies weighted against each other, by BSDF sampling
// alone (the light sampler never picks a light: `pmf` 0 in its table, include/eikonal/lights.h), and by light sampling alone (lamps with an alpha of 0
// cannot be hit, but shine, as in pbrt-v4). All have the same expectation.
void expectStrategiesAgree(const std::string& material, const std::string& lamps) {
    View view = atTheOrigin(1);
    view.samples = 1024;
    const auto scene = [&](const std::string& alpha) {
        std::string shining = lamps;
        for (size_t at; (at = shining.find("@")) != std::string::npos;) shining.replace(at, 1, alpha);
        return sceneText(view, shining + "\nMaterial " + material + "\nShape \"disk\" \"float radius\" 9 ");
    };
    view.more = "";
    RenderSetup bsdfOnly = surfaces();
    bsdfOnly.edit = [](PackedScene& s) { for (light& l : s.tables.lights) l.pmf = 0; };
    const Rendered both = render(scene(""), surfaces()), bsdf = render(scene(""), bsdfOnly), light = render(scene("\"float alpha\" 0"), surfaces());
    expectEqualMeans(both, bsdf, 0.03);
    expectEqualMeans(both, light, 0.03);
    /* And weighting pays: neither strategy alone has less noise than both by more than chance */
    const double noise = estimate(both.image).error.g;
    EXPECT_LT(noise, 1.5 * std::min(estimate(bsdf.image).error.g, estimate(light.image).error.g));
}

const std::string lamps = R"(Rotate -90 1 0 0
    AttributeBegin AreaLightSource "diffuse" "rgb L" [1 1 1] Translate 0 -2 1.4 Rotate 60 1 0 0 Shape "sphere" "float radius" .8 @ AttributeEnd
    AttributeBegin AreaLightSource "diffuse" "rgb L" [9 9 9] Translate .3 1 2 ReverseOrientation Shape "disk" "float radius" .4 @ AttributeEnd
    AttributeBegin AreaLightSource "diffuse" "rgb L" [2 2 2] "bool twosided" true Shape "trianglemesh" "point3 P" [-1 1 1  -1 3 1  -1.5 2 2] @ AttributeEnd)";

TEST(Strategies, AgreeOnADiffuseFloor) { expectStrategiesAgree("\"diffuse\"", lamps); }
TEST(Strategies, AgreeOnRoughMetal) { expectStrategiesAgree("\"conductor\" \"float roughness\" .3", lamps); }

// The same with a light tree: what a path finds by itself has the probability of the tree, which depends on where it came from.
TEST(Strategies, AgreeWithALightTree) {
    View view = atTheOrigin(2);
    view.samples = 1024;
    view.more = "Integrator \"volpath\" \"integer maxdepth\" 2 \"string lightsampler\" \"bvh\"";
    RenderSetup bsdfOnly = surfaces();
    bsdfOnly.edit = [](PackedScene& s) {
        for (light& l : s.tables.lights) l.pmf = 0;
        s.frame().lights_in_tree = s.frame().infinite_count = 0;
    };
    for (const char* material : {"\"diffuse\"", "\"conductor\" \"float roughness\" .3"}) {
        SCOPED_TRACE(material);
        std::string shining = lamps;
        for (size_t at; (at = shining.find("@")) != std::string::npos;) shining.replace(at, 1, "");
        const std::string text = sceneText(view, shining + "\nMaterial " + material + "\nShape \"disk\" \"float radius\" 9 ");
        const Rendered both = render(text, surfaces()), bsdf = render(text, bsdfOnly);
        expectEqualMeans(both, bsdf, 0.03);
        EXPECT_LT(estimate(both.image).error.g, 1.5 * estimate(bsdf.image).error.g);
    }
}

// The same for a sky: an environment is light that only misses find.
TEST(Strategies, AgreeUnderASky) {
    View view = atTheOrigin(1);
    view.samples = 1024;
    RenderSetup bsdfOnly = surfaces();
    bsdfOnly.edit = [](PackedScene& s) { for (light& l : s.tables.lights) l.pmf = 0; };
    const std::string scene = sceneText(view, "LightSource \"infinite\" \"rgb L\" [1 1 1]\nMaterial \"conductor\" \"float roughness\" .3\nTranslate 0 -1 0 Shape \"sphere\"");
    expectEqualMeans(render(scene, surfaces()), render(scene, bsdfOnly), 0.01);
}

}  // namespace
}  // namespace eikonal
