// Checkpoints: a render that ended early, in whatever way, goes on to the bits of one that did not.

#include "cli.h"
#include "same_files.h"

#include "film/film_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <csignal>
#include <random>

#include <unistd.h>

namespace eikonal {
namespace {

using testing::HasSubstr;

class Checkpoint : public Cli {
protected:
    using Words = std::vector<std::string>;
    Words render(const std::string& image, const Words& more) const {
        Words words{"render", "tiny.pbrt", "-o", image, "--aov", "all", "--log-level", "info"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    Words withCheckpoint(const std::string& image, Words more, const std::string& file = "c.film") const {
        more.insert(more.end(), {"--checkpoint", file, "--resume"});
        return render(image, more);
    }
    /// Ends a render by a signal when it has begun and some time has passed.
    Outcome endBy(int signal, const Words& words, int microseconds) const {
        const Running running = start(words);
        EXPECT_TRUE(printed(running, "rendering "));
        ::usleep(static_cast<useconds_t>(microseconds));
        ::kill(running.process, signal);
        return wait(running);
    }
    double secondsKept() const { return exists("c.film") ? FilmFileReader(path("c.film")).head().seconds : 0; }

    /// Kills a render `times` times at random moments, lets it end, and compares.
    void kill(int times, const Words& settings) {
        constexpr double interval = 0.1, slack = 0.5;   // a checkpoint of 30 KB and the batch before it take less, also on a busy machine
        ASSERT_EQ(run(render("whole.exr", settings)).status, 0);
        Words words = withCheckpoint("a.exr", settings);
        words.insert(words.end(), {"--checkpoint-every", fmt::format("{}s", interval)});
        std::mt19937 random(1);
        for (int i = 0; i < times; ++i) {
            const double before = secondsKept(), wait = std::uniform_real_distribution(0., 0.6)(random);
            if (endBy(SIGKILL, words, static_cast<int>(wait * 1e6)).status != 128 + SIGKILL) break;   // it was finished before
            ASSERT_GE(secondsKept(), before + wait - interval - slack) << "more was lost than the interval";
        }
        ASSERT_EQ(run(words).status, 0);
        expectSameFiles(path("whole.exr"), path("a.exr"));
        for (const auto& file : std::filesystem::directory_iterator(folder_))
            EXPECT_NE(file.path().extension(), ".part") << "left by a process that was killed";
    }
};

TEST_F(Checkpoint, ARenderThatTheTimeLimitEndedGoesOnToTheSameBits) {
    ASSERT_EQ(run(render("whole.exr", {"--spp", "3000"})).status, 0);
    ASSERT_EQ(run(withCheckpoint("a.exr", {"--spp", "3000", "--time-limit", "0.05"})).status, 4);
    EXPECT_LT(readImage(path("a.exr")).metadata.samples.value(), 3000);
    ASSERT_EQ(run(withCheckpoint("a.exr", {"--spp", "3000"})).status, 0);
    expectSameFiles(path("whole.exr"), path("a.exr"));

    /* The same samples again */
    const std::string before = read(path("c.film"));
    const Outcome again = run(withCheckpoint("b.exr", {"--spp", "3000"}));
    EXPECT_EQ(again.status, 0);
    EXPECT_THAT(again.error, HasSubstr("nothing is left to render"));
    expectSameFiles(path("whole.exr"), path("b.exr"));
    EXPECT_EQ(read(path("c.film")), before);
}

TEST_F(Checkpoint, MoreSamplesAreThoseOfALongerRender) {
    ASSERT_EQ(run(withCheckpoint("a.exr", {"--spp", "24"})).status, 0);
    ASSERT_EQ(run(withCheckpoint("a.exr", {"--spp", "100"})).status, 0);
    ASSERT_EQ(run(render("whole.exr", {"--spp", "100"})).status, 0);
    expectSameFiles(path("whole.exr"), path("a.exr"));
}

TEST_F(Checkpoint, SignalsLeaveOne) {
    const Words settings{"--spp", "20000"};
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        EXPECT_EQ(endBy(signal, withCheckpoint("a.exr", settings), 100'000).status, 128 + signal);
    ASSERT_EQ(run(withCheckpoint("a.exr", settings)).status, 0);
    ASSERT_EQ(run(render("whole.exr", settings)).status, 0);
    expectSameFiles(path("whole.exr"), path("a.exr"));
}

TEST_F(Checkpoint, KillingLosesTheIntervalAtMost) { kill(3, {"--spp", "20000"}); }
TEST_F(Checkpoint, KillingAdaptiveSamplingLosesTheIntervalAtMost) {
    kill(3, {"--spp", "100000", "--target-error", "0.001", "--resolution", "70x50"});
}

class SlowCheckpoint : public Checkpoint {};
TEST_F(SlowCheckpoint, AHundredKillsLoseTheIntervalAtMost) { kill(100, {"--spp", "800000"}); }
TEST_F(SlowCheckpoint, AHundredKillsOfAdaptiveSamplingLoseTheIntervalAtMost) {
    kill(100, {"--spp", "4000000", "--target-error", "0.0002", "--resolution", "70x50"});
}

TEST_F(Checkpoint, PartialImagesAreWrittenMeanwhile) {
    const Running running = start(render("a.exr", {"--spp", "100000000", "--write-partial-images", "--checkpoint-every", "0.1s"}));
    for (int i = 0; i < 600 && !exists("a.png"); ++i) ::usleep(100'000);
    EXPECT_TRUE(exists("a.png"));
    EXPECT_GT(image("a.exr").color[6 * 16 + 8].r, 0.1f);
    ::kill(running.process, SIGTERM);
    EXPECT_EQ(wait(running).status, 128 + SIGTERM);
}

TEST_F(Checkpoint, OfAnotherRenderIsRefused) {
    write("plate.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                       "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 -1\n1 0 -1\n0 1 -1\n3 0 1 2\n");
    write("tiny.pbrt", tinyScene("", "Shape \"plymesh\" \"string filename\" \"plate.ply\""));
    ASSERT_EQ(run(withCheckpoint("a.exr", {})).status, 0);
    const std::string kept = read(path("c.film"));
    const auto refusal = [&](const Words& settings) {
        const Outcome outcome = run(withCheckpoint("b.exr", settings));
        EXPECT_EQ(outcome.status, 1);
        EXPECT_FALSE(exists("b.exr"));
        EXPECT_EQ(read(path("c.film")), kept);
        EXPECT_THAT(outcome.error, HasSubstr("c.film: cannot go on from it, because it is of another render:"));
        return outcome.error;
    };
    EXPECT_THAT(refusal({"--seed", "7"}), HasSubstr("seed is \"7\" here and \"0\" in c.film"));
    EXPECT_THAT(refusal({"--resolution", "20x10"}), HasSubstr("image is \"20 x 10\" here and \"16 x 12\" in c.film"));
    EXPECT_THAT(refusal({"--fireflies", "reweight"}), HasSubstr("kept of each pixel (by --aov, --fireflies and others): only here bands"));
    EXPECT_THAT(refusal({"--sampler", "sobol"}), HasSubstr("sampler is \"sobol\" here and \"independent\" in c.film"));
    EXPECT_THAT(refusal({"--max-depth", "2"}), HasSubstr("maximum depth is \"2\" here and \"5\" in c.film"));

    std::string ply = read(path("plate.ply"));
    write("plate.ply", ply.replace(ply.find("1 0 -1"), 6, "9 0 -1"));
    EXPECT_THAT(refusal({}), testing::ContainsRegex("file \"[^\"]*plate.ply\": content has hash [0-9a-f]+ here, [0-9a-f]+ in c.film"));

    const Outcome unasked = run(render("b.exr", {"--checkpoint", "c.film"}));
    EXPECT_EQ(unasked.status, 2);
    EXPECT_THAT(unasked.error, HasSubstr("\"c.film\" is there already; add --resume"));
}

/// Each of them is noticed before anything is rendered, and stays what it is.
TEST_F(Checkpoint, HasANameOfItsOwn) {
    for (const Words& both : {Words{"-o", "a.exr", "--checkpoint", "a.exr"}, {"-o", "a.exr", "--checkpoint", "./a.png"},
                              {"-o", "a.exr", "--log-file", "a.exr"}, {"-o", "a.film", "-o", "b.exr", "--log-file", "b.exr"}}) {
        Words words{"render", "tiny.pbrt"};
        words.insert(words.end(), both.begin(), both.end());
        const Outcome outcome = run(words);
        EXPECT_NE(outcome.status, 0);
        EXPECT_THAT(outcome.error, HasSubstr("one would overwrite the other"));
    }
}

/// A file that appears under the checkpoint's name while a render runs stays what it is: the checkpoint goes beside it.
TEST_F(Checkpoint, LeavesWhatAnotherProgramHasWritten) {
    const Running running = start(render("a.exr", {"--spp", "1000000", "--checkpoint", "c.film"}));
    ASSERT_TRUE(printed(running, "rendering "));
    write("c.film", "of another program");
    ::usleep(500'000);   // for some samples, without which there is no checkpoint
    ::kill(running.process, SIGTERM);
    const Outcome outcome = wait(running);
    EXPECT_THAT(outcome.error, HasSubstr("another program has written it since this render began; the checkpoint is"));
    EXPECT_EQ(std::filesystem::file_size(path("c.film")), std::string("of another program").size());
    EXPECT_GT(FilmFileReader(path("c-2.film")).head().seconds, 0);
}

/// A limit that ends a render just after its last samples leaves a whole image.
TEST_F(Checkpoint, OfAllSamplesIsComplete) {
    const Outcome outcome = run({"render", "tiny.pbrt", "-o", "a.exr", "--time-limit", "0.000001", "--json"});
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_THAT(outcome.out, HasSubstr("\"isComplete\":true"));
}

TEST_F(Checkpoint, DamageIsNoticed) {
    ASSERT_EQ(run(withCheckpoint("a.exr", {})).status, 0);
    const std::string whole = read(path("c.film"));
    const auto complaint = [&](const std::string& content) {
        write("d.film", content);
        const Outcome outcome = run(withCheckpoint("b.exr", {}, "d.film"));
        EXPECT_EQ(outcome.status, 1);
        EXPECT_EQ(read(path("d.film")), content);
        return outcome.error;
    };
    for (const size_t bytes : {size_t(40), whole.size() / 2, whole.size() - 1})
        EXPECT_THAT(complaint(whole.substr(0, bytes)), HasSubstr("d.film: is truncated")) << bytes;
    for (const size_t place : {size_t(35), whole.size() / 3, whole.size() * 2 / 3, whole.size() - 3}) {
        std::string damaged = whole;
        damaged[place] = static_cast<char>(damaged[place] ^ 16);
        EXPECT_THAT(complaint(damaged), HasSubstr("d.film: is damaged")) << place;
    }
    EXPECT_THAT(complaint(whole + "x"), HasSubstr("d.film: is damaged"));
    EXPECT_THAT(complaint(read(path("a.exr"))), HasSubstr("d.film: is not a film file of Eikonal"));
    EXPECT_THAT(complaint(""), HasSubstr("d.film: is not a film file of Eikonal"));
    EXPECT_THAT(complaint("Eikonal film 9" + whole.substr(14)), HasSubstr("d.film: is \"Eikonal film 9\", and this program reads"));
}

}  // namespace
}  // namespace eikonal
