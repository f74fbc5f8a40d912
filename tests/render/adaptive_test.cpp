// Adaptive sampling: samples go where they are needed, the error is what was asked for, and the mean stays what it is.

#include "cli.h"
#include "rendering.h"

#include "render/adaptive.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace eikonal {
namespace {

using testing::HasSubstr;

/// On one side a white sky, of which every sample is the same. On the other a wall under it, so large that it sees nothing else, of a
/// material that is by chance one of two, of reflectances 0.1 and 0.9.
constexpr int width = 128, height = 32;
constexpr double sky = 1, wall = 0.5;
PackedScene halves(int most, int seed = 0) {
    View view;
    view.fov = 20;
    view.width = width; view.height = height;
    view.samples = most;
    view.more = fmt::format("Option \"seed\" {}\n", seed);
    return packScene(sceneText(view, "LightSource \"infinite\" \"rgb L\" [1 1 1]\n"
                                     "MakeNamedMaterial \"dark\" \"string type\" \"diffuse\" \"rgb reflectance\" [.1 .1 .1]\n"
                                     "MakeNamedMaterial \"light\" \"string type\" \"diffuse\" \"rgb reflectance\" [.9 .9 .9]\n"
                                     "Material \"mix\" \"string materials\" [\"dark\" \"light\"] \"float amount\" .5\n"
                                     "Shape \"bilinearmesh\" \"point3 P\" [0 -9 0  9 -9 0  0 9 0  9 9 0]"));
}

RenderSetup comingDownTo(double error) {
    RenderSetup setup = surfaces();
    setup.targetError = error;
    return setup;
}

/// Whether pixels in this column see the wall: which half that is depends on the camera's handedness.
bool seesTheWall(const FilmImage& image, int x) { return image.variance[image.index(x, height / 2)] > 1e-9f; }

// Half of the image's average deviation is suspected of the sky, which is a fourth of the wall's; rounding both to powers of two leaves a
// factor of two.
TEST(AdaptiveSampling, SamplesGoWhereTheNoiseIs) {
    const FilmImage image = render(halves(1024), comingDownTo(0.03)).image;
    ASSERT_NE(seesTheWall(image, 1), seesTheWall(image, width - 2));
    double flat = 0, noisy = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            /* But for the flat blocks beside the wall, which are under suspicion */
            if (x >= width / 2 - 16 && x < width / 2 + 16) continue;
            const float count = image.sampleCount[image.index(x, y)];
            if (seesTheWall(image, x)) noisy += count;
            else flat += count;
        }
    EXPECT_GT(noisy, 1.9 * flat);
}

// Over 2048 noisy pixels the mean of squared errors is known to about 4 %, and with doubled samples it may be down to half of what was
// asked for.
TEST(AdaptiveSampling, TheErrorIsWhatWasAskedFor) {
    for (double target : {0.06, 0.03}) {
        const Rendered rendered = render(halves(4096), comingDownTo(target));
        double squares = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const double truth = seesTheWall(rendered.image, x) ? wall : sky,
                             off = rendered.image.color[rendered.image.index(x, y)].g - truth;
                squares += off * off / (truth * truth + 0.01);
            }
        const double error = std::sqrt(squares / (width * height));
        EXPECT_LT(error, 1.15 * target);
        EXPECT_GT(error, 0.6 * target);
        EXPECT_NEAR(error / rendered.result.error.value(), 1, 0.15);
        EXPECT_LE(rendered.result.error.value(), target);
    }
}

// The variance is estimated from the samples that it decides about, so the mean could be off. Over the seeds, that of the wall is known to
// 0.1 %, and is the truth.
TEST(AdaptiveSampling, TheMeanStaysTheMean) {
    constexpr int seeds = 8;
    double sum = 0, squares = 0;
    for (int seed = 0; seed < seeds; ++seed) {
        const FilmImage image = render(halves(256, seed), comingDownTo(0.05)).image;
        double mean = 0;
        int pixels = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                if (seesTheWall(image, x)) { mean += image.color[image.index(x, y)].g; ++pixels; }
        mean /= pixels;
        sum += mean;
        squares += mean * mean;
    }
    const double mean = sum / seeds, error = std::sqrt(std::max(squares / seeds - mean * mean, 0.0) / (seeds - 1));
    EXPECT_LT(error, 1e-3 * wall) << "too few samples to tell";
    EXPECT_NEAR(mean, wall, standardErrors * error);
}

