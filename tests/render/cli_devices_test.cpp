// --device with several devices. PoCL makes as many of a processor as its environment says.

#include "cli.h"
#include "same_files.h"

#include <gmock/gmock.h>

namespace eikonal {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;

class CliDevices : public Cli {
protected:
    const Environment two{{"POCL_DEVICES", "basic pthread"}}, three{{"POCL_DEVICES", "pthread basic pthread"}};
};

TEST_F(CliDevices, RenderTheBitsOfOne) {
    ASSERT_EQ(run({"render", "tiny.pbrt", "-o", "one.exr", "--spp", "40"}, two).status, 0);
    const Outcome both = run({"render", "tiny.pbrt", "-o", "both.exr", "--spp", "40", "--device", "0,1", "--stats"}, two);
    EXPECT_EQ(both.status, 0) << both.error;
    EXPECT_THAT(both.out, ContainsRegex("Device: basic.* \\([0-9]+ % of the paths\\) \\+ pthread.* \\([0-9]+ % of the paths\\)"));
    const Outcome all = run({"render", "tiny.pbrt", "-o", "all.exr", "--spp", "40", "--device", "all"}, three);
    EXPECT_EQ(all.status, 0) << all.error;
    for (const char* name : {"both.exr", "all.exr"}) expectSameFiles(path("one.exr"), path(name));
}

TEST_F(CliDevices, GoOnFromACheckpointOfOne) {
    ASSERT_EQ(run({"render", "tiny.pbrt", "-o", "whole.exr", "--spp", "64"}, two).status, 0);
    ASSERT_EQ(run({"render", "tiny.pbrt", "-o", "a.exr", "--spp", "24", "--checkpoint", "c"}, two).status, 0);
    const Outcome resumed =
        run({"render", "tiny.pbrt", "-o", "a.exr", "--spp", "64", "--checkpoint", "c", "--resume", "--device", "all"}, two);
    EXPECT_EQ(resumed.status, 0) << resumed.error;
    expectSameFiles(path("whole.exr"), path("a.exr"));
}

TEST_F(CliDevices, AreNamedWhereTheyCannotRenderTogether) {
    EXPECT_THAT(run({"render", "tiny.pbrt", "--device", "0,0"}, two).error, HasSubstr("--device 0,0: \"0\" is device 0 again"));
    const Outcome unknown = run({"render", "tiny.pbrt", "--device", "0,nosuch"}, two);
    EXPECT_EQ(unknown.status, 3);
    EXPECT_THAT(unknown.error, AllOf(HasSubstr("no OpenCL device is called \"nosuch\""), HasSubstr("\n  1  pthread")));
    const Outcome bench = run({"bench", "tiny.pbrt", "--device", "0,1"}, two);
    EXPECT_EQ(bench.status, 2);
    EXPECT_THAT(bench.error, HasSubstr("measures one device"));
}

}  // namespace
}  // namespace eikonal
