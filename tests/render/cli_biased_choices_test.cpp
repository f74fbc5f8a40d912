// Images say which choices make them converge to something other than the scene's light transport.

#include "cli.h"

#include <gmock/gmock.h>

namespace eikonal {
namespace {

class BiasedChoices : public Cli {
protected:
    /// What an image says that is rendered with more options.
    std::string of(std::vector<std::string> options, const std::string& scene = "tiny.pbrt") const {
        std::vector<std::string> arguments{"render", scene, "-o", "a.exr", "--spp", "1"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Outcome run = this->run(arguments);
        EXPECT_EQ(run.status, 0) << run.error;
        return readImage(path("a.exr")).metadata.biasedChoices;
    }
};

TEST_F(BiasedChoices, AreNamedWithTheOptionsThatAvoidThem) {
    EXPECT_EQ(of({"--color", "spectral"}), "");
    EXPECT_EQ(of({"--color", "rgb"}), "RGB colour (without it: --color=spectral)");
    EXPECT_EQ(of({"--color", "spectral", "--max-component-value", "2.5"}), "samples clamped at 2.5 (without it: --max-component-value=0)");
    EXPECT_EQ(of({"--color", "spectral", "--regularize", "on"}), "regularised microfacets (without it: --regularize=off)");
    EXPECT_EQ(of({"--color", "spectral", "--integrator", "direct"}), "direct light only (without it: --integrator=volpath)");
    EXPECT_THAT(
        of({"--color", "spectral", "--integrator", "sppm"}),
        testing::ContainsRegex("light paths merged within [0-9.e-]+, and [0-9.e-]+ by sample 1: .*\\(without it: --integrator=bdpt\\)"));
    EXPECT_EQ(of({"--color", "spectral", "--integrator", "whitted"}), "a tree of rays instead of paths (without it: --integrator=volpath)");
}

TEST_F(BiasedChoices, OfASceneFileCountToo) {
    write("body.pbrt", tinyScene("Film \"rgb\" \"integer xresolution\" 8 \"integer yresolution\" 8 \"float maxcomponentvalue\" 3\n",
                                 "Material \"subsurface\" \"float eta\" 1.33\nShape \"sphere\" \"float radius\" 0.3\n"));
    const std::string choices = of({"--color", "spectral"}, "body.pbrt");
    EXPECT_THAT(choices, testing::HasSubstr("samples clamped at 3"));
    EXPECT_THAT(choices, testing::HasSubstr("subsurface scattering by diffusion (without it: --subsurface=randomwalk)"));
    EXPECT_EQ(of({"--color", "spectral", "--subsurface", "randomwalk", "--max-component-value", "0"}, "body.pbrt"), "");
}

TEST_F(BiasedChoices, SurfacesForcedToBeDiffuseAreOne) {
    write("diffuse.pbrt", tinyScene("Option \"forcediffuse\" true\n", ""));
    EXPECT_EQ(of({"--color", "spectral"}, "diffuse.pbrt"), "every surface diffuse (without it: no Option \"forcediffuse\")");
}

TEST_F(BiasedChoices, ArePrintedWithTheStatistics) {
    const Outcome run = this->run({"render", "tiny.pbrt", "-o", "a.exr", "--stats", "--json", "--color", "rgb"});
    EXPECT_THAT(run.out, testing::HasSubstr("Biased choices:\n  RGB colour"));
    EXPECT_THAT(run.out, testing::HasSubstr("\"biasedChoices\":[{\"what\":\"RGB colour\",\"remedy\":\"--color=spectral\"}]"));
}

}  // namespace
}  // namespace eikonal
