// Exit statuses and messages of what cannot be done.

#include "cli.h"
#include "test_paths.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <cctype>

namespace eikonal {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

TEST_F(Cli, ErrorsInASceneSayWhereAndExitWith1) {
    write("bad.pbrt", tinyScene() + "Shape \"sphere\" \"float radius\" oops\n");
    const Outcome bad = run({"render", "bad.pbrt"});
    EXPECT_EQ(bad.status, 1);
    EXPECT_THAT(bad.error, testing::MatchesRegex("bad.pbrt:[0-9]+:[0-9]+: .*\n"));
    EXPECT_FALSE(exists("bad.exr"));
    write("worse.pbrt", "WorldBegin\nShape \"a\"\nShape \"b\"\n");
    EXPECT_THAT(run({"info", "worse.pbrt"}).error, testing::MatchesRegex("worse.pbrt:2:1: .*\nworse.pbrt:3:1: .*\n"))
        << "each line begins with its place";
    EXPECT_EQ(run({"render", "absent.pbrt"}).status, 1);
    EXPECT_EQ(run({"info", "absent.obj"}).status, 1);
    EXPECT_EQ(run({"compare", "absent.exr", "absent.exr"}).status, 1);
}

/// What the command line alone shows to be wrong.
TEST_F(Cli, ErrorsOfTheCommandLineAreCalledSoAndHaveTheirStatus) {
    write("scene.blend", "");
    const std::pair<std::vector<std::string>, const char*> wrong[] = {
        {{"render", "scene.blend"}, ".pbrt or .obj"},
        {{"info", "scene.blend"}, ".pbrt or .obj"},
        {{"render", "tiny.pbrt", "-o", "a.xyz"}, "-o a.xyz: cannot write it: the extension \".xyz\" is not known; known are exr"},
        {{"render", "tiny.pbrt", "-o", "a"}, "its name has no extension"},
        {{"denoise", "a.exr", "-o", "a.xyz"}, "-o a.xyz"},
        {{"merge", "a.film", "-o", "a.xyz"}, "-o a.xyz"},
        {{"submit", "tiny.pbrt", "--engine", "slurm", "--dry-run", "-o", "a.xyz"}, "-o a.xyz"},
        {{"compare", "a.exr", "b.exr", "--heat-map", "a.xyz"}, "--heat-map a.xyz"},
        {{"render", "tiny.pbrt", "--spp"}, "--spp"},
        {{"render", "tiny.pbrt", "--no-such"}, "--no-such"}};
    for (const auto& [line, part] : wrong) {
        const Outcome run = this->run(line);
        EXPECT_EQ(run.status, 2) << part;
        EXPECT_THAT(run.error, testing::AllOf(testing::StartsWith("error: "), HasSubstr(part)));
    }
}

TEST_F(Cli, OutputThatCannotBeWrittenIsSaidBeforeRendering) {
    for (const char* file : {"absent/a.exr", "tiny.pbrt/a.exr"}) {
        const Outcome run = this->run({"render", "tiny.pbrt", "-o", file, "--spp", "100000000"});
        EXPECT_EQ(run.status, 1) << file;
        EXPECT_THAT(run.error, HasSubstr("cannot write")) << file;
        EXPECT_LT(run.seconds, 5) << file;
    }
}

TEST_F(Cli, AnImageThatTheSceneReadsIsNotOverwritten) {
    ASSERT_EQ(run({"render", "tiny.pbrt", "-o", "wall.png"}).status, 0);
    const std::string before = read(path("wall.png"));
    write("textured.pbrt", tinyScene("", "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"wall.png\" "
                                         "Material \"diffuse\" \"texture reflectance\" \"t\" Shape \"sphere\""));
    const Outcome onto = run({"render", "textured.pbrt", "-o", "./wall.png"});
    EXPECT_EQ(onto.status, 1);
    EXPECT_THAT(onto.error, HasSubstr("cannot write \"./wall.png\": the scene is read from it; name another file with -o\n"));
    EXPECT_EQ(read(path("wall.png")), before);
}

// libjpeg would end the program when the image is written.
TEST_F(Cli, ImagesThatAFormatCannotHoldAreSaidBeforeRendering) {
    for (const char* file : {"a.jpg", "a.webp", "a.tga"}) {
        const Outcome wide = run({"render", "tiny.pbrt", "--resolution", "65536x1", "--spp", "100000000", "-o", file});
        EXPECT_EQ(wide.status, 1) << file;
        EXPECT_THAT(wide.error, HasSubstr("and the image has 65536 x 1")) << file;
    }
}

TEST_F(Cli, WhatCannotBePrintedIsAnError) {
    program_ = "/bin/sh";
    const Outcome full = run({"-c", EIKONAL_BINARY " info tiny.pbrt > /dev/full"});
    EXPECT_EQ(full.status, 1);
    EXPECT_EQ(full.error, "error: cannot write to standard output: No space left on device\n");
}

TEST_F(Cli, ASceneThatIsNoTextDoesNotReachTheTerminal) {
    write("binary.pbrt", "\x1b]0;title\a\x1b[2J");
    const Outcome run = this->run({"info", "binary.pbrt"});
    EXPECT_EQ(run.status, 1);
    EXPECT_EQ(run.error, "binary.pbrt:1:1: a word of 1 character found where a directive is expected, such as Shape or Material\n");
    for (const char c : run.error) EXPECT_TRUE(c == '\n' || !std::iscntrl(static_cast<unsigned char>(c)));
}

TEST_F(Cli, ANameInASceneBeginsNoLineOfItsOwn) {
    for (const auto& [shape, name] : {std::pair("\"plymesh\" \"string filename\" \"a\\nb.pbrt:1:1: warning: forged.ply\"",
                                                "a\\x0ab.pbrt:1:1: warning: forged.ply"),
                                      {"\"sph\\nere\"", "\"sph\\x0aere\""}}) {
        write("forged.pbrt", std::string("WorldBegin\nShape ") + shape + "\n");
        const Outcome run = this->run({"info", "forged.pbrt"});
        EXPECT_EQ(run.status, 1);
        EXPECT_THAT(run.error, HasSubstr(name));
    }
}

TEST_F(Cli, ACropThatLeavesNothingIsThatOfTheOption) {
    const Outcome run = this->run({"render", "tiny.pbrt", "--pixelbounds", "300,400,0,10", "-o", "a.exr"});
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.error, HasSubstr("--pixelbounds: the crop, x from 300 to 400 and y from 0 to 10, leaves no pixel of the "));
}

