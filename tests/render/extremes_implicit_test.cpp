// Implicit surfaces at their extremes, in whole images.

#include "rendering.h"
#include "run_program.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace eikonal {
namespace {

/// All of a shell of radius 1 under a sky of radiance 1.
Rendered shellUnderWhiteSky(const char* h, const std::string& material) {
    View view;
    view.fov = 35;
    view.width = view.height = 32;
    view.samples = 64;
    view.maxDepth = 100;
    return render(sceneText(view, fmt::format("LightSource \"infinite\" \"rgb L\" [1 1 1] Material {} Shape \"implicit\" \"string F\" "
                                              "\"abs(x^2 + y^2 + z^2 - 1) - {}\" \"point3 bounds\" [-1.1 -1.1 -1.1  1.1 1.1 1.1]",
                                              material, h)),
                  surfaces());
}

// White matter under a white sky is white in every pixel. A path that got between the two sides would be lost in there.
TEST(ExtremeImplicitImages, WhiteShellsOfEveryThicknessAreWhite) {
    for (const char* h : {"1e-3", "1e-4", "1e-5", "1e-6"}) {
        SCOPED_TRACE(h);
        expectRadiance(shellUnderWhiteSky(h, "\"diffuse\" \"rgb reflectance\" [1 1 1]"), 1, 0.002);
    }
}

// Glass loses nothing as long as single precision distinguishes its two sides.
TEST(ExtremeImplicitImages, ThinGlassShellsCannotBeSeen) {
    for (const char* h : {"1e-3", "1e-4", "1e-5", "4e-6"}) {
        SCOPED_TRACE(h);
        expectRadiance(shellUnderWhiteSky(h, "\"dielectric\""), 1, 0.002);
    }
}

class ExtremeImplicitCli : public ProgramTest {
protected:
    /// What the program reports about a scene with a surface F = 0.
    std::string reportOf(const std::string& F, const std::string& bounds = "-1 -1 -1  1 1 1", const std::string& material = "") {
        write("surface.pbrt", tinyScene("", "LightSource \"infinite\" " + material + " "
                                                "Shape \"implicit\" \"string F\" \"" + F + "\" \"point3 bounds\" [" +
                                                bounds + "]"));
        const Outcome run = this->run({"render", "surface.pbrt", "-o", "surface.exr"});
        EXPECT_EQ(run.status, 0) << run.error;
        return run.error;
    }
};

// Waves of a length of 1e-4 fill the box; three of them multiplied need more splits than a ray has.
TEST_F(ExtremeImplicitCli, RaysThatRunOutOfSplitsAreReported) {
    EXPECT_THAT(reportOf("sin(9e3*x)*sin(9e3*y)*sin(9e3*z) - .999"),
                testing::ContainsRegex("[0-9]+ rays at an implicit surface ran out of splits"));
}

// A function that single precision can evaluate nowhere, and a power so steep that it overflows right outside of the surface, do not use
// them up.
TEST_F(ExtremeImplicitCli, UndefinedAndSteepFunctionsNeedFewSplits) {
    for (const char* F : {"1/(x - x)", "x^10000 + y^2 - 1", "x^2 + y^2 + z^2 - .5"})
        EXPECT_THAT(reportOf(F), testing::Not(testing::HasSubstr("ran out of splits"))) << F;
}

// Between sides that are only a few resolutions apart, the other one may be missed. What is opaque does not care, nor does a sharp rim.
TEST_F(ExtremeImplicitCli, TransparentShellsThatAreTooThinAreReported) {
    const std::string thin = "abs(x^2 + y^2 + z^2 - .25) - 5e-7", tooThin = "its other side was nearer than single precision resolves";
    for (const char* glass : {"Material \"dielectric\"", "Material \"diffusetransmission\""})
        EXPECT_THAT(reportOf(thin, "-1 -1 -1  1 1 1", glass), testing::HasSubstr(tooThin)) << glass;
    EXPECT_THAT(reportOf(thin), testing::Not(testing::HasSubstr(tooThin)));
    for (const char* thick : {"abs(x^2 + y^2 + z^2 - .25) - 1e-5", "max(x^2 + y^2 + (z - .3)^2 - .25, x^2 + y^2 + (z + .3)^2 - .25)"})
        EXPECT_THAT(reportOf(thick, "-1 -1 -1  1 1 1", "Material \"dielectric\""), testing::Not(testing::HasSubstr(tooThin))) << thick;
}

// Floats at 1000 are 6e-5 apart, so a slab of 1e-6 does not exist there.
TEST_F(ExtremeImplicitCli, ABoxFarFromTheOriginIsReported) {
    EXPECT_THAT(reportOf("abs(x - 1000) - 1e-6", "999 -1 -1  1001 1 1"),
                testing::HasSubstr("the box is 500 times as far from the origin as it is large: details smaller than 0.0005 are lost"));
    EXPECT_THAT(reportOf("abs(x) - 1e-6"), testing::Not(testing::HasSubstr("far from the origin")));
}

}  // namespace
}  // namespace eikonal
