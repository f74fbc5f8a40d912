// --fireflies reweight: what is taken from the image is a layer of its own.

#include "cli.h"

#include <gmock/gmock.h>

namespace eikonal {
namespace {

using testing::HasSubstr;

/// A diffuse room with a small lamp in a mirror's light: paths hit it by chance, and few do.
const std::string sparkling = R"(LightSource "infinite" "rgb L" [.05 .05 .05]
AttributeBegin AreaLightSource "diffuse" "rgb L" [9000 9000 9000] Translate 0 2 0 Shape "sphere" "float radius" .02 AttributeEnd
AttributeBegin Material "conductor" "float roughness" 0 Translate 0 1.2 0 Shape "sphere" "float radius" .5 AttributeEnd
Material "diffuse" "rgb reflectance" [.5 .5 .5]
Shape "trianglemesh" "point3 P" [-9 -1 -9  9 -1 -9  9 -1 9  -9 -1 9] "integer indices" [0 1 2 0 2 3]
)";

class FirefliesOption : public Cli {
protected:
    FirefliesOption() {
        write("sparks.pbrt", "LookAt 0 2 -5  0 0 0  0 1 0 Camera \"perspective\" \"float fov\" 50\n"
                             "Film \"rgb\" \"integer xresolution\" 32 \"integer yresolution\" 24\n"
                             "Sampler \"independent\" \"integer pixelsamples\" 16 Integrator \"volpath\"\nWorldBegin\n" + sparkling);
    }
    Outcome render(const std::string& fireflies, const std::string& file, std::vector<std::string> more = {}) const {
        std::vector<std::string> words{"render", "sparks.pbrt", "--color", "rgb", "--fireflies", fireflies, "-o", file};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    }
};

TEST_F(FirefliesOption, TakesLightIntoALayerAndSaysHowMuch) {
    ASSERT_EQ(render("keep", "kept.exr").status, 0);
    const Outcome run = render("reweight", "clean.exr", {"--json"});
    ASSERT_EQ(run.status, 0) << run.error;
    EXPECT_THAT(run.error, HasSubstr("% of the light was taken from the image, into the layer fireflies"));
    const auto kept = readImage(path("kept.exr")), clean = readImage(path("clean.exr"));
    ASSERT_EQ(clean.image.fireflies.size(), clean.image.pixelCount());
    EXPECT_TRUE(kept.image.fireflies.empty());
    double taken = 0, brightest = 0, brightestKept = 0;
    for (size_t i = 0; i < clean.image.pixelCount(); ++i) {
        const glm::vec3 all = kept.image.color[i], sum = clean.image.color[i] + clean.image.fireflies[i];
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], all[c], 1e-5 * all[c]);
        taken += clean.image.fireflies[i].g;
        brightest = std::max(brightest, double{clean.image.color[i].g});
        brightestKept = std::max(brightestKept, double{all.g});
    }
    EXPECT_GT(taken, 0);
    EXPECT_LT(brightest, brightestKept);
    ASSERT_TRUE(clean.metadata.firefliesShare);
    EXPECT_GT(*clean.metadata.firefliesShare, 0.001);
    EXPECT_THAT(run.out, HasSubstr("\"firefliesShare\":"));
    EXPECT_THAT(clean.metadata.biasedChoices, HasSubstr("fireflies re-weighted, into the layer fireflies (without it: --fireflies=keep)"));
    EXPECT_FALSE(kept.metadata.firefliesShare);
}

TEST_F(FirefliesOption, IsAnsweredWhereItIsMisspelt) {
    const Outcome run = render("remove", "a.exr");
    EXPECT_EQ(run.status, 2);
    EXPECT_THAT(run.error, HasSubstr("--fireflies"));
    EXPECT_THAT(run.error, HasSubstr("reweight"));
}

}  // namespace
}  // namespace eikonal
