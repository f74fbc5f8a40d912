// Light paths from outside: parts and checkpoints keep what they add, and the program says where they are.

#include "cli.h"
#include "same_files.h"

#include <gmock/gmock.h>

namespace eikonal {
namespace {

using testing::HasSubstr;
using Words = std::vector<std::string>;

class CliLightPaths : public Cli {
protected:
    CliLightPaths() {
        write("ball.pbrt", R"(LookAt 0 3 -5  0 .3 0  0 1 0 Camera "perspective" "float fov" 40
            Film "rgb" "integer xresolution" 20 "integer yresolution" 16 Sampler "zsobol" "integer pixelsamples" 64
            Integrator "bdpt" "integer maxdepth" 8
            WorldBegin
            LightSource "point" "rgb I" [12 12 12] "point3 from" [1.5 3 1]
            Material "diffuse" Shape "bilinearmesh" "point3 P" [-3 0 -3  3 0 -3  -3 0 3  3 0 3]
            AttributeBegin Translate 0 .8 0 Material "dielectric" Shape "sphere" "float radius" .6 AttributeEnd)");
    }
};

/// With another integrator than the scene's.
class CliLightPathsOf : public CliLightPaths, public testing::WithParamInterface<const char*> {
protected:
    Outcome render(Words words) const {
        words.insert(words.begin(), {"render", "ball.pbrt", "--integrator", GetParam(), "--aov", "passes"});
        return run(words);
    }
};

TEST_P(CliLightPathsOf, TilesAndRangesOfSamplesAreOneRun) {
    ASSERT_EQ(render({"-o", "whole.exr"}).status, 0);
    Words parts;
    for (const char* tile : {"1/2", "2/2"})
        for (const char* range : {"0:16", "16:48", "48:64"}) {
            parts.push_back("part" + std::to_string(parts.size()) + ".film");
            const Outcome run = render({"--tile", tile, "--samples", range, "-o", parts.back()});
            ASSERT_EQ(run.status, 0) << run.error;
        }
    Words merge{"merge", "-o", "merged.exr"};
    merge.insert(merge.end(), parts.rbegin(), parts.rend());
    const Outcome merged = run(merge);
    ASSERT_EQ(merged.status, 0) << merged.error;
    expectSameFiles(path("whole.exr"), path("merged.exr"));

    /* In two steps */
    ASSERT_EQ(run({"merge", parts[0], parts[4], parts[1], "-o", "a.film"}).status, 0);
    ASSERT_EQ(run({"merge", parts[3], parts[2], parts[5], "-o", "b.film"}).status, 0);
    ASSERT_EQ(run({"merge", "b.film", "a.film", "-o", "again.exr"}).status, 0);
    expectSameFiles(path("whole.exr"), path("again.exr"));
}

/// A render that ends early and goes on has the image of one run, whichever threads there are.
TEST_P(CliLightPathsOf, CheckpointsHoldWhatLightPathsHaveAdded) {
    ASSERT_EQ(render({"-o", "whole.exr", "--nthreads", "1"}).status, 0);
    const Outcome first = render({"-o", "early.exr", "--checkpoint", "c.film", "--samples", "0:32"});
    ASSERT_EQ(first.status, 0) << first.error;
    const Outcome second = render({"-o", "resumed.exr", "--checkpoint", "c.film", "--resume", "--samples", "0:64"});
    ASSERT_EQ(second.status, 0) << second.error;
    expectSameFiles(path("whole.exr"), path("resumed.exr"));
}

TEST_P(CliLightPathsOf, AreMeasuredByStage) {
    const Outcome bench = run({"bench", "ball.pbrt", "--spp", "2", "--repeats", "1", "--integrator", GetParam()});
    EXPECT_EQ(bench.status, 0) << bench.error;
    std::vector<const char*> stages{"generate_light_rays", "route_light_paths", "shade_light_hits diffuse", "splat_shadows"};
    if (std::string(GetParam()) == "sppm")
        stages.insert(stages.end(),
                      {"store_vertices diffuse", "count_vertices", "place_vertices", "order_vertices", "merge_vertices diffuse"});
    for (const char* stage : stages)
        EXPECT_THAT(bench.out, HasSubstr(stage));
    const Outcome loop = run({"bench", "ball.pbrt", "--loop"});
    EXPECT_EQ(loop.status, 2);
    EXPECT_THAT(loop.error, HasSubstr("--loop"));
}

INSTANTIATE_TEST_SUITE_P(With, CliLightPathsOf, testing::Values("bdpt", "sppm"));

// A light path hits no centre of a pixel, where all samples of this film are, and hardly a filter that is much narrower than a pixel. What
// it would bring is left to paths from the camera.
TEST_F(CliLightPaths, AreLeftOutWhereNoneHitsASample) {
    const std::string rest = R"( LookAt 0 3 -5  0 .3 0  0 1 0 Camera "perspective" "float fov" 40
        Film "rgb" "integer xresolution" 16 "integer yresolution" 16 Sampler "zsobol" "integer pixelsamples" 16
        WorldBegin LightSource "point" "rgb I" [12 12 12] "point3 from" [1.5 3 1]
        Material "diffuse" Shape "bilinearmesh" "point3 P" [-3 0 -3  3 0 -3  -3 0 3  3 0 3])";
    for (const auto& [integrator, narrow] : {std::pair("bdpt", "Option \"disablepixeljitter\" true"),
                                             {"vcm", "Option \"disablepixeljitter\" true"},
                                             {"sppm", "PixelFilter \"gaussian\" \"float xradius\" 1e-4 \"float yradius\" .5"}}) {
        write("floor.pbrt", narrow + rest);
        const Outcome both = run({"render", "floor.pbrt", "--integrator", integrator, "-o", "both.exr"});
        EXPECT_EQ(both.status, 0) << both.error;
        EXPECT_THAT(both.error, HasSubstr("its filter is so narrow that light paths hardly hit what pixels show"));
        ASSERT_EQ(run({"render", "floor.pbrt", "--integrator", "volpath", "-o", "usual.exr"}).status, 0);
        EXPECT_EQ(readImage(path("both.exr")).image.color, readImage(path("usual.exr")).image.color) << integrator;
    }
}

TEST_F(CliLightPaths, AreNamed) {
    const Outcome info = run({"info", "ball.pbrt"});
    EXPECT_THAT(info.out, HasSubstr("LIGHT_PATHS"));
    EXPECT_THAT(info.out, HasSubstr("where they are seen by way of smooth ones, too"));
    const Outcome camera = run({"info", "ball.pbrt", "--integrator", "volpath"});
    EXPECT_THAT(camera.out, testing::Not(HasSubstr("LIGHT_PATHS")));
    const Outcome chosen = run({"info", "tiny.pbrt", "--integrator", "bdpt"});
    EXPECT_EQ(chosen.status, 0) << chosen.error;
    EXPECT_THAT(chosen.out, HasSubstr("LIGHT_PATHS"));
    const Outcome merged = run({"info", "ball.pbrt", "--integrator", "sppm"});
    EXPECT_THAT(merged.out, HasSubstr("MERGING"));
    EXPECT_THAT(merged.out, HasSubstr("light vertices"));
    EXPECT_THAT(merged.out, testing::Not(HasSubstr("hard light")));
}

}  // namespace
}  // namespace eikonal
