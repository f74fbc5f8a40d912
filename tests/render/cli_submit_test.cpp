// Jobs for render farms, as they are written. tests/farm runs them.

#include "cli.h"
#include "test_paths.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>

namespace eikonal {
namespace {

using testing::HasSubstr;
using Words = std::vector<std::string>;
namespace fs = std::filesystem;

std::string contentOf(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

class Submit : public Cli {
protected:
    Outcome submit(const std::string& engine, Words words) const {
        const Words more{"submit", "tiny.pbrt", "--engine", engine};
        words.insert(words.begin(), more.begin(), more.end());
        return run(words, {{"PATH", path("nothing") + ":/usr/bin:/bin"}});
    }
};

/// What is written are the files of farm/ and the settings that they read.
TEST_F(Submit, WritesTheFilesOfTheFarmWordForWord) {
    for (const std::string engine : {"slurm", "openjd", "kubernetes"}) {
        const Outcome done = submit(engine, {"--dry-run", "--tiles", "3", "--spp", "64", "--sample-ranges", "2", "-o", "a.exr"});
        ASSERT_EQ(done.status, 0) << done.error;
        EXPECT_THAT(done.out, HasSubstr("6 parts, 3 tiles x 2 ranges of samples"));
        EXPECT_THAT(done.out, HasSubstr("nothing is handed over (--dry-run)"));
        for (const auto& file : fs::directory_iterator(EIKONAL_SOURCE_DIR "/farm/" + engine))
            EXPECT_EQ(contentOf(path("tiny-" + engine + "/" + file.path().filename().string())), contentOf(file.path().string()));
        EXPECT_NE(fs::status(path("tiny-" + engine + "/submit.sh")).permissions() & fs::perms::owner_exec, fs::perms::none);
    }
    EXPECT_THAT(contentOf(path("tiny-slurm/job.env")), HasSubstr("RENDER_OPTIONS=(--spp=64)\nIMAGE_OPTIONS=(-o " + path("a.exr") + ")\n"));
    EXPECT_THAT(contentOf(path("tiny-kubernetes/job.env")), HasSubstr("EIKONAL=eikonal\n"));
}

/// Each option goes to what has it, through two shells unharmed.
TEST_F(Submit, OptionsReachThePartsOrTheMerge) {
    const Words words{
        "--dry-run", "--folder", "it's a job", "--aov", "depth",   "--checkpoint-every", "90s", "--build-options=-D X='1'", "--tonemap",
        "filmic",    "-o",       "a b.exr",    "-o",    "all.film"};
    ASSERT_EQ(submit("slurm", words).status, 0);
    const std::string environment = contentOf(path("it's a job/job.env"));
    EXPECT_THAT(environment, HasSubstr("RENDER_OPTIONS=(--aov=depth --checkpoint-every=90s '--build-options=-D X='\\''1'\\''')\n"));
    EXPECT_THAT(environment, HasSubstr("IMAGE_OPTIONS=(-o '" + path("a b.exr") + "' -o " + path("all.film") + " --tonemap=filmic)\n"));
    Words other = words;
    other[2] = "other";
    ASSERT_EQ(submit("openjd", other).status, 0);
    const auto parameters = nlohmann::json::parse(contentOf(path("other/parameters.json")));
    EXPECT_EQ(parameters["Image"], path("a b.exr"));
    EXPECT_EQ(parameters["ImageOptions"], "-o " + path("all.film") + " --tonemap=filmic");
    EXPECT_EQ(parameters["RenderOptions"], "--aov=depth --checkpoint-every=90s '--build-options=-D X='\\''1'\\'''");
}

/// Of an animation, tasks have frames.
TEST_F(Submit, AnimationsAreTasksOfFrames) {
    const Words words{"--dry-run", "--frames", "0-4,9", "--fps", "24", "--frames-per-task", "4", "--spp", "64", "-o", "f.####.exr"};
    for (const std::string engine : {"slurm", "openjd", "kubernetes"}) {
        const Outcome done = submit(engine, words);
        ASSERT_EQ(done.status, 0) << done.error;
        EXPECT_THAT(done.out, HasSubstr("6 frames, in 2 tasks"));
    }
    EXPECT_THAT(contentOf(path("tiny-slurm/job.env")), HasSubstr("RENDER_OPTIONS=(--spp=64 --fps=24)\nIMAGE_OPTIONS=(-o '" +
                                                                 path("f.####.exr") + "')\nTILES=1\nRANGES=1\nFRAMES=(0-3 4,9)\n"));
    EXPECT_THAT(contentOf(path("tiny-kubernetes/kustomization.yaml")), HasSubstr("path: /spec/completions, value: 2}"));
    const auto animation = nlohmann::json::parse(contentOf(path("tiny-openjd/animation.json")));
    EXPECT_EQ(animation["Frames"], "0-4,9");
    EXPECT_EQ(animation["FramesPerTask"], 4);
    EXPECT_EQ(animation["Options"], "--spp=64 --fps=24 -o '" + path("f.####.exr") + "'");

    EXPECT_THAT(submit("slurm", {"--dry-run", "--frames", "1-4", "--tiles", "2", "-o", "a.##.exr"}).error, HasSubstr("are its frames"));
    EXPECT_THAT(submit("slurm", {"--dry-run", "--frames", "1-4", "--fps", "24"}).error, HasSubstr("-o image.####.exr"));
    EXPECT_THAT(submit("slurm", {"--dry-run", "--frames", "1-4", "--fps", "24", "-o", "a.exr"}).error, HasSubstr("there are 4 frames"));
    EXPECT_THAT(submit("slurm", {"--dry-run", "--frames-per-task", "4"}).error, HasSubstr("say which: --frames 1-48"));
    EXPECT_THAT(submit("slurm", {"--dry-run", "--frames", "1-4", "--fps", "24", "-o", "none/a.##.exr"}).error, HasSubstr("no folder"));
    write("s.01.pbrt", tinyScene());
    const Outcome missing = run({"submit", "s.##.pbrt", "--engine", "slurm", "--dry-run", "--frames", "1-3", "-o", "a.##.exr"});
    EXPECT_EQ(missing.status, 1);
    EXPECT_THAT(missing.error, HasSubstr("s.##.pbrt has no file for frames 2-3"));
}

TEST_F(Submit, WhatCannotRunIsRefusedBeforeItIsWritten) {
    const Outcome absent = run({"submit", "tiny.pbrt", "--engine", "slurm"}, {{"PATH", path("nothing")}});
    EXPECT_EQ(absent.status, 1);
    EXPECT_THAT(absent.error, HasSubstr("error: sbatch is not installed here"));
    EXPECT_THAT(absent.error, HasSubstr("slurm-client; or add --dry-run"));
    EXPECT_THAT(run({"submit", "tiny.pbrt"}).error, HasSubstr("--engine slurm, openjd or kubernetes"));
    EXPECT_THAT(submit("slrum", {}).error, HasSubstr("did you mean slurm?"));
    EXPECT_THAT(submit("slurm", {"--dry-run", "--tiles", "13"}).error, HasSubstr("the image has 12 rows"));
    EXPECT_THAT(submit("slurm", {"--dry-run", "--spp", "40", "--sample-ranges", "4"}).error, HasSubstr("at most 3 ranges, not 4"));
    EXPECT_THAT(submit("slurm", {"--dry-run", "--max-error", "5%"}).error, HasSubstr("submit has no option --max-error"));
    write("wrong.pbrt", "WorldBegin Sphere");
    EXPECT_THAT(run({"submit", "wrong.pbrt", "--engine", "slurm", "--dry-run"}).error, HasSubstr("wrong.pbrt:1:12"));
    EXPECT_FALSE(exists("tiny-slurm"));

    /* The parts of another job may still need its files */
    ASSERT_EQ(submit("slurm", {"--dry-run"}).status, 0);
    EXPECT_EQ(submit("slurm", {"--dry-run"}).status, 0) << "the same job once more";
    EXPECT_THAT(submit("slurm", {"--dry-run", "--seed", "3"}).error, HasSubstr("job.env: is of another job"));
}

}  // namespace
}  // namespace eikonal