TEST_F(Cli, ErrorsOfUsageExitWith2) {
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{},
                                               {"rendr"},
                                               {"render"},
                                               {"render", "tiny.pbrt", "--no-such-option"},
                                               {"render", "tiny.pbrt", "--spp", "0"},
                                               {"render", "tiny.pbrt", "--camera", "0,0,1"},
                                               {"render", "tiny.pbrt", "--local-size", "1048576"}}) {
        const Outcome run = this->run(arguments);
        EXPECT_EQ(run.status, 2) << testing::PrintToString(arguments) << run.error;
        EXPECT_THAT(run.error, HasSubstr("error: "));
        EXPECT_THAT(run.out, IsEmpty());
    }
}

TEST_F(Cli, AnImageThatDoesNotFitIsRefusedBeforeTheWork) {
    const Outcome run = this->run({"render", "tiny.pbrt", "--resolution", "200000x200000", "-o", "large.exr"});
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.error, testing::AllOf(HasSubstr("200000 x 200000 pixels need"), HasSubstr("--pixelbounds")));
    EXPECT_FALSE(exists("large.exr"));
}

TEST_F(Cli, ErrorsOfTheDeviceExitWith3) {
    const Outcome unknown = run({"render", "tiny.pbrt", "--device", "no such thing"});
    EXPECT_EQ(unknown.status, 3);
    EXPECT_THAT(unknown.error, HasSubstr("There are:\n  0  "));
    const Outcome none = run({"render", "tiny.pbrt"}, {{"OCL_ICD_VENDORS", path("")}});
    EXPECT_EQ(none.status, 3);
    EXPECT_THAT(none.error, HasSubstr("pocl-opencl-icd"));
}

