// `--denoise` and `denoise`, with a library that stands in for Intel Open Image Denoise (tests/oidn): it halves images.
#include "cli.h"
#include "test_paths.h"

namespace eikonal {
namespace {

using testing::HasSubstr;

class DenoiseCli : public Cli {
protected:
    const Environment fake = {{"EIKONAL_OIDN", std::filesystem::path(EIKONAL_BINARY).parent_path() / "libfake_oidn.so"}};
    const Environment absent = {{"EIKONAL_OIDN", "/nowhere/libOpenImageDenoise.so.2"}};

    FilmFile file(const std::string& name) const { return readImage(path(name)); }

    static void expectHalf(const FilmImage& image) {
        ASSERT_EQ(image.noisy.size(), image.color.size());
        for (size_t i = 0; i < image.color.size(); ++i) ASSERT_EQ(image.color[i], image.noisy[i] / 2.f) << i;
    }
};

TEST_F(DenoiseCli, TheImageIsDenoisedAndTheNoisyOneKept) {
    ASSERT_EQ(run({"render", "tiny.pbrt", "-o", "noisy.exr", "--aov", "albedo,normal"}).status, 0);
    ASSERT_EQ(run({"render", "tiny.pbrt", "-o", "clean.exr", "--denoise"}, fake).status, 0);
    const FilmFile noisy = file("noisy.exr"), clean = file("clean.exr");
    expectHalf(clean.image);
    EXPECT_EQ(clean.image.noisy, noisy.image.color);
    EXPECT_EQ(clean.image.albedo, noisy.image.albedo);
    EXPECT_EQ(clean.image.normal, noisy.image.normal);
    EXPECT_EQ(clean.metadata.error, noisy.metadata.error);
    EXPECT_THAT(clean.metadata.biasedChoices, HasSubstr("denoising (without it: no --denoise; the layer noisy)"));
    EXPECT_THAT(noisy.metadata.biasedChoices, Not(HasSubstr("denoising")));
}

TEST_F(DenoiseCli, AnImageThatThereIsIsDenoisedFromItsNoisyLayer) {
    ASSERT_EQ(run({"render", "tiny.pbrt", "-o", "noisy.exr"}).status, 0);
    ASSERT_EQ(run({"denoise", "noisy.exr"}, fake).status, 0);
    expectHalf(image("noisy-denoised.exr"));
    EXPECT_TRUE(exists("noisy-denoised.png"));
    ASSERT_EQ(run({"denoise", "noisy-denoised.exr", "-o", "again.exr"}, fake).status, 0);
    EXPECT_EQ(image("again.exr").color, image("noisy-denoised.exr").color);
    EXPECT_EQ(file("again.exr").metadata.biasedChoices, file("noisy-denoised.exr").metadata.biasedChoices);
}

/// Nothing rendered is lost: the image is written as it is, with what `denoise` needs later.
TEST_F(DenoiseCli, WithoutTheLibraryTheNoisyImageIsWritten) {
    Environment failing = fake;
    failing["FAKE_OIDN_FAILS"] = "1";
    struct Case { Environment environment; const char* reason; };
    for (const auto& [environment, reason] :
         {Case{absent, "cannot denoise: Intel Open Image Denoise 2 is not there (/nowhere/libOpenImageDenoise.so.2: "},
          {failing, "cannot denoise the image: Intel Open Image Denoise: out of memory, says the test"}}) {
        const Outcome outcome = run({"render", "tiny.pbrt", "-o", "clean.exr", "--denoise"}, environment);
        EXPECT_EQ(outcome.status, 1);
        EXPECT_THAT(outcome.error, HasSubstr(reason));
        const FilmFile written = file("clean.exr");
        EXPECT_TRUE(written.image.noisy.empty());
        EXPECT_FALSE(written.image.albedo.empty());
        EXPECT_THAT(written.metadata.biasedChoices, Not(HasSubstr("denoising")));
    }
    EXPECT_EQ(run({"denoise", "clean.exr"}, absent).status, 1);
    EXPECT_EQ(run({"denoise"}).status, 2);
}

}  // namespace
}  // namespace eikonal
