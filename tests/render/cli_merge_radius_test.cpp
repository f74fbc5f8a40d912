// How far vertices of light paths merge follows what the camera sees, and is the same for every part of an image.

#include "cli.h"

#include <gmock/gmock.h>

namespace eikonal {
namespace {

using testing::HasSubstr;

class CliMergeRadius : public Cli {
protected:
    /// A glass ball on a floor of 100 x 100, in the light of a spot; the camera shows `fov` degrees of it.
    void writeScene(const char* name, const char* fov, const char* radius = "") {
        write(name, std::string("LookAt 0 3 -4  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" ") + fov +
                        "\nFilm \"rgb\" \"integer xresolution\" 48 \"integer yresolution\" 32\n"
                        "Sampler \"independent\" \"integer pixelsamples\" 4\nIntegrator \"vcm\" \"integer maxdepth\" 4 " + radius +
                        "\nWorldBegin\nLightSource \"spot\" \"rgb I\" [50 50 50] \"point3 from\" [2 4 1] \"float coneangle\" 40\n"
                        "Shape \"bilinearmesh\" \"point3 P\" [-50 0 -50  50 0 -50  -50 0 50  50 0 50]\n"
                        "AttributeBegin Translate 0 .6 0 Material \"dielectric\" Shape \"sphere\" \"float radius\" .5 AttributeEnd\n");
    }
    /// The first radius that a render names.
    double radiusOf(const char* scene, std::vector<std::string> options = {}) const {
        std::vector<std::string> arguments{"render", scene, "-o", "a.exr", "--color", "rgb"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Outcome run = this->run(arguments);
        EXPECT_EQ(run.status, 0) << run.error;
        const std::string choices = readImage(path("a.exr")).metadata.biasedChoices, before = "merged within ";
        const size_t at = choices.find(before);
        EXPECT_NE(at, std::string::npos) << choices;
        return at == std::string::npos ? 0 : std::stod(choices.substr(at + before.size()));
    }
};

TEST_F(CliMergeRadius, IsAboutThreePixelsWhereTheCameraSeesALittle) {
    writeScene("near.pbrt", "20");
    writeScene("far.pbrt", "60");
    /* 5 away, 20 degrees high: a pixel shows 0.055, and more in depth, where the floor is oblique. 2 R / sqrt(n) would be 3.6 */
    const double near = radiusOf("near.pbrt");
    EXPECT_GT(near, 2 * 0.055);
    EXPECT_LT(near, 6 * 0.055);
    EXPECT_GT(radiusOf("far.pbrt"), 2 * near);
    writeScene("given.pbrt", "20", "\"float radius\" .75");
    EXPECT_EQ(radiusOf("given.pbrt"), 0.75);
}

TEST_F(CliMergeRadius, IsTheSameForCropsSeedsAndAResumedRender) {
    writeScene("a.pbrt", "20");
    const double whole = radiusOf("a.pbrt");
    EXPECT_EQ(radiusOf("a.pbrt", {"--seed", "5"}), whole);
    EXPECT_EQ(radiusOf("a.pbrt", {"--spp", "9"}), whole);
    EXPECT_EQ(radiusOf("a.pbrt", {"--cropwindow", "0.1,0.3,0.5,0.7"}), whole);
    EXPECT_EQ(radiusOf("a.pbrt", {"--wave-paths", "512"}), whole);
    EXPECT_EQ(radiusOf("a.pbrt", {"--checkpoint", "a.film"}), whole);
    EXPECT_EQ(radiusOf("a.pbrt", {"--checkpoint", "a.film", "--resume"}), whole);   // nothing is left to render
}

TEST_F(CliMergeRadius, PartsMakeTheImageOfOneRun) {
    writeScene("a.pbrt", "20");
    ASSERT_EQ(run({"render", "a.pbrt", "-o", "whole.pfm", "--color", "rgb"}).status, 0);
    for (const char* part : {"1/2", "2/2"})
        ASSERT_EQ(run({"render", "a.pbrt", "-o", std::string("part") + part[0] + ".film", "--color", "rgb", "--tile", part}).status, 0);
    const Outcome merged = run({"merge", "part1.film", "part2.film", "-o", "merged.pfm"});
    ASSERT_EQ(merged.status, 0) << merged.error;
    EXPECT_EQ(read(path("merged.pfm")), read(path("whole.pfm")));
}

}  // namespace
}  // namespace eikonal
