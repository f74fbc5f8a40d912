// Furnaces: light from everywhere and matter that loses none of it. Then the radiance is the same everywhere, whatever stands there.

#include "measured_file.h"
#include "rendering.h"
#include "color/sensor.h"
#include "color/spectrum.h"

#include <fmt/format.h>

#include <unistd.h>

#include <cmath>
#include <filesystem>

namespace eikonal {
namespace {

/// A ball under a sky of radiance 1, seen in its middle and a little aside (so that angles are not special).
Rendered underWhiteSky(const std::string& material, const std::string& shape = "Shape \"sphere\" \"float radius\" 1", int maxDepth = 100) {
    View view;
    view.lookAt = "0 0 -4  .4 .3 0  0 1 0";
    view.maxDepth = maxDepth;
    return render(sceneText(view, "LightSource \"infinite\" \"rgb L\" [1 1 1]\n" + material + "\n" + shape), surfaces());
}

// A sphere of radius 1 that reflects rho = 1/2, I = pi in its middle: direct irradiance E = I, and every bounce spreads evenly over the
// sphere, whose points see each other all alike, so L = rho E / (pi (1 - rho)) = 1.
TEST(Furnace, AClosedDiffuseSphereAroundAPointLightIsOne) {
    View view;
    view.lookAt = ".3 -.2 -.4  0 0 1  0 1 0";
    view.fov = 90;
    view.maxDepth = 60;
    expectRadiance(render(sceneText(view, R"(LightSource "point" "rgb I" [3.14159265 3.14159265 3.14159265]
        Material "diffuse" "rgb reflectance" [.5 .5 .5] Shape "sphere")"), surfaces()), 1, 0.003);
}

// A ball that glows with L = 1 and reflects rho = 1/2: each bounce finds rho times the light of the one before.
TEST(Furnace, AGlowingBallHasTheLightOfItsBounces) {
    View view;
    view.lookAt = ".3 -.2 -.4  0 0 1  0 1 0";
    view.fov = 90;
    double expected = 1;
    for (int bounces : {1, 2, 3, 4}) {
        view.maxDepth = bounces;
        expected += std::pow(0.5, bounces);
        expectRadiance(render(sceneText(view, R"(Material "diffuse" "rgb reflectance" [.5 .5 .5]
            AreaLightSource "diffuse" "rgb L" [1 1 1] "bool twosided" true Shape "sphere")")), expected, 0.001);
    }
}

// Radiance 1 from everywhere solves the transport equation for whatever reflects or transmits everything.
TEST(Furnace, WhiteDiffuse) { expectRadiance(underWhiteSky("Material \"diffuse\" \"rgb reflectance\" [1 1 1]"), 1, 0.002); }

// The whole image at once: a bowl, in which light goes round, a ball, a tent. Light left in the bowl after 100 bounces: below 2^-50.
TEST(Furnace, WhiteThingsOfEveryShapeCannotBeSeen) {
    View view;
    view.lookAt = "0 3 -5  0 .4 0  0 1 0";
    view.fov = 40;
    view.maxDepth = 100;
    expectRadiance(render(sceneText(view, R"(LightSource "infinite" "rgb L" [1 1 1]
        Material "diffuse" "rgb reflectance" [1 1 1]
        AttributeBegin Translate -.8 1 0 Rotate -90 1 0 0 Shape "sphere" "float radius" 1 "float zmin" -1 "float zmax" 0 AttributeEnd
        AttributeBegin Translate 1.2 .5 .4 Shape "sphere" "float radius" .5 Shape "disk" "float radius" .8 "float height" .5 AttributeEnd
        Shape "trianglemesh" "integer indices" [0 1 2 1 0 3] "point3 P" [.5 1.2 -1  1.7 1.2 -1  1.1 .2 -.4  1.1 .2 -1.6]
        AttributeBegin Translate -.2 .6 -1 Rotate 40 1 0 1 Shape "cylinder" "float radius" .3 "float zmax" .6 "float phimax" 300
            AttributeEnd
        Shape "curve" "string type" "cylinder" "float width" .3 "point3 P" [-1.5 .2 -1.5  -.5 1.5 -1.5  .5 -.5 -1.5  1.5 .6 -1.2]
        AttributeBegin Translate .3 .3 -1.4 Scale .8 .8 .8 Shape "implicit" "string F" "x^2*y^2 + y^2*z^2 + z^2*x^2 - x*y*z"
            "point3 bounds" [-.5 -.5 -.5 .5 .5 .5] AttributeEnd
        Shape "loopsubdiv" "point3 P" [.2 1 .5  .6 1.6 .5  .6 1 1  .1 1.2 .9] "integer indices" [0 1 2 0 2 3 0 3 1 1 3 2]
        Shape "bilinearmesh" "point3 P" [-1 0 -1  1 .3 -1  -1 .3 1  1 0 1])"),
                          surfaces()),
                   1, 0.002);
}

TEST(Furnace, WhiteDiffuseOnBothSides) {
    expectRadiance(underWhiteSky("Material \"diffusetransmission\" \"rgb reflectance\" [.4 .4 .4] \"rgb transmittance\" [.6 .6 .6]"), 1,
                   0.005);
}

// At wavelengths: a ball under a white sky has the colour that its reflectance was given as, since that is what the smooth spectrum is made
// for; and white glass that disperses cannot be seen, whichever wavelength is left.
TEST(Furnace, AColorIsItselfAtWavelengths) {
    View view;
    view.samples = 1024;
    view.sampler = "sobol";
    const auto seen = [&](const std::string& material) {
        const PackedScene scene = packScene(
            sceneText(view, "LightSource \"infinite\" \"rgb L\" [1 1 1]\n" + material + "\nShape \"sphere\""), ColorMode::spectral);
        return estimate(render(scene).image).mean;
    };
    const glm::dvec3 wall = seen("Material \"diffuse\" \"rgb reflectance\" [.8 .3 .1]"),
                     glass = seen("Material \"dielectric\" \"spectrum eta\" \"glass-F11\"");
    const double expected[] = {.8, .3, .1};
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(wall[c], expected[c], 2e-3);
        EXPECT_NEAR(glass[c], 1, 4e-3);
    }
}

// Under a tube, what a paint of measured reflectance sends to a camera: the sum over 360, 361, ... 830 nm of response * light *
// reflectance, the light divided by its own sum with the matching function y; times 200 / 100. Seen by the eye, the same with the matching
// functions.
TEST(Furnace, ACameraSeesTheProductOfSpectra) {
    const DenseCurve tube = Spectrum::sampled(namedSpectrum("stdillum-F11")).dense(),
                     paint = densify({{400, 500, 600, 700}, {.1, .8, .3, .9}});
    View view;
    view.samples = 1024;
    view.sampler = "sobol";
    const std::string text = sceneText(view,
                                       "LightSource \"infinite\" \"spectrum L\" \"stdillum-F11\" Material \"diffuse\" \"spectrum "
                                       "reflectance\" [400 .1 500 .8 600 .3 700 .9] Shape \"sphere\"");
    for (const SensorDescription& sensor :
         {SensorDescription{.imagingRatio = 2}, {.name = "nikon_d810", .whiteBalance = 3200, .imagingRatio = 2}}) {
        std::string film = text;
        film.insert(film.find("\"rgb\"") + 5,
                    fmt::format(" \"float iso\" 200 \"string sensor\" \"{}\" \"float whitebalance\" {}", sensor.name, sensor.whiteBalance));
        glm::dvec3 expected(0);
        const auto response = linearSrgbResponse(sensor);
        for (int i = 0; i < wavelengthCount; ++i) expected += response[i] * tube[i] * paint[i] / integrateXyz(tube).y;
        const glm::dvec3 seen = estimate(render(packScene(film)).image).mean;
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], expected[c], 4e-3) << sensor.name;
    }
}

// A mirror of reflectance r has the k of a metal that reflects min(r, 0.9999) straight on (as in pbrt-v4); every path has that weight once,
// a little more at an angle.
TEST(Furnace, AMirrorReflectsAllButATenThousandth) {
    const Estimate e = estimate(underWhiteSky("Material \"conductor\" \"rgb reflectance\" [1 1 1] \"float roughness\" 0").image);
    EXPECT_NEAR(e.mean.g, 0.9999, 5e-5);
}

// One bounce off microfacets loses what would bounce again: nothing to speak of where they are flat, never a gain.
TEST(Furnace, RoughMetalNeverGains) {
    for (const char* roughness : {".001", ".01", ".1", ".3", "1"}) {
        const Rendered r =
            underWhiteSky("Material \"conductor\" \"rgb reflectance\" [1 1 1] \"bool remaproughness\" false \"float roughness\" " +
                          std::string(roughness));
        const Estimate e = estimate(r.image);
        EXPECT_LE(e.mean.g, 1 + standardErrors * e.error.g) << roughness;
        EXPECT_GE(e.mean.g, std::atof(roughness) < 0.2 ? 0.98 : 0.3) << roughness;
        EXPECT_EQ(r.invalid.count, 0u);
    }
}

// Radiance is squeezed by eta^2 on its way in and stretched by the same on its way out; Fresnel's parts add up to one.
TEST(Furnace, ClearGlassCannotBeSeen) { expectRadiance(underWhiteSky("Material \"dielectric\" \"float eta\" 1.5"), 1, 0.005); }
// So does a surface that is given by a formula: of a torus, which light passes through twice or is led around in; and of a shell between
// two balls.
TEST(Furnace, AGlassTorusCannotBeSeen) {
    for (const char* F : {"(x^2 + y^2 + z^2 + .3456)^2 - 1.7424*(x^2 + y^2)", "abs(sqrt(x^2 + y^2 + z^2) - .8) - .1"})
        expectRadiance(underWhiteSky("Material \"dielectric\" \"float eta\" 1.5",
                                     "Shape \"implicit\" \"point3 bounds\" [-1 -1 -1 1 1 1] \"string F\" \"" + std::string(F) + "\""),
                       1, 0.005);
}
TEST(Furnace, AnAirBubbleCannotBeSeen) { expectRadiance(underWhiteSky("Material \"dielectric\" \"float eta\" .7"), 1, 0.005); }
TEST(Furnace, ThinGlassCannotBeSeen) { expectRadiance(underWhiteSky("Material \"thindielectric\" \"float eta\" 1.8"), 1, 0.005); }

TEST(Furnace, RoughGlassNeverGains) {
    for (const char* roughness : {".01", ".1", ".5"}) {
        const Rendered r = underWhiteSky("Material \"dielectric\" \"float eta\" 1.5 \"bool remaproughness\" false \"float roughness\" " +
                                         std::string(roughness));
        const Estimate e = estimate(r.image);
        EXPECT_LE(e.mean.g, 1 + standardErrors * e.error.g) << roughness;
        EXPECT_GE(e.mean.g, std::atof(roughness) < 0.2 ? 0.97 : 0.6) << roughness;
        EXPECT_EQ(r.invalid.count, 0u);
    }
}

/// A ball under the white sky, its first point seen at a cosine to the normal.
Estimate seenAt(double cosine, const std::string& material) {
    const double sine = std::sqrt(1 - cosine * cosine);
    View view;
    view.lookAt = fmt::format("{} 0 {}  0 0 -1  0 1 0", 4 * sine, -1 - 4 * cosine);
    view.maxDepth = 200;
    const Rendered r = render(sceneText(view, "LightSource \"infinite\" \"rgb L\" [1 1 1]\nMaterial " + material +
                                                  " \"bool energycompensation\" true \"bool remaproughness\" false\nShape \"sphere\""),
                              surfaces());
    EXPECT_EQ(r.invalid.count, 0u);
    return estimate(r.image);
}

// With compensation, rough metal and rough glass lose nothing: single scattering keeps 0.3 of the light at alpha 1. The tables of lost
// energy are interpolated, and a metal of reflectance 1 absorbs a ten thousandth.
TEST(Furnace, CompensatedSurfacesLoseNothing) {
    for (const char* kind : {R"("conductor" "rgb reflectance" [1 1 1])", R"("dielectric" "float eta" 1.5)",
                             R"("dielectric" "float eta" .7)", R"("dielectric" "float eta" 1.0000001)"})
        for (const char* widths : {R"("float roughness" .1)", R"("float roughness" .4)", R"("float roughness" 1)",
                                   R"("float uroughness" 1 "float vroughness" .2)", R"("float uroughness" .2 "float vroughness" 1)"})
            for (double cosine : {1., .7, .2}) {
                const std::string material = std::string(kind) + " " + widths;
                const Estimate e = seenAt(cosine, material);
                EXPECT_LE(e.mean.g, 1.001 + standardErrors * e.error.g) << material << " at cosine " << cosine;
                EXPECT_GE(e.mean.g, 0.99 - standardErrors * e.error.g) << material << " at cosine " << cosine;
                EXPECT_LE(e.error.g, 0.007) << "too few samples to tell";
            }
}

// Between equal indices there is no interface, however rough it is said to be (as in pbrt-v4): at the rim, a refracting one lost 4 of 10.
TEST(Furnace, EqualIndicesHaveNoInterface) {
    for (const char* compensation : {"false", "true"}) {
        View view;
        view.lookAt = "3.9191836 0 -1.8  0 0 -1  0 1 0";   // the cosine is .2
        view.samples = 16;
        const std::string text = fmt::format("LightSource \"infinite\" \"rgb L\" [1 1 1]\nMaterial \"dielectric\" \"float eta\" 1 "
                                             "\"float roughness\" .5 \"bool energycompensation\" {}\nShape \"sphere\"", compensation);
        expectRadiance(render(sceneText(view, text), surfaces()), 1);
    }
}

// Inside of glass the light of the sky is eta^2 times as bright.
TEST(Furnace, CompensatedGlassLosesNothingFromInside) {
    View view;
    view.lookAt = ".3 -.2 -.4  0 0 1  0 1 0";
    view.maxDepth = 200;
    const Estimate e = estimate(render(sceneText(view, R"(LightSource "infinite" "rgb L" [1 1 1] Material "dielectric" "float eta" 1.5
        "float roughness" 1 "bool remaproughness" false "bool energycompensation" true Shape "sphere")"), surfaces()).image);
    EXPECT_LE(e.mean.g / 2.25, 1.002 + standardErrors * e.error.g / 2.25);
    EXPECT_GE(e.mean.g / 2.25, 0.99 - standardErrors * e.error.g / 2.25);
}

// A roughness that varies reads the tables between their nodes.
TEST(Furnace, CompensatedSurfacesOfTexturedRoughnessLoseNothing) {
    for (const char* roughness : {".08", ".45", ".97"}) {
        const std::string texture = R"(Texture "r" "float" "constant" "float value" )" + std::string(roughness) + "\nMaterial ";
        for (const char* kind : {R"("conductor" "rgb reflectance" [1 1 1])", R"("dielectric" "float eta" 1.5)"}) {
            const Estimate e = estimate(underWhiteSky(texture + kind + R"( "texture roughness" "r" "bool remaproughness" false
                "bool energycompensation" true)", "Shape \"sphere\"", 200).image);
            EXPECT_NEAR(e.mean.g, 1, 0.004 + standardErrors * e.error.g) << kind << " " << roughness;
        }
    }
}

// Where the index varies with the wavelength, so do the tables.
TEST(Furnace, CompensatedGlassThatDispersesLosesNothing) {
    View view;
    view.samples = 1024;
    view.maxDepth = 200;
    const PackedScene scene = packScene(sceneText(view, R"(LightSource "infinite" "rgb L" [1 1 1] Material "dielectric"
        "spectrum eta" "glass-F11" "float roughness" 1 "bool energycompensation" true Shape "sphere")"), ColorMode::spectral);
    const Estimate e = estimate(render(scene).image);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(e.mean[c], 1, 0.006 + standardErrors * e.error[c]) << c;
}

// The walk between coat and base is cut off, and each crossing of a rough coat loses what its microfacets would pass on among
// themselves; nothing of it can gain light.
TEST(Furnace, WhiteUnderACoatNeverGains) {
    for (const char* roughness : {"0", ".1"}) {
        const Rendered r =
            underWhiteSky("Material \"coateddiffuse\" \"rgb reflectance\" [1 1 1] \"integer maxdepth\" 100 \"float roughness\" " +
                          std::string(roughness));
        const Estimate e = estimate(r.image);
        EXPECT_LE(e.mean.g, 1 + standardErrors * e.error.g) << roughness;
        EXPECT_GE(e.mean.g, std::atof(roughness) == 0 ? 0.9 : 0.6) << roughness;
        EXPECT_EQ(r.invalid.count, 0u);
    }
}

TEST(Furnace, MetalUnderACoatNeverGains) {
    for (const char* interface : {"0", ".1"}) {
        const Rendered r = underWhiteSky(
            "Material \"coatedconductor\" \"rgb reflectance\" [1 1 1] \"integer maxdepth\" 100 \"float conductor.roughness\" .05 "
            "\"float interface.roughness\" " +
            std::string(interface));
        const Estimate e = estimate(r.image);
        EXPECT_LE(e.mean.g, 1 + standardErrors * e.error.g) << interface;
        EXPECT_GE(e.mean.g, 0.5) << interface;
        EXPECT_EQ(r.invalid.count, 0u);
    }
}

// Hair without pigment scatters all that it gets, whatever its lobes: the ways through it add up to 1 (Chiang et al. 2016). Light that is
// scattered into the ball goes on inside of it.
TEST(Furnace, HairWithoutPigmentCannotBeSeen) {
    expectRadiance(underWhiteSky("Material \"hair\" \"rgb sigma_a\" [0 0 0]"), 1, 0.002);
    expectRadiance(underWhiteSky("Material \"hair\" \"rgb sigma_a\" [0 0 0] \"float beta_m\" .1 \"float beta_n\" .8 \"float alpha\" 4"), 1,
                   0.002);
}

// Nearly flat facets that reflect 0.6 of the light at every wavelength: all of that gets away, and the file's number is the result, but for
// the straight lines between its values (2 %).
TEST(Furnace, AMeasuredSurfaceReflectsWhatItsFileSays) {
    const std::filesystem::path file = std::filesystem::temp_directory_path() / ("eikonal-furnace-" + std::to_string(getpid()) + ".bsdf");
    MeasuredFile measured;
    measured.alpha = 0.15;
    measured.reflectance = [](double) { return 0.6; };
    measured.write(file.string());
    const Estimate e = estimate(underWhiteSky("Material \"measured\" \"string filename\" \"" + file.string() + "\"").image);
    std::filesystem::remove(file);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(e.mean[c], 0.6, 0.012 + standardErrors * e.error[c]) << c;
}

// What has come in through one leaves as rarely: after 100 bounces half a thousandth would still be inside.
TEST(Furnace, AMixOfWhiteMaterialsIsWhite) {
    expectRadiance(underWhiteSky(R"(MakeNamedMaterial "a" "string type" "diffuse" "rgb reflectance" [1 1 1]
        MakeNamedMaterial "b" "string type" "dielectric"
        MakeNamedMaterial "c" "string type" "mix" "string materials" ["a" "b"] "float amount" .3
        Material "mix" "string materials" ["c" "a"] "float amount" .5)", "Shape \"sphere\" \"float radius\" 1", 400), 1, 0.005);
}

// Inside of a shining wall (L_e = 1) that reflects rho = 1/2 each bounce adds half of the one before: with maxdepth n, L = 2 - 2^-n.
TEST(Furnace, EveryDepthAddsItsTerm) {
    for (int depth : {0, 1, 2, 3, 20}) {
        SCOPED_TRACE(depth);
        View view;
        view.lookAt = ".3 -.2 -.4  0 0 1  0 1 0";
        view.fov = 90;
        view.maxDepth = depth;
        expectRadiance(render(sceneText(view, R"(AreaLightSource "diffuse" "rgb L" [1 1 1] Material "diffuse" "rgb reflectance" [.5 .5 .5]
            ReverseOrientation Shape "sphere")"), surfaces()), 2 - std::ldexp(1., -depth), 0.002);
    }
}

// The same wall in the three channels, rho = 0.8, 0.5, 0.1: either rule of roulette follows the brightest channel and must keep the others
// right.
TEST(Furnace, RouletteKeepsEveryChannelRight) {
    View view;
    view.lookAt = ".3 -.2 -.4  0 0 1  0 1 0";
    view.fov = 90;
    view.maxDepth = 200;
    PackedScene scene =
        packScene(sceneText(view, R"(AreaLightSource "diffuse" "rgb L" [1 1 1] Material "diffuse" "rgb reflectance" [.8 .5 .1]
        ReverseOrientation Shape "sphere")"));
    using enum RouletteRule;
    for (const Roulette& rule :
         {Roulette{throughput, 1, 1}, {throughput, 1, 1000}, {throughput, 3, 1}, {root, 1, 0}, {root, 1, 4}, {root, 1.5, 2}}) {
        SCOPED_TRACE(testing::Message() << (rule.rule == root ? "root" : "throughput") << " x " << rule.scale << " from bounce "
                                        << rule.depth);
        setRoulette(scene.tables.frame[0], rule);
        expectRadiance(render(scene, surfaces()), {1 / .2, 1 / .5, 1 / .9}, 0.003);
    }
}

}  // namespace
}  // namespace eikonal
