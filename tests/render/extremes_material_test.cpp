// Materials at their extremes: coats of no thickness, indices close to 1, albedo 1 over a thousand bounces, hair from smooth to rough.

#include "rendering.h"

#include <fmt/format.h>

#include <algorithm>

namespace eikonal {
namespace {

/// A ball under a sky of radiance 1, seen in its middle and a little aside (so that angles are not special).
Rendered underWhiteSky(const std::string& material, int maxDepth = 100, Warnings warnings = Warnings::refused) {
    View view;
    view.lookAt = "0 0 -4  .4 .3 0  0 1 0";
    view.maxDepth = maxDepth;
    const std::string text = sceneText(view, "LightSource \"infinite\" \"rgb L\" [1 1 1]\n" + material + "\nShape \"sphere\"");
    return render(packScene(text, ColorMode::automatic, warnings), surfaces());
}

// A medium of thickness 0 scatters nothing, whatever its albedo; one of 1e-30 scatters 1e-30 of the light. So both are the coat without.
TEST(ExtremeMaterials, ACoatOfNoThicknessIsTheCoatWithoutAMedium) {
    const char* materials[] = {"Material \"coateddiffuse\" \"rgb reflectance\" [1 1 1] \"integer maxdepth\" 100 \"float roughness\" {0} "
                               "\"float thickness\" {1} \"rgb albedo\" [{2} {2} {2}]",
                               "Material \"coatedconductor\" \"rgb reflectance\" [.9 .9 .9] \"integer maxdepth\" 100 "
                               "\"float interface.roughness\" {0} \"float thickness\" {1} \"rgb albedo\" [{2} {2} {2}]"};
    for (const char* material : materials)
        for (const char* roughness : {"0", ".2"}) {
            const auto coat = [&](const char* thickness, const char* albedo) {
                return underWhiteSky(fmt::format(fmt::runtime(material), roughness, thickness, albedo));
            };
            const Rendered clear = coat("0", "0");
            for (const char* thickness : {"0", "1e-30", "1e-8"}) {
                SCOPED_TRACE(fmt::format("roughness {}, thickness {}", roughness, thickness));
                expectEqualMeans(coat(thickness, ".9"), clear);
            }
        }
}

// The walks of a coat are random, and each path takes its own: where all see the same two directions, many paths are as good as many walks.
TEST(ExtremeMaterials, ACoatConvergesWhereAllPathsSeeTheSameDirections) {
    const auto lit = [](int walks, int samples) {
        View view;
        view.lookAt = "0 0 4  0 0 0  0 1 0";
        view.samples = samples;
        view.more = "Camera \"orthographic\"";
        const std::string world = "LightSource \"distant\" \"rgb L\" [3 3 3] \"point3 from\" [.002 .5 1]\n"
                                  "Material \"coateddiffuse\" \"rgb reflectance\" [.8 .8 .8] \"float roughness\" .2 "
                                  "\"integer nsamples\" {}\nShape \"disk\" \"float radius\" 9\n";
        return render(sceneText(view, fmt::format(fmt::runtime(world), walks)), surfaces());
    };
    expectEqualMeans(lit(1, 2048), lit(128, 16));
}

// Straight on, a metal of index 1 + x + i y reflects (x^2 + y^2) / ((2 + x)^2 + y^2); 0.02 degrees aside, the same to 1e-7.
TEST(ExtremeMaterials, MetalsOfAnIndexCloseToOne) {
    View view;
    view.samples = 16;
    for (const auto& [x, y] : {std::pair{1e-4, 0.}, {0., 1e-4}, {1e-6, 1e-6}, {0.01, 1e-4}}) {
        /* The device's eta is a float */
        const double eta = static_cast<float>(1 + x), k = static_cast<float>(y), below = (eta - 1) * (eta - 1) + k * k,
                     expected = below / ((eta + 1) * (eta + 1) + k * k);
        const Rendered r = render(
            sceneText(view, fmt::format("LightSource \"infinite\" \"rgb L\" [1 1 1] Material \"conductor\" \"float roughness\" 0 "
                                        "\"rgb eta\" [{0:.17g} {0:.17g} {0:.17g}] \"rgb k\" [{1:.17g} {1:.17g} {1:.17g}] Shape \"sphere\"",
                                        1 + x, y)),
            surfaces());
        EXPECT_NEAR(estimate(r.image).mean.g, expected, 1e-5 * expected) << "eta 1 + " << x << ", k " << y;
    }
}

// Inside of a sphere that emits e and reflects all, every bounce adds e: maxdepth n gives (n + 1) e. After b bounces a path's throughput is
// off by at most b roundings of 2^-24, by 3e-5 in the mean over 1000 bounces.
TEST(ExtremeMaterials, AlbedoOneHoldsForAThousandBounces) {
    View view;
    view.lookAt = ".3 -.2 -.4  0 0 1  0 1 0";
    view.fov = 90;
    view.samples = 4;
    view.maxDepth = 1000;
    const Rendered r = render(sceneText(view, R"(AreaLightSource "diffuse" "rgb L" [.001 .001 .001]
        Material "diffuse" "rgb reflectance" [1 1 1] ReverseOrientation Shape "sphere")"), surfaces());
    EXPECT_NEAR(estimate(r.image).mean.g, 1.001, 3e-5);
}

// Hair without pigment scatters all that it gets, whatever its roughness.
TEST(ExtremeMaterials, HairOfEveryRoughnessLosesNothing) {
    for (const char* beta : {"1e-6", "1e-4", ".01", ".1", ".5", "1"}) {
        SCOPED_TRACE(beta);
        const char* hair = "Material \"hair\" \"rgb sigma_a\" [0 0 0] \"float beta_m\" {0} \"float beta_n\" {0}";
        expectRadiance(underWhiteSky(fmt::format(fmt::runtime(hair), beta)), 1, 0.002);
    }
}

// A reflectance above 1 is 1, whether a spectrum, a factor or a colour of a wider gamut made it so: nothing outshines the sky.
TEST(ExtremeMaterials, NothingReflectsMoreThanItReceives) {
    for (const char* white :
         {"Material \"diffuse\" \"spectrum reflectance\" [300 2 900 2]",
          "Material \"diffusetransmission\" \"rgb reflectance\" [.5 .5 .5] \"rgb transmittance\" [0 0 0] \"float scale\" 3",
          "Material \"coateddiffuse\" \"spectrum reflectance\" [300 2 900 2] \"float thickness\" 0 \"integer maxdepth\" 100",
          "Texture \"two\" \"spectrum\" \"constant\" \"spectrum value\" [300 2 900 2]\n"
          "Material \"diffuse\" \"texture reflectance\" \"two\""}) {
        SCOPED_TRACE(white);
        expectRadiance(underWhiteSky(white, 100, Warnings::allowed), 1, 0.005);
    }
    View view;
    const std::string green =
        "LightSource \"infinite\" \"rgb L\" [1 1 1] ColorSpace \"rec2020\" Material \"diffuse\" "
        "\"rgb reflectance\" [0 1 0] Shape \"sphere\"";
    const glm::dvec3 seen = estimate(render(packScene(sceneText(view, green), ColorMode::rgb), surfaces()).image).mean;
    EXPECT_LE(std::max({seen.r, seen.g, seen.b}), 1 + 1e-5);
    EXPECT_GT(seen.g, 0.99);
}

// Texture values that no constant may have count as the nearest one that it may.
TEST(ExtremeMaterials, NegativeTexturesCountAsZero) {
    const std::string minus =
        "Texture \"minus\" \"float\" \"constant\" \"float value\" -1 Texture \"minusrgb\" \"spectrum\" \"scale\" "
        "\"rgb tex\" [.5 .5 .5] \"float scale\" -2\n";
    for (const char* hair : {"\"texture eumelanin\" \"minus\"", "\"texture sigma_a\" \"minusrgb\""}) {
        SCOPED_TRACE(hair);
        expectRadiance(underWhiteSky(fmt::format("{}Material \"hair\" {}", minus, hair)), 1, 0.002);
    }
    const std::string coat = "Material \"coateddiffuse\" \"rgb reflectance\" [1 1 1] \"integer maxdepth\" 100 ";
    expectRadiance(underWhiteSky(minus + coat + "\"texture thickness\" \"minus\""), 1, 0.005);
}

// Where texture coordinates overflow, marble has some colour of a vein.
TEST(ExtremeMaterials, MarbleHasAColorWhereItsCoordinatesOverflow) {
    for (const char* scale : {"1e30", "1e38"}) {
        const std::string marble = fmt::format(
            "Scale {0} {0} {0} Texture \"m\" \"spectrum\" \"marble\" \"float variation\" 1e38 "
            "\"float scale\" 1e38 Scale {1} {1} {1} Material \"diffuse\" \"texture reflectance\" \"m\"",
            "1e-30", "1e30");
        expectFinite(underWhiteSky(marble), scale);
    }
}

}  // namespace
}  // namespace eikonal
