// Parts of an image, by tiles and ranges of samples, make the image of one run.

#include "cli.h"
#include "same_files.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <random>
#include <regex>

namespace eikonal {
namespace {

using testing::HasSubstr;
using Words = std::vector<std::string>;

class Merge : public Cli {
protected:
    Outcome render(Words words) const {
        const Words more{"render", "tiny.pbrt", "--aov", "all,lightgroups", "--fireflies", "reweight"};
        words.insert(words.begin(), more.begin(), more.end());
        return run(words);
    }
    Outcome merge(Words words, const std::string& output, const Words& more = {}) const {
        words.insert(words.begin(), "merge");
        words.insert(words.end(), {"-o", output});
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    }
    /// Renders every combination of tiles and ranges, and returns the names of the parts.
    Words parts(int tiles, const Words& ranges, const Words& settings) const {
        Words names;
        for (int tile = 1; tile <= tiles; ++tile)
            for (const std::string& range : ranges) {
                names.push_back(fmt::format("{}-{}-{}.film", tile, tiles, std::regex_replace(range, std::regex("[:/]"), "-")));
                Words words{"--tile", fmt::format("{}/{}", tile, tiles), "--samples", range, "-o", names.back()};
                words.insert(words.end(), settings.begin(), settings.end());
                EXPECT_EQ(render(words).status, 0);
            }
        return names;
    }
};

TEST_F(Merge, TilesAndRangesOfSamplesAreOneRunInAnyOrder) {
    const Words settings{"--spp", "600"};
    ASSERT_EQ(render({"--spp", "600", "-o", "whole.exr"}).status, 0);
    Words names = parts(2, {"0:48", "48:304", "304:600"}, settings);
    std::shuffle(names.begin(), names.end(), std::mt19937(3));
    const Outcome all = merge(names, "a.exr");
    ASSERT_EQ(all.status, 0) << all.error;
    expectSameFiles(path("whole.exr"), path("a.exr"));
    EXPECT_EQ(readImage(path("a.exr")).metadata.error, readImage(path("whole.exr")).metadata.error);

    /* Equal ranges, whatever the samples */
    names = parts(2, {"1/3", "3/3", "2/3"}, settings);
    ASSERT_EQ(merge(names, "equal.exr").status, 0);
    expectSameFiles(path("whole.exr"), path("equal.exr"));

    /* Merged in two steps */
    ASSERT_EQ(merge({names.begin(), names.begin() + 4}, "first.film").status, 0);
    ASSERT_EQ(merge({names.begin() + 4, names.end()}, "second.film").status, 0);
    ASSERT_EQ(merge({"second.film", "first.film"}, "b.exr").status, 0);
    expectSameFiles(path("whole.exr"), path("b.exr"));

    /* Parts that do not fit are refused by name */
    EXPECT_THAT(merge({names.begin(), names.end() - 1}, "c.exr").error,
                testing::ContainsRegex("no part has samples [0-9]+ to [0-9]+ of pixel"));
    EXPECT_EQ(merge({names.begin(), names.end() - 1}, "c.exr", {"--partial"}).status, 4) << "an image, but not the whole one";
    Words twice = names;
    twice.push_back("first.film");
    EXPECT_THAT(merge(twice, "d.exr").error, testing::ContainsRegex("[a-z0-9-]+.film and [a-z0-9-]+.film both have sample"));
    ASSERT_EQ(render({"--spp", "600", "--tile", "1/2", "--seed", "3", "-o", "foreign.film"}).status, 0);
    const Outcome foreign = merge({names.front(), "foreign.film"}, "d.exr");
    EXPECT_EQ(foreign.status, 1);
    EXPECT_THAT(foreign.error,
                HasSubstr("foreign.film is of another render than " + names.front() + ":\n  seed is \"3\" here and \"0\" in"));
    EXPECT_FALSE(exists("d.exr"));
}

TEST_F(Merge, TilesByCostAreOneRun) {
    ASSERT_EQ(render({"--spp", "64", "-o", "whole.exr"}).status, 0);
    Words names;
    for (const std::string tile : {"1/3", "2/3", "3/3"}) {
        names.push_back("cost" + std::to_string(names.size()) + ".film");
        /* Neither threads nor waves change the division */
        Words words{"--spp", "64", "--tile", tile, "--tiles-by", "cost", "-o", names.back()};
        if (tile == "2/3") words.insert(words.end(), {"--nthreads", "1", "--wave-paths", "1024"});
        const Outcome part = render(words);
        ASSERT_EQ(part.status, 0) << part.error;
    }
    const Outcome merged = merge(names, "merged.exr");
    ASSERT_EQ(merged.status, 0) << merged.error;
    expectSameFiles(path("whole.exr"), path("merged.exr"));
    EXPECT_THAT(render({"--tiles-by", "cost", "-o", "a.exr"}).error, HasSubstr("say how many: --tile 1/8"));
}

/// A part is a checkpoint, too: it is resumed like one.
TEST_F(Merge, APartGoesOn) {
    ASSERT_EQ(render({"--spp", "6000", "-o", "whole.exr"}).status, 0);
    const Words second{"--spp", "6000", "--samples", "2048:6000", "-o", "b.film", "--resume"};
    Words interrupted = second;
    interrupted.insert(interrupted.end(), {"--time-limit", "0.05"});
    ASSERT_EQ(render({"--spp", "6000", "--samples", "0:2048", "-o", "a.film"}).status, 0);
    ASSERT_EQ(render(interrupted).status, 4);
    EXPECT_EQ(merge({"a.film", "b.film"}, "a.exr").status, 1) << "samples are missing";
    ASSERT_EQ(render(second).status, 0);
    ASSERT_EQ(merge({"a.film", "b.film"}, "a.exr").status, 0);
    expectSameFiles(path("whole.exr"), path("a.exr"));
}

TEST_F(Merge, WhatCannotJoinIsRefusedBeforeItIsRendered) {
    EXPECT_THAT(render({"--spp", "64", "--samples", "3:16", "-o", "a.film"}).error, HasSubstr("begin at a multiple of"));
    EXPECT_THAT(render({"--spp", "64", "--samples", "0:7", "-o", "a.film"}).error, HasSubstr("end at a multiple of"));
    EXPECT_THAT(render({"--spp", "64", "--samples", "0:128", "-o", "a.film"}).error, HasSubstr("give more with --spp"));
    EXPECT_THAT(render({"--spp", "40", "--samples", "1/4", "-o", "a.film"}).error, HasSubstr("at most 3 parts, not 4"));
    EXPECT_THAT(render({"--tile", "1/13", "-o", "a.film"}).error, HasSubstr("the image has 12 rows"));
    EXPECT_THAT(render({"--tile", "1/2"}).error, HasSubstr("keep it: -o part.film"));
    EXPECT_THAT(render({"--tile", "1/2", "--max-error", "5%", "-o", "a.film"}).error, HasSubstr("neither --samples nor --tile"));
}

}  // namespace
}  // namespace eikonal
