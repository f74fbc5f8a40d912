// What the program prints.

#include "cli.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>

#include <unistd.h>

namespace eikonal {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST_F(Cli, LoadingKernelsIsNotCalledCompiling) {
    ASSERT_EQ(run({"render", "tiny.pbrt"}).status, 0);
    const Running running = start({"render", "tiny.pbrt", "--log-level", "info"});
    EXPECT_TRUE(printed(running, "planned memory"));
    /* A machine that is busy with something else */
    for (int i = 0; i < 4; ++i) {
        ::kill(running.process, SIGSTOP);
        ::usleep(600'000);
        ::kill(running.process, SIGCONT);
        ::usleep(20'000);
    }
    const Outcome run = wait(running);
    EXPECT_EQ(run.status, 0);
    EXPECT_THAT(run.error, Not(HasSubstr("compiling")));
}

TEST_F(Cli, QuietPrintsNothing) {
    const Outcome run = this->run({"render", "tiny.pbrt", "--quiet"});
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.out + run.error, "");
}

TEST_F(Cli, StatsTellWhereTimeAndMemoryWent) {
    const Outcome run = this->run({"render", "tiny.pbrt", "--stats"});
    for (const char* what : {"read the scene", "compile the kernels", "intersect_rays", "until the first ray", "render ", "shadow rays",
                             "Memory: scene tables"})
        EXPECT_THAT(run.out, HasSubstr(what));
}

TEST_F(Cli, InfoTellsWhatASceneRequiresAndWhy) {
    const Outcome text = run({"info", "tiny.pbrt"});
    EXPECT_EQ(text.status, 0);
    EXPECT_THAT(text.out, HasSubstr("2 triangles"));
    EXPECT_THAT(text.out, HasSubstr("tiny.pbrt:"));
    const auto json = nlohmann::json::parse(run({"info", "tiny.pbrt", "--json"}).out);
    EXPECT_EQ(json.at("counts").at("triangles"), 2);
    EXPECT_GT(json.at("memory").at("queues"), 0);
    EXPECT_GT(json.at("memory").at("most"), json.at("memory").at("tables").get<size_t>() + json.at("memory").at("queues").get<size_t>());
    const auto requires_ = [&](const char* name) {
        return std::any_of(json.at("features").begin(), json.at("features").end(), [&](const auto& f) { return f.at("name") == name; });
    };
    EXPECT_TRUE(requires_("BSDF_DIFFUSE"));
    EXPECT_FALSE(requires_("MEDIA"));
    /* What a film asks for counts, too */
    write("gbuffer.pbrt", "Film \"gbuffer\" \"integer xresolution\" 16 \"integer yresolution\" 12\nWorldBegin\nShape \"sphere\"\n");
    EXPECT_THAT(run({"info", "gbuffer.pbrt"}).out, HasSubstr("AOVS"));
    write("empty.pbrt", "WorldBegin\n");
    EXPECT_THAT(run({"info", "empty.pbrt"}).out, HasSubstr("contents   nothing\n"));
}

TEST_F(Cli, JsonTellsHowARenderWent) {
    write("warned.pbrt", tinyScene("", "LightSource \"infinite\" \"float scle\" 2"));
    const auto rendered = [&](std::vector<std::string> more, int status) {
        more.insert(more.begin(), {"render", "warned.pbrt", "-o", "a.exr", "--seed", "7", "--json"});
        const Outcome run = this->run(more);
        EXPECT_EQ(run.status, status) << run.error;
        EXPECT_EQ(std::ranges::count(run.out, '\n'), 1) << "one line";
        return nlohmann::json::parse(run.out);
    };
    const auto whole = rendered({"--checkpoint", "a.film"}, 0);
    EXPECT_EQ(whole.at("files"), nlohmann::json::parse(R"(["a.exr", "a.png"])"));
    EXPECT_EQ(whole.at("checkpoint"), "a.film");
    EXPECT_TRUE(whole.at("isComplete"));
    EXPECT_EQ(whole.at("status"), 0);
    EXPECT_EQ(whole.at("seed"), 7);
    EXPECT_EQ(whole.at("samples").at("fewest"), 4);
    EXPECT_LE(whole.at("error").at("low"), whole.at("error").at("value"));
    EXPECT_GE(whole.at("error").at("high"), whole.at("error").at("value"));
    ASSERT_EQ(whole.at("warnings").size(), 1u);
    EXPECT_THAT(whole.at("warnings")[0].get<std::string>(), HasSubstr("\"float scle\" is ignored"));
    for (const char* step : {"read", "pack", "compile", "render", "write"})
        EXPECT_LE(whole.at("seconds").at(step), whole.at("seconds").at("all")) << step;
    EXPECT_EQ(whole.at("sceneHash"), readImage(path("a.exr")).metadata.sceneHash);

    const auto partial = rendered({"--spp", "100000000", "--time-limit", "0.2"}, 4);
    EXPECT_FALSE(partial.at("isComplete"));
    EXPECT_EQ(partial.at("status"), 4);
    EXPECT_TRUE(partial.at("checkpoint").is_null());
    EXPECT_EQ(partial.at("hashes").at("files"), whole.at("hashes").at("files"));
    EXPECT_EQ(partial.at("hashes").at("tables").at("geometry"), whole.at("hashes").at("tables").at("geometry"));
}

TEST_F(Cli, InfoNeedsNoDevice) { EXPECT_EQ(run({"info", "tiny.pbrt"}, {{"OCL_ICD_VENDORS", path("")}}).status, 0); }

TEST_F(Cli, AnObjIsASceneByItself) {
    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Outcome run = this->run({"info", "a.obj", "--camera", "0,0,3", "--look-at", "0.3,0.3,0", "--fov", "30", "--resolution", "32x16"});
    EXPECT_EQ(run.status, 0) << run.error;
    EXPECT_THAT(run.out, HasSubstr("32 x 16"));
    EXPECT_THAT(run.out, HasSubstr("1 triangles"));
}

TEST_F(Cli, CompareFindsAnImageEqualToItself) {
    ASSERT_EQ(run({"render", "tiny.pbrt", "-o", "a.exr"}).status, 0);
    const auto json = nlohmann::json::parse(run({"compare", "a.exr", "a.exr", "--json"}).out);
    EXPECT_EQ(json.at("relativeMse"), 0);
    EXPECT_EQ(json.at("blocksOff"), 0);
}

/// --scatter takes an image as if it had no variance.
TEST_F(Cli, ComparesByScatter) {
    for (const std::string seed : {"1", "2"})
        ASSERT_EQ(run({"render", "tiny.pbrt", "--seed", seed, "--aov", "variance", "-o", seed + ".exr"}).status, 0);
    ASSERT_EQ(run({"render", "tiny.pbrt", "--seed", "1", "-o", "bare.exr"}).status, 0);
    const auto worst = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"compare", "--json"});
        return nlohmann::json::parse(run(arguments).out).at("worstBlock").at("distance").get<double>();
    };
    const double scatter = worst({"--scatter", "1.exr", "2.exr"});
    EXPECT_EQ(scatter, worst({"bare.exr", "2.exr"}));
    EXPECT_NE(scatter, worst({"1.exr", "2.exr"}));
}

TEST_F(Cli, DevicesAreListed) {
    for (const char* spelling : {"list-devices", "--list-devices"}) {
        const Outcome run = this->run({spelling});
        EXPECT_EQ(run.status, 0);
        EXPECT_THAT(run.out, testing::StartsWith("0  "));
    }
}

}  // namespace
}  // namespace eikonal
