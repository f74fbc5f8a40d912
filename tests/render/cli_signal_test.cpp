// Renderings that end early, by a limit or a signal.

#include "cli.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <iterator>

#include <unistd.h>

namespace eikonal {
namespace {

using testing::HasSubstr;

TEST_F(Cli, TheTimeLimitLeavesAWholeImage) {
    const Outcome run =
        this->run({"render", "tiny.pbrt", "-o", "a.exr", "--spp", "100000000", "--time-limit", "0.2", "--aov", "sampleCount"});
    EXPECT_EQ(run.status, 4) << "a valid image, but not all of its samples";
    EXPECT_THAT(run.error, testing::ContainsRegex("ended by --time-limit: [0-9].* of 100000000 samples per pixel"));
    const FilmFile exr = readImage(path("a.exr"));
    EXPECT_GE(exr.metadata.samples.value_or(0), 1);
    EXPECT_LT(exr.metadata.samples.value_or(0), 100000000);
    EXPECT_THAT(run.error, testing::ContainsRegex("error about [0-9.e-]+ % .relmse-root., 95 % within [0-9.e-]+ to [0-9.e-]+ %"));
    EXPECT_GT(exr.metadata.error.value_or(0), 0);
    EXPECT_GE(*std::min_element(exr.image.sampleCount.begin(), exr.image.sampleCount.end()), 1);
}

class Signals : public Cli, public testing::WithParamInterface<int> {};

TEST_P(Signals, LeaveTheImageSoFar) {
    const Running running = start({"render", "tiny.pbrt", "-o", "a.exr", "--spp", "100000000", "--log-level", "info"});
    EXPECT_TRUE(printed(running, "rendering 16 x 12 pixels"));
    ::usleep(300'000);
    ::kill(running.process, GetParam());
    const Outcome run = wait(running);
    EXPECT_EQ(run.status, 128 + GetParam());
    EXPECT_THAT(run.error, HasSubstr("interrupted: "));
    EXPECT_THAT(run.error, HasSubstr("\nerror about "));
    const Metadata metadata = readImage(path("a.exr")).metadata;
    EXPECT_LT(metadata.errorLow.value(), metadata.error.value());
    EXPECT_GT(metadata.errorHigh.value(), metadata.error.value());
    EXPECT_EQ(metadata.errorMetric, "relmse-root");
    EXPECT_LT(run.seconds, 10);
    EXPECT_GT(image("a.exr").color[6 * 16 + 8].r, 0.1f);
}

INSTANTIATE_TEST_SUITE_P(Cli, Signals, testing::Values(SIGINT, SIGTERM, SIGHUP));

/// As for a command that a script starts with `&`: Ctrl-C is meant for what is in front.
TEST_F(Cli, ASignalThatIsIgnoredStaysIgnored) {
    const auto before = std::signal(SIGINT, SIG_IGN);   // inherited
    const Running running =
        start({"render", "tiny.pbrt", "-o", "a.exr", "--spp", "100000000", "--time-limit", "1.5", "--log-level", "info"});
    std::signal(SIGINT, before);
    EXPECT_TRUE(printed(running, "rendering 16 x 12 pixels"));
    ::usleep(300'000);
    for (int i = 0; i < 2; ++i) ::kill(running.process, SIGINT);
    const Outcome run = wait(running);
    EXPECT_EQ(run.status, 4);
    EXPECT_THAT(run.error, HasSubstr("ended by --time-limit: "));
}

/// The processes whose parent is this one.
static std::vector<int> childrenOf(int process) {
    std::ifstream list("/proc/" + std::to_string(process) + "/task/" + std::to_string(process) + "/children");
    return {std::istream_iterator<int>(list), {}};
}

/// Whether it is there and no zombie.
static bool runs(int process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/stat");
    std::string number, name, state;
    return file >> number >> name >> state && state != "Z";
}

TEST_F(Cli, WorkersEndWithTheProgram) {
    const Running running = start({"render", "tiny.pbrt", "--nthreads", "2"}, {{"EIKONAL_CACHE_DIR", path("cache")}});
    std::vector<int> workers;
    for (int i = 0; i < 60'000 && workers.size() < 2 && runs(running.process); ++i) {
        ::usleep(1000);
        workers = childrenOf(running.process);
    }
    EXPECT_EQ(workers.size(), 2u);
    ::kill(running.process, SIGINT);
    EXPECT_EQ(wait(running).status, 128 + SIGINT);
    for (const int worker : workers) {
        for (int i = 0; i < 600 && runs(worker); ++i) ::usleep(100'000);
        EXPECT_FALSE(runs(worker));
    }
    for (const auto& file : std::filesystem::directory_iterator(path("cache")))
        EXPECT_NE(file.path().extension(), ".program") << "it went on to make " << file.path();
}

/// All samples are taken, and all of them will be on disk: that is no early end.
TEST_F(Cli, ASignalWhileAFinishedImageIsWrittenChangesNothing) {
    const Running running = start({"render", "tiny.pbrt", "-o", "a.exr", "--resolution", "800x600", "--spp", "1"});
    for (int i = 0; i < 60'000 && !exists("a.exr"); ++i) ::usleep(1000);
    EXPECT_FALSE(exists("a.png")) << "it comes after the EXR";
    ::kill(running.process, SIGINT);
    const Outcome run = wait(running);
    EXPECT_EQ(run.status, 0) << run.error;
    EXPECT_EQ(image("a.png").pixelCount(), 480'000u);
}

}  // namespace
}  // namespace eikonal