TEST(AdaptiveSampling, OutOfReachEveryPixelGetsTheMost) {
    const Rendered uniform = render(halves(48), surfaces()), adaptive = render(halves(48), comingDownTo(1e-6));
    expectSameBits(uniform.image, adaptive.image, "as many as allowed");
    EXPECT_GT(adaptive.result.error.value(), 1e-6);
    const Rendered few = render(halves(4), comingDownTo(0.01));
    for (float count : few.image.sampleCount) ASSERT_EQ(count, 4);
}

class AdaptiveCli : public Cli {};

TEST_F(AdaptiveCli, TheSamplesAreReported) {
    write("noisy.pbrt",
          tinyScene(
              "",
              "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [20 20 20] \"bool twosided\" true Shape \"bilinearmesh\" \"point3 P\" "
              "[-2 2 -3  2 2 -3  -2 2 -1  2 2 -1] AttributeEnd"));
    const Outcome run = this->run({"render", "noisy.pbrt", "--resolution", "48x32", "--spp", "256", "--target-error", "2%", "--aov",
                                   "sampleCount", "--stats", "-o", "a.exr"});
    ASSERT_EQ(run.status, 0) << run.error;
    const FilmFile file = readImage(path("a.exr"));
    const std::vector<float>& counts = file.image.sampleCount;
    const auto [fewest, most] = std::ranges::minmax(counts);
    ASSERT_LT(fewest, most);
    double mean = 0;
    for (float count : counts) mean += count / static_cast<double>(counts.size());
    EXPECT_THAT(run.out, HasSubstr(fmt::format("{} fewest, {:.1f} mean, {} most", fewest, mean, most)));
    EXPECT_EQ(file.metadata.samples, static_cast<int>(fewest));
    EXPECT_NEAR(file.metadata.meanSamples.value(), mean, 1e-3);
    EXPECT_NEAR(file.metadata.targetError.value(), 0.02, 1e-6);

    EXPECT_NEAR(file.metadata.error.value(), 0.02, 0.005);
    EXPECT_THAT(run.error, HasSubstr(fmt::format("error about {:.3g} % (relmse-root)", 100 * file.metadata.error.value())));
    EXPECT_THAT(run.out, HasSubstr("Error, estimated:\n  error about"));

    const Outcome unreached = this->run({"render", "noisy.pbrt", "--spp", "32", "--target-error", "1e-5", "-o", "b.exr"});
    EXPECT_EQ(unreached.status, 0);
    EXPECT_THAT(unreached.error, HasSubstr("a pixel gets at most 32 samples"));
    const Outcome late =
        this->run({"render", "noisy.pbrt", "--spp", "100000000", "--target-error", "1e-5", "--time-limit", "0.5", "-o", "c.exr"});
    EXPECT_EQ(late.status, 4);
    EXPECT_THAT(late.error, HasSubstr("ended by --time-limit"));
}

// Light four times as bright has four times the error, and the same relative to its mean: a power of two, so but for what is rounded in the
// decay's fit to the last bit.
TEST_F(AdaptiveCli, AScaledErrorDoesNotDependOnBrightness) {
    const auto errorAt = [&](const char* exposure, const char* metric) {
        write("lit.pbrt", tinyScene(exposure, "LightSource \"point\" \"rgb I\" [3 3 3] \"point3 from\" [2 3 -4]"));
        EXPECT_EQ(run({"render", "lit.pbrt", "--resolution", "32x32", "--spp", "16", "--error-metric", metric, "-o", "a.exr"}).status, 0);
        return readImage(path("a.exr")).metadata.error.value();
    };
    const char *usual = "", *fast = "Film \"rgb\" \"float iso\" 400";
    EXPECT_GT(errorAt(usual, "relmse-scaled"), 0);
    EXPECT_NEAR(errorAt(fast, "relmse-scaled") / errorAt(usual, "relmse-scaled"), 1, 1e-6);
    EXPECT_GT(std::abs(errorAt(fast, "relmse-root") / errorAt(usual, "relmse-root") - 1), 0.01);
}

}  // namespace
}  // namespace eikonal