/// PoCL and TBB would end the program. The limit does not hold for root, so the program runs as another user.
TEST_F(Cli, WithoutThreadsThereIsAnError) {
    if (::geteuid() != 0) GTEST_SKIP() << "only root may become a user without processes";
    program_ = "/usr/bin/prlimit";
    const Outcome run = this->run({"--nproc=1", "setpriv", "--reuid=61234", "--clear-groups", EIKONAL_BINARY, "info", "tiny.pbrt"});
    EXPECT_EQ(run.status, 3);
    EXPECT_EQ(run.error,
              "error: only 0 more threads can be started, and a render needs 6; raise the limit of processes (ulimit -u)\n");
}

/// It has no end.
TEST_F(Cli, ADeviceIsNoScene) {
    std::filesystem::create_symlink("/dev/zero", path("zero.pbrt"));
    const Outcome run = this->run({"info", "zero.pbrt"});
    EXPECT_EQ(run.status, 1);
    EXPECT_EQ(run.error, "zero.pbrt: the file is a device, which may have no end\n");
    write("including.pbrt", "WorldBegin\nInclude \"/dev/zero\"\n");
    EXPECT_THAT(this->run({"info", "including.pbrt"}).error, HasSubstr("including.pbrt:2:9: there is no file \"/dev/zero\""));
}

TEST_F(Cli, NamesOfFilesDoNotReachTheTerminalAsTheyAre) {
    const std::string name = "a\x1b[31m\xff.pbrt";
    write(name, tinyScene());
    const std::vector<std::vector<std::string>> lines{{"info", name},
                                                      {"info", name, "--json"},
                                                      {"render", name, "-o", "b\x1b[31m\xff.exr", "--stats", "--json"},
                                                      {"render", "c\x1b.pbrt"}};
    for (const auto& words : lines) {
        const Outcome run = this->run(words);
        EXPECT_EQ(run.status, words[1] == name ? 0 : 1) << run.error;
        for (const std::string& text : {run.out, run.error}) {
            EXPECT_EQ(text.find('\x1b'), std::string::npos) << text;
            EXPECT_EQ(text.find('\xff'), std::string::npos) << text;
        }
    }
    const auto info = nlohmann::json::parse(run({"info", name, "--json"}).out);
    EXPECT_EQ(info.at("scene"), "a\x1b[31m\xef\xbf\xbd.pbrt") << "U+FFFD";
}

TEST_F(Cli, StrictTurnsWhatIsNotRenderedIntoAnError) {
    write("photons.pbrt", tinyScene("Integrator \"lightpath\""));
    const Outcome lax = run({"info", "photons.pbrt"}), strict = run({"info", "photons.pbrt", "--strict"});
    EXPECT_EQ(lax.status, 0);
    EXPECT_THAT(lax.error, HasSubstr("warning: "));
    EXPECT_EQ(strict.status, 1);
    EXPECT_THAT(strict.error, HasSubstr("--strict"));
}

/// The option counts more than the scene, and then there is nothing to be warned of.
TEST_F(Cli, TheIntegratorMayBeChosen) {
    write("photons.pbrt", tinyScene("Integrator \"lightpath\""));
    const Outcome lax = run({"info", "photons.pbrt"}),
                  chosen = run({"info", "photons.pbrt", "--integrator", "ambientocclusion", "--strict"});
    EXPECT_EQ(lax.error.find("warning: "), lax.error.rfind("warning: ")) << "one warning: " << lax.error;
    EXPECT_EQ(chosen.status, 0);
    EXPECT_EQ(chosen.error, "");
    EXPECT_THAT(chosen.out, HasSubstr("AMBIENT_OCCLUSION"));
    const Outcome unknown = run({"info", "photons.pbrt", "--integrator", "photons"});
    EXPECT_EQ(unknown.status, 2);
    EXPECT_THAT(unknown.error, HasSubstr("--integrator is one of volpath, path, direct, whitted"));
}

}  // namespace
}  // namespace eikonal
