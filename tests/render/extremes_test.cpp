// Extreme input: every pixel stays a number, and what was not one is counted, named and black.

#include "rendering.h"
#include "run_program.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace eikonal {
namespace {

View view() {
    View v;
    v.lookAt = "0 1 -4  0 0 0  0 1 0";
    v.fov = 50;
    v.samples = 64;
    v.maxDepth = 8;
    return v;
}
const std::string surroundings = R"(LightSource "infinite" "rgb L" [.3 .4 .5]
    LightSource "point" "rgb I" [5 5 5] "point3 from" [1 3 -3]
    AttributeBegin AreaLightSource "diffuse" "rgb L" [4 4 4] Translate 0 2 0 Rotate 90 1 0 0 Shape "disk" "float radius" .5 AttributeEnd
    AttributeBegin Material "diffuse" Shape "bilinearmesh" "point3 P" [-3 -1 -3  3 -1 -3  -3 -1 3  3 -1 3] AttributeEnd
)";
/// Some of these make the reader warn.
PackedScene warnedOf(const std::string& world) { return packScene(sceneText(view(), world), ColorMode::automatic, Warnings::allowed); }

void expectFiniteWith(const std::string& material) {
    expectFinite(render(warnedOf(surroundings + material + " Shape \"sphere\""), surfaces()), material);
}

TEST(Extremes, RoughnessOfEverySize) {
    for (const char* r : {"0", "1e-8", "1e-4", "1e-3", "1", "5"})
        for (const char* material : {"\"conductor\"", "\"dielectric\"", "\"coateddiffuse\""})
            expectFiniteWith(fmt::format("Material {} \"bool remaproughness\" false \"float roughness\" {}", material, r));
    expectFiniteWith("Material \"conductor\" \"bool remaproughness\" false \"float uroughness\" 1e-4 \"float vroughness\" 1");
}
TEST(Extremes, IndicesOfEverySize) {
    for (const char* eta : {"1", "1.0001", "100", ".01"})
        for (const char* material :
             {"\"dielectric\" \"float roughness\" 0", "\"dielectric\" \"float roughness\" .3", "\"thindielectric\"", "\"coateddiffuse\""})
            expectFiniteWith(fmt::format("Material {} \"float eta\" {}", material, eta));
}
TEST(Extremes, MetalsOfEveryKind) {
    for (const char* k :
         {"\"rgb eta\" [1 1 1] \"rgb k\" [0 0 0]", "\"rgb eta\" [.01 1 100] \"rgb k\" [0 100 1]", "\"rgb reflectance\" [0 .5 1]"})
        for (const char* roughness : {"0", ".3"})
            expectFiniteWith(fmt::format("Material \"conductor\" {} \"float roughness\" {}", k, roughness));
}
TEST(Extremes, ReflectancesOfNothingAndAll) {
    for (const char* m :
         {"\"diffuse\" \"rgb reflectance\" [0 0 0]", "\"diffusetransmission\" \"rgb reflectance\" [1 1 1] \"rgb transmittance\" [1 1 1]",
          "\"diffusetransmission\" \"rgb reflectance\" [0 0 0] \"rgb transmittance\" [0 0 0]"})
        expectFiniteWith(fmt::format("Material {}", m));
}

// 60 orders of magnitude of light; at each, the image is the one of radiance 1 times that, as far as floats go.
TEST(Extremes, RadianceOfEveryMagnitude) {
    const auto lit = [](const std::string& L) {
        return render(sceneText(view(), "LightSource \"infinite\" \"rgb L\" [" + L + " " + L + " " + L +
                                            "] Material \"conductor\" \"float roughness\" .3 Shape \"sphere\""),
                      surfaces());
    };
    const Estimate one = estimate(lit("1").image);
    for (const char* L : {"1e-30", "1e-20", "1e-10", "1e10", "1e20", "1e30"}) {
        const Rendered r = lit(L);
        expectFinite(r, L);
        EXPECT_NEAR(estimate(r.image).mean.g / std::atof(L), one.mean.g, 1e-4 * one.mean.g) << L;
    }
}

TEST(SlowExtremes, MediaOfEveryDensity) {
    for (const char* sigma : {"0", "1e-6", "1e3", "1e6"})
        for (const char* kind : {"\"homogeneous\"",
                                 "\"uniformgrid\" \"integer nx\" 2 \"integer ny\" 1 \"integer nz\" 1 \"float density\" [0 1] \"point3 p0\" "
                                 "[-1 -1 -1] \"point3 p1\" [1 1 1]"}) {
            const std::string what = fmt::format(
                "MakeNamedMedium \"m\" \"string type\" {1} \"rgb sigma_a\" [{0} {0} {0}] \"rgb sigma_s\" [{0} {0} 0] \"float g\" .9 \"rgb "
                "Le\" [1 1 1]",
                sigma, kind);
            expectFinite(
                render(warnedOf(surroundings + what + " Material \"interface\" MediumInterface \"m\" \"\" Shape \"sphere\""), media()),
                what);
        }
}

