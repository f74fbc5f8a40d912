// Standard streams, and several scenes in one call.

#include "cli.h"
#include "test_paths.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <sstream>

namespace eikonal {
namespace {

using testing::HasSubstr;

class Shell : public Cli {
protected:
    Outcome shell(const std::string& line) {
        program_ = "/bin/sh";
        const Outcome outcome = run({"-c", line});
        program_ = builtProgram;
        return outcome;
    }
};

TEST_F(Shell, AScenePassesThroughAPipe) {
    ASSERT_EQ(run({"render", "tiny.pbrt", "-o", "file.exr"}).status, 0);
    const Outcome piped = shell("gzip -c tiny.pbrt | " EIKONAL_BINARY " render - -o - --format exr > piped.exr");
    ASSERT_EQ(piped.status, 0) << piped.error;
    EXPECT_THAT(piped.error, HasSubstr("wrote standard output in"));
    EXPECT_EQ(image("piped.exr").color, image("file.exr").color);
    EXPECT_FALSE(exists("-"));
    ASSERT_EQ(shell(EIKONAL_BINARY " render - < tiny.pbrt").status, 0);
    EXPECT_TRUE(exists("stdin.exr") && exists("stdin.png"));
}

TEST_F(Shell, ErrorsInStandardInputHaveAPlace) {
    const Outcome bad = shell("echo 'WorldBegin Shape \"a\"' | " EIKONAL_BINARY " info -");
    EXPECT_EQ(bad.status, 1);
    EXPECT_THAT(bad.error, testing::StartsWith("<stdin>:1:12: "));
}

TEST_F(Shell, FilesOfASceneFromStandardInputAreInTheCurrentFolder) {
    write("part.pbrt", "Shape \"sphere\"\n");
    const Outcome info = shell("echo 'WorldBegin Include \"part.pbrt\"' | " EIKONAL_BINARY " info -");
    EXPECT_EQ(info.status, 0) << info.error;
    EXPECT_THAT(info.out, HasSubstr("1 spheres"));
}

TEST_F(Shell, AnImageDoesNotGoToATerminal) {
    const Outcome run = shell("script -qec '" EIKONAL_BINARY " render tiny.pbrt -o - --format png --spp 100000000' /dev/null");
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.out, HasSubstr("it is a terminal"));
}

TEST_F(Shell, AReaderThatHasGoneIsAnErrorOfTheImage) {
    const Outcome run = shell(EIKONAL_BINARY " render tiny.pbrt -o - --format png | true; exit ${PIPESTATUS:-0}");
    EXPECT_THAT(run.error, HasSubstr("cannot write to standard output: Broken pipe"));
}

TEST_F(Shell, TheFormatCountsMoreThanTheName) {
    ASSERT_EQ(run({"render", "tiny.pbrt", "-o", "image.bin", "--format", "png"}).status, 0);
    EXPECT_THAT(read(path("image.bin")), testing::StartsWith("\x89PNG"));
}

TEST_F(Shell, OneSceneThatFailsDoesNotKeepTheOthersFromRendering) {
    write("other.pbrt", tinyScene("", "Translate 0 0 0.5"));
    write("bad.pbrt", "WorldBegin Shape \"a\"\n");
    std::filesystem::create_directory(path("out"));
    const Outcome run = this->run({"render", "tiny.pbrt", "bad.pbrt", "other.pbrt", "-o", "out"});
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.error, HasSubstr("bad.pbrt:1:12: "));
    EXPECT_THAT(run.error, HasSubstr("bad.pbrt was not rendered\n"));
    for (const char* file : {"out/tiny.exr", "out/tiny.png", "out/other.exr", "out/other.png"}) EXPECT_TRUE(exists(file)) << file;
    ASSERT_EQ(this->run({"render", "other.pbrt", "-o", "alone.exr"}).status, 0);
    EXPECT_EQ(image("out/other.exr").color, image("alone.exr").color) << "a render before it changes nothing";
    EXPECT_NE(image("out/tiny.exr").color, image("alone.exr").color);
}

TEST_F(Shell, TheWorstStatusCountsAndAPartialImageIsBetterThanNone) {
    std::filesystem::create_directory(path("out"));
    EXPECT_EQ(run({"render", "tiny.pbrt", "-", "-o", "out", "--time-limit", "0.2", "--spp", "100000000"}).status, 1) << "no input";
    EXPECT_EQ(run({"render", "tiny.pbrt", "-o", "out", "--time-limit", "0.2", "--spp", "100000000"}).status, 4);
}

/// Without a cache, each call compiles; within one, the second scene finds the kernels of the first.
TEST_F(Shell, KernelsAreKeptBetweenScenes) {
    write("other.pbrt", tinyScene("", "Translate 0 0 0.5"));
    std::filesystem::create_directory(path("out"));
    const Outcome run = this->run({"render", "tiny.pbrt", "other.pbrt", "-o", "out", "--no-cache", "--json"});
    ASSERT_EQ(run.status, 0) << run.error;
    std::istringstream lines(run.out);
    std::string first, second;
    std::getline(lines, first);
    std::getline(lines, second);
    EXPECT_GT(nlohmann::json::parse(first).at("compiledKernels"), 0);
    EXPECT_EQ(nlohmann::json::parse(second).at("compiledKernels"), 0);
    EXPECT_LT(nlohmann::json::parse(second).at("seconds").at("all"), nlohmann::json::parse(first).at("seconds").at("all"));
    EXPECT_EQ(nlohmann::json::parse(second).at("hashes").at("files").size(), 1u) << "its own file only";
}

TEST_F(Shell, OneSceneDoesNotOverwriteTheImageOfAnother) {
    for (const char* name : {"a.pbrt", "b.pbrt"}) {
        std::string scene = tinyScene();
        scene.replace(scene.find("\"rgb\""), 5, "\"rgb\" \"string filename\" \"same.exr\"");
        write(name, scene);
    }
    const Outcome run = this->run({"render", "a.pbrt", "b.pbrt"});
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.error, HasSubstr("cannot write \"same.exr\": it is the image of a.pbrt; -o FOLDER/"));
}

}  // namespace
}  // namespace eikonal
