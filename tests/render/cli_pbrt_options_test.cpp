// pbrt-v4's options and film parameters that decide what is written, or where samples are.

#include "cli.h"

#include <gmock/gmock.h>

#include <set>
#include <sstream>

namespace eikonal {
namespace {

using testing::HasSubstr;

double meanSquare(const FilmImage& a, const FilmImage& b) {
    double sum = 0;
    for (size_t i = 0; i < a.pixelCount(); ++i) {
        const glm::dvec3 difference = glm::dvec3(a.color[i]) - glm::dvec3(b.color[i]);
        sum += glm::dot(difference, difference) / (3. * static_cast<double>(a.pixelCount()));
    }
    return sum;
}

// Films of 1, 2, 4 ... samples: each time that every pixel has more. The last line is about the image that is written.
TEST_F(Cli, LogsTheErrorAgainstAReference) {
    ASSERT_EQ(run({"render", "tiny.pbrt", "-o", "reference.exr", "--spp", "1024", "--seed", "1"}).status, 0);
    write("logged.pbrt", tinyScene("Option \"msereferenceimage\" \"reference.exr\" Option \"msereferenceout\" \"mse.txt\""));
    const Outcome logged = run({"render", "logged.pbrt", "-o", "a.exr", "--spp", "64", "--strict"});
    ASSERT_EQ(logged.status, 0) << logged.error;
    std::istringstream log(read(path("mse.txt")));
    std::vector<std::pair<unsigned, double>> lines;
    for (std::pair<unsigned, double> line; log >> line.first >> line.second;) lines.push_back(line);
    ASSERT_FALSE(lines.empty());
    for (size_t i = 1; i < lines.size(); ++i) EXPECT_GT(lines[i].first, lines[i - 1].first);
    EXPECT_EQ(lines.back().first, 64u);
    const double expected = meanSquare(image("a.exr"), image("reference.exr"));
    EXPECT_NEAR(lines.back().second, expected, 1e-5 * expected);
}

// Options of a method that is not at work do not pass in silence.
TEST_F(Cli, SaysWhichOptionsHaveNoEffect) {
    const auto reported = [&](std::vector<std::string> options) {
        options.insert(options.begin(), {"render", "tiny.pbrt", "-o", "a.exr", "--spp", "1"});
        return run(options).error;
    };
    EXPECT_THAT(reported({"--threshold", ".1"}), HasSubstr("--threshold has no effect here: it is for integrator \"whitted\""));
    EXPECT_THAT(reported({"--bundle", "8"}), HasSubstr("--bundle has no effect here"));
    EXPECT_THAT(reported({"--bundle", "8", "--integrator", "whitted"}), testing::Not(HasSubstr("no effect")));
    EXPECT_THAT(reported({"--subsurface", "diffusion"}), HasSubstr("--subsurface has no effect here: the scene has no material"));
    EXPECT_THAT(reported({"--quality", "reference"}), testing::Not(HasSubstr("no effect"))) << "a preset is for all scenes";
    for (const char* option : {"--light-sampler=power", "--environment-guide=never"}) {
        EXPECT_THAT(reported({option, "--integrator", "ambientocclusion"}),
                    HasSubstr("has no effect here: integrator \"ambientocclusion\" does not sample lights"));
        EXPECT_THAT(reported({option, "--integrator", "randomwalk"}), HasSubstr("has no effect here"));
        EXPECT_THAT(reported({option, "--integrator", "path"}), testing::Not(HasSubstr("no effect")));
    }
    EXPECT_THAT(reported({"--guiding", "on"}), HasSubstr("too little to learn from so few paths"));
}

TEST_F(Cli, SaysWhatIsWrongWithAReference) {
    ASSERT_EQ(run({"render", "tiny.pbrt", "-o", "other.exr", "--resolution", "8x8"}).status, 0);
    write("logged.pbrt", tinyScene("Option \"msereferenceimage\" \"other.exr\" Option \"msereferenceout\" \"mse.txt\""));
    const Outcome other = run({"render", "logged.pbrt", "-o", "a.exr"});
    EXPECT_EQ(other.status, 1);
    EXPECT_THAT(other.error, HasSubstr("8 x 8"));
    write("nowhere.pbrt", tinyScene("Option \"msereferenceimage\" \"other.exr\" Option \"msereferenceout\" \"none/mse.txt\""));
    EXPECT_THAT(run({"render", "nowhere.pbrt", "-o", "a.exr"}).error, HasSubstr("cannot write \"none/mse.txt\": it cannot be opened"));
}

// A square that emits 1 and nothing else: a pixel whose centre sees it is 1, any other 0. With jitter, pixels at the edges are in between.
TEST_F(Cli, WithoutPixelJitterSamplesAreAtTheCentre) {
    const auto values = [&](const char* option) {
        write("square.pbrt",
              std::string("LookAt .03 .05 -4 .03 .05 0 0 1 0 Camera \"perspective\" \"float fov\" 40\n") + option +
                  "\nFilm \"rgb\" \"integer xresolution\" 16 \"integer yresolution\" 12\nPixelFilter \"gaussian\"\nWorldBegin\n"
                  "AreaLightSource \"diffuse\" \"rgb L\" [1 1 1] \"bool twosided\" true\nShape \"trianglemesh\" \"point3 P\" "
                  "[-1 -1 0 1 -1 0 1 1 0 -1 1 0] \"integer indices\" [0 1 2 0 2 3]\n");
        const Outcome outcome = run({"render", "square.pbrt", "-o", "a.exr", "--spp", "16", "--max-depth", "0"});
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        std::set<float> found;
        for (const glm::vec3& c : image("a.exr").color) found.insert(std::round(c.g * 1e4f) / 1e4f);
        return found;
    };
    EXPECT_EQ(values("Option \"disablepixeljitter\" true"), (std::set<float>{0, 1}));
    EXPECT_GT(values("").size(), 2u);
}

TEST_F(Cli, WritesHalfFloatsIfAskedTo) {
    write("half.pbrt", tinyScene("Film \"rgb\" \"integer xresolution\" 16 \"integer yresolution\" 12 \"bool savefp16\" true"));
    ASSERT_EQ(run({"render", "tiny.pbrt", "-o", "full.exr"}).status, 0);
    ASSERT_EQ(run({"render", "half.pbrt", "-o", "half.exr"}).status, 0);
    const FilmImage full = image("full.exr"), half = image("half.exr");
    bool differs = false;
    for (size_t i = 0; i < full.pixelCount(); ++i) {
        EXPECT_NEAR(half.color[i].r, full.color[i].r, full.color[i].r / 2048 + 1e-7) << "half of the last of 11 digits";
        differs |= half.color[i] != full.color[i];
    }
    EXPECT_TRUE(differs);

    write("bright.pbrt",
          tinyScene("Film \"rgb\" \"integer xresolution\" 16 \"integer yresolution\" 12 \"float iso\" 1e8 \"bool savefp16\" true"));
    const Outcome bright = run({"render", "bright.pbrt", "-o", "bright.exr"});
    EXPECT_THAT(bright.error,
                testing::ContainsRegex("bright.pbrt:5:1: warning: [0-9]+ pixels are brighter than 65504, the most that 16-bit "
                                       "floats hold; in EXR files they are clamped: --pixel-type float, or \"bool savefp16\" false, keeps "
                                       "all"));
}

}  // namespace
}  // namespace eikonal
