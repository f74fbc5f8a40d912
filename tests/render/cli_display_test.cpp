// The image in another program while it is rendered: --display-server.

#include "cli.h"
#include "fake_display.h"
#include "same_files.h"

#include "image/channels.h"

#include <gmock/gmock.h>

namespace eikonal {
namespace {

using testing::HasSubstr;

/// More pixels than a tile has, in both directions, and a crop: the other program gets the pixels that are rendered.
TEST_F(Cli, TheDisplayServerGetsTheImageThatIsWritten) {
    FakeDisplay display;
    const Outcome run = this->run({"render", "tiny.pbrt", "-o", "a.exr", "--resolution", "300x200", "--pixelbounds", "10,290,5,150",
                                   "--spp", "16", "--aov", "albedo,depth", "--display-server", display.address()});
    EXPECT_EQ(run.status, 0) << run.error;
    const auto& images = display.images();
    EXPECT_EQ(display.problem(), "");
    ASSERT_EQ(images.size(), 1u);
    EXPECT_THAT(images.begin()->first, HasSubstr("tiny.pbrt ("));
    const FakeDisplay::Image& shown = images.begin()->second;
    EXPECT_EQ(shown.width, 280);
    EXPECT_EQ(shown.height, 145);
    const FilmImage written = image("a.exr");
    const auto channels = channelsOf<const float>(written);
    EXPECT_EQ(shown.channels.size(), channels.size());
    for (const auto& channel : channels) {
        ASSERT_TRUE(shown.channels.contains(channel.name)) << channel.name;
        const std::vector<float>& values = shown.channels.at(channel.name);
        std::size_t different = 0;
        for (std::size_t i = 0; i < values.size(); ++i)
            different += values[i] != channel[i] && !(channel.use.isDepth && values[i] > noDepth && channel[i] == noDepth);
        EXPECT_EQ(different, 0u) << channel.name;
    }
}

TEST_F(Cli, TheDisplayServerSeesTheRenderGoOn) {
    FakeDisplay display;
    const Outcome run = this->run(
        {"render", "tiny.pbrt", "-o", "a.exr", "--spp", "100000000", "--time-limit", "1.5", "--display-server", display.address()});
    EXPECT_EQ(run.status, 4) << run.error;
    ASSERT_EQ(display.images().size(), 1u);
    EXPECT_EQ(display.problem(), "");
    EXPECT_GE(display.images().begin()->second.updates, 2 * 3) << "each update has three channels";
}

TEST_F(Cli, ADisplayServerThatIsNotThereIsOneWarning) {
    const Outcome run =
        this->run({"render", "tiny.pbrt", "-o", "a.exr", "--spp", "100000000", "--time-limit", "1.5", "--display-server", "localhost:1"});
    EXPECT_EQ(run.status, 4) << run.error;
    EXPECT_TRUE(exists("a.exr"));
    const std::string warning = "warning: --display-server: localhost:1 cannot be reached: ";
    const auto first = run.error.find(warning);
    ASSERT_NE(first, std::string::npos) << run.error;
    EXPECT_EQ(run.error.find(warning, first + 1), std::string::npos) << run.error;
}

TEST_F(Cli, BeingShownChangesNoBits) {
    FakeDisplay display;
    EXPECT_EQ(run({"render", "tiny.pbrt", "-o", "a.exr", "--spp", "64", "--aov", "all"}).status, 0);
    EXPECT_EQ(run({"render", "tiny.pbrt", "-o", "b.exr", "--spp", "64", "--aov", "all", "--display-server", display.address()}).status, 0);
    EXPECT_EQ(display.images().size(), 1u);
    expectSameFiles(path("a.exr"), path("b.exr"));
}

TEST_F(Cli, TheDisplayServersAddressIsChecked) {
    for (const char* wrong : {"localhost", "localhost:", ":14158", "localhost:70000", "localhost:http", "::1:14158"}) {
        const Outcome run = this->run({"render", "tiny.pbrt", "--display-server", wrong});
        EXPECT_EQ(run.status, 2) << wrong;
        EXPECT_THAT(run.error, HasSubstr("--display-server takes HOST:PORT, like localhost:14158 or [::1]:14158, not"));
    }
}

}  // namespace
}  // namespace eikonal