TEST(Extremes, ShapesThatAreHardlyThere) {
    const char* worlds[] = {
        /* triangles of no area, needles, one vertex far away */
        R"(Shape "trianglemesh" "point3 P" [0 0 0  0 0 0  0 0 0  -1 0 0  0 0 0  1 0 0  -1 0 0  1 1e-7 0  1 0 0  0 0 0  1e7 1 0  1e7 0 1]
            "integer indices" [0 1 2 3 4 5 6 7 8 9 10 11])",
        /* lamps of no area */
        R"(AreaLightSource "diffuse" "rgb L" [1 1 1] Shape "trianglemesh" "point3 P" [-1 0 0  0 0 0  1 0 0  -1 0 0  1 1e-7 0  1 0 0]
            "integer indices" [0 1 2 3 4 5])",
        R"(AreaLightSource "diffuse" "rgb L" [1 1 1] Shape "sphere" "float radius" 1e-6)",
        /* the same surface three times */
        R"(Material "dielectric" Shape "sphere" Shape "sphere" Material "diffuse" Shape "sphere")",
        R"(Material "diffuse" Shape "bilinearmesh" "point3 P" [-3 -1 -3  3 -1 -3  -3 -1 3  3 -1 3]
            Shape "bilinearmesh" "point3 P" [0 0 0  0 0 0  0 0 0  0 0 0])",
        /* flat and stretched */
        R"(Scale 1 1e-6 1 Shape "sphere")", R"(Scale 1e-3 1e3 1 Material "dielectric" Shape "sphere")"};
    for (const char* world : worlds) expectFinite(render(sceneText(view(), surroundings + world), surfaces()), world);
}

// The eye in the very surface of a floor, of a glass ball, of a lamp; a point light in a surface.
TEST(Extremes, EyesAndLightsInSurfaces) {
    View v = view();
    for (const char* eye : {"0 -1 -2  0 -1 0  0 1 0", "0 0 -1  0 0 0  0 1 0", "0 2 0  0 0 .1  0 0 1"}) {
        v.lookAt = eye;
        expectFinite(
            render(sceneText(v, surroundings + "LightSource \"point\" \"point3 from\" [0 -1 -1] Material \"dielectric\" Shape \"sphere\""),
                   surfaces()),
            eye);
    }
}

// Scene space is scaled by a power of two: lengths times 2^k are the same image, bit for bit. Radiance does not depend on size; intensities
// (per square of a length) and the coefficients of media (per length) are scaled along.
TEST(Extremes, ScenesOfEverySizeAreTheSame) {
    const auto scaled = [](double s, const RenderSetup& setup) {
        View v = view();
        v.lookAt = fmt::format("0 {:.17g} {:.17g}  0 0 0  0 1 0", s, -4 * s);
        return render(sceneText(v, fmt::format(R"(Scale {0:.17g} {0:.17g} {0:.17g}
            LightSource "point" "rgb I" [{1:.17g} {1:.17g} {1:.17g}] "point3 from" [1 3 -3]
            AttributeBegin AreaLightSource "diffuse" "rgb L" [4 4 4] Translate 0 2 0 Rotate 90 1 0 0 Shape "disk" "float radius" .5
                AttributeEnd
            AttributeBegin Material "diffuse" Shape "bilinearmesh" "point3 P" [-3 -1 -3  3 -1 -3  -3 -1 3  3 -1 3] AttributeEnd
            MakeNamedMedium "m" "string type" "homogeneous" "float scale" {2:.17g} "rgb sigma_a" [.5 .25 .125] "rgb sigma_s" [1 1 1]
            AttributeBegin MediumInterface "m" "" Material "interface" Shape "sphere" "float radius" .5 AttributeEnd
            Translate 1.5 0 0 Material "dielectric" Shape "sphere")",
                                               s, s * s, 1 / s)),
                      setup);
    };
    const Rendered one = scaled(1, media());
    for (int k : {-30, -3, 40}) {
        SCOPED_TRACE(k);
        expectSameBits(one.image, scaled(std::ldexp(1., k), media()).image, "scaled by a power of two");
    }
}

// Light of 3e38 reflected with more of it: the sum of two lights is infinite. 1e36 is finite, but a pixel's sum of it would not be. Such
// samples are counted, black, and reported with their pixel.
TEST(Invalid, SamplesAreCountedAndBlack) {
    for (const char* L : {"3e38", "1e36"}) {
        SCOPED_TRACE(L);
        const std::string sun =
            fmt::format("LightSource \"distant\" \"rgb L\" [{0} {0} {0}] \"point3 from\" [0 0 -1] \"point3 to\" [0 0 0]\n", L);
        const Rendered r = render(
            sceneText(view(), sun + sun + sun + sun + "Material \"diffuse\" \"rgb reflectance\" [1 1 1] Shape \"sphere\""), surfaces());
        EXPECT_GT(r.invalid.count, 0u);
        EXPECT_GE(r.invalid.x, 0);
        for (const glm::vec3& c : r.image.color) EXPECT_TRUE(c.r >= 0 && std::isfinite(c.r)) << c.r;
    }
}

class InvalidCli : public ProgramTest {};
TEST_F(InvalidCli, SamplesAreReportedWithTheirPixel) {
    const std::string sun = "LightSource \"distant\" \"rgb L\" [3e38 3e38 3e38] \"point3 from\" [0 0 -1] \"point3 to\" [0 0 0]\n";
    write("bright.pbrt", tinyScene("", sun + sun + sun + sun));
    const Outcome run = this->run({"render", "bright.pbrt", "-o", "bright.exr"});
    EXPECT_EQ(run.status, 0) << run.error;
    EXPECT_THAT(run.error,
                testing::ContainsRegex(
                    "samples were not finite or brighter than 1e.31, and count as black; the first is in pixel \\([0-9]+, [0-9]+\\)"));
}

}  // namespace
}  // namespace eikonal
