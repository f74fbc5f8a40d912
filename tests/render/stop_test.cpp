// A stop takes effect within a second, even if no path would ever end, and the image so far is written.

#include "cli.h"
#include "clock.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <csignal>

#include <unistd.h>

namespace eikonal {
namespace {

using testing::HasSubstr;

/// Seconds in which a stop takes effect, and those that starting and writing may take on a busy machine.
constexpr double effect = 1, slack = 2;

class Stops : public Cli {
protected:
    /// A null collision every 1e-9 units for red heroes, in a medium that is thin for them: 1e9 steps per ray.
    Stops() {
        std::string colors;
        for (int i = 0; i < 8; ++i) colors += " 1e-3 1e-3 1e9";
        write("loose.pbrt", tinyScene("", fmt::format("MakeNamedMedium \"m\" \"string type\" \"rgbgrid\" \"integer nx\" 2 \"integer ny\" 2 "
                                                      "\"integer nz\" 2 \"rgb sigma_a\" [{0}] \"rgb sigma_s\" [{0}] \"point3 p0\" [-3 -3 "
                                                      "-3] \"point3 p1\" [3 3 3] AttributeBegin Material \"interface\" MediumInterface "
                                                      "\"m\" \"\" Shape \"sphere\" \"float radius\" 20 AttributeEnd\n",
                                                      colors)));
        /* Paths bounce between walls of albedo 1 for ever */
        write("closed.pbrt", tinyScene("Integrator \"path\" \"integer maxdepth\" 1000000000\n",
                                       "Material \"diffuse\" \"rgb reflectance\" [1 1 1] Shape \"sphere\" \"float radius\" 30\n"));
    }
    void expectStopped(const std::string& scene, int number) {
        this->run({"render", scene, "-o", "a.exr", "--time-limit", "0.1"});   /* compiles the kernels */
        const Running running = start({"render", scene, "-o", "a.exr", "--spp", "100000", "--log-level", "info"});
        EXPECT_TRUE(printed(running, "rendering 16 x 12 pixels"));
        ::usleep(300'000);
        const Stopwatch time;
        ::kill(running.process, number);
        const Outcome run = wait(running);
        EXPECT_LT(time.seconds(), effect + slack);
        EXPECT_EQ(run.status, 128 + number);
        EXPECT_THAT(run.error, HasSubstr("interrupted: "));
        EXPECT_EQ(image("a.exr").pixelCount(), 192u);
    }
};

TEST_F(Stops, InAMediumWithALooseMajorant) { expectStopped("loose.pbrt", SIGTERM); }
TEST_F(Stops, InAClosedRoomOfAlbedoOne) { expectStopped("closed.pbrt", SIGINT); }
TEST_F(Stops, WhenTheTerminalCloses) { expectStopped("closed.pbrt", SIGHUP); }

TEST_F(Stops, AtTheTimeLimitWithoutAWholeSample) {
    for (const char* scene : {"loose.pbrt", "closed.pbrt"}) {
        this->run({"render", scene, "-o", "a.exr", "--time-limit", "0.1"});
        const Outcome run = this->run({"render", scene, "-o", "a.exr", "--spp", "100000", "--time-limit", "0.5"});
        EXPECT_EQ(run.status, 4) << run.error;
        EXPECT_LT(run.seconds, 0.5 + effect + slack);
        EXPECT_THAT(run.error, HasSubstr("ended by --time-limit"));
    }
}

// A deadline counts everything: here the kernels are compiled, and the image is written. Nothing of that is late on an idle machine.
TEST_F(Stops, AtTheDeadline) {
    constexpr double deadline = 2;
    this->run({"render", "closed.pbrt", "-o", "a.exr", "--time-limit", "0.1"});
    const Outcome run = this->run({"render", "closed.pbrt", "-o", "a.exr", "--spp", "100000", "--deadline", "2s"});
    EXPECT_EQ(run.status, 4) << run.error;
    EXPECT_LT(run.seconds, deadline + slack);
    EXPECT_GT(run.seconds, deadline - effect);
    EXPECT_THAT(run.error, HasSubstr("ended by --deadline"));
    const Outcome late = this->run({"render", "closed.pbrt", "-o", "a.exr", "--spp", "100000", "--deadline", "0.001"});
    EXPECT_EQ(late.status, 4);
    EXPECT_THAT(late.error, HasSubstr("the deadline will be missed by "));
    const Outcome first = this->run({"render", "closed.pbrt", "-o", "a.exr", "--spp", "100000", "--deadline", "1h", "--time-limit", ".2"});
    EXPECT_THAT(first.error, HasSubstr("ended by --time-limit"));
}

}  // namespace
}  // namespace eikonal
