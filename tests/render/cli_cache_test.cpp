// The cache of kernels: used, damaged, cleared, and without a place.

#include "cli.h"

#include "bvh/build.h"
#include "feature_set.h"
#include "pack/scene_constants.h"
#include "test_paths.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>

#include <sys/mount.h>

namespace eikonal {
namespace {

using testing::HasSubstr;

TEST_F(Cli, TheCacheIsWarmedUsedDamagedAndCleared) {
    const Environment own{{"EIKONAL_CACHE_DIR", path("cache")}};
    EXPECT_THAT(run({"cache"}, own).out, HasSubstr("0 compiled kernels"));
    const Outcome warm = run({"cache", "--warm", "tiny.pbrt"}, own);
    EXPECT_EQ(warm.status, 0) << warm.error;
    EXPECT_THAT(warm.out, testing::ContainsRegex("tiny.pbrt: [0-9]+ kernels"));
    EXPECT_THAT(run({"render", "tiny.pbrt", "--stats"}, own).out, HasSubstr("0 compiled, "));

    for (const auto& file : std::filesystem::directory_iterator(path("cache")))
        if (file.path().extension() == ".program") std::filesystem::resize_file(file.path(), file.file_size() / 2);
    const Outcome damaged = run({"render", "tiny.pbrt", "--stats"}, own);
    EXPECT_EQ(damaged.status, 0) << damaged.error;
    EXPECT_THAT(damaged.out, HasSubstr(", 0 from the cache"));

    EXPECT_THAT(run({"cache", "--clear"}, own).out, testing::ContainsRegex("removed [1-9][0-9]* compiled kernels"));
    EXPECT_THAT(run({"cache"}, own).out, HasSubstr("0 compiled kernels"));
}

/// PoCL aborts the program if one of its own files is damaged: none that outlives a run is ever given to it.
TEST_F(Cli, NoDamageToTheCacheEndsTheProgram) {
    const Environment own{{"EIKONAL_CACHE_DIR", path("cache")}};
    const std::vector<std::string> compileOne{"compile-kernels", "0", "0", "0", "100"};
    const auto damage = [](const std::filesystem::path& file, int how) {
        if (how < 2) return std::filesystem::resize_file(file, how * std::filesystem::file_size(file) / 2);
        std::ofstream(file, std::ios::in | std::ios::out | std::ios::binary).seekp(40)
            << "random bytes: \x91\x02\xf7\x5c\xa8\x33\xd0\x6e\x1b\x84";
    };
    ASSERT_EQ(run(compileOne, own).status, 0);
    const std::vector<std::pair<std::string, int>> kinds{{".so", 0}, {".so", 1}, {".so", 2},     {".bc", 0},
                                                         {".bc", 1}, {".bc", 2}, {".program", 2}};
    for (const auto& [kind, how] : kinds) {
        for (const auto& file : std::filesystem::recursive_directory_iterator(path("cache")))
            if (file.path().extension() == kind) damage(file.path(), how);
        const Outcome damaged = run(compileOne, own);
        EXPECT_EQ(damaged.status, 0) << kind << " " << how << ": " << damaged.error;
    }
    EXPECT_EQ(std::distance(std::filesystem::recursive_directory_iterator(path("cache")), {}), 1) << "the program and nothing else";
}

TEST_F(Cli, AWorkerCompilesEveryKernelThatASceneNeeds) {
    std::string bits(featureCount(), '0');
    const auto info = nlohmann::json::parse(run({"info", "tiny.pbrt", "--json"}).out);
    for (const auto& feature : info.at("features"))
        bits.at(static_cast<size_t>(featureNamed(feature.at("name")))) = '1';
    const Environment own{{"EIKONAL_CACHE_DIR", path("cache")}};
    const std::string constants = SceneConstants{.interleavedRays = interleavedRays(1)}.text();
    EXPECT_EQ(run({"compile-kernels", bits, constants, "0", "1"}, own).status, 0);
    EXPECT_THAT(run({"render", "tiny.pbrt", "--stats"}, own).out, HasSubstr(" 0 compiled, "));
}

/// What is kept in the folder of temporary files instead, is kept there for the next test as well.
static std::string temporaryFiles() {
    const std::filesystem::path folder = std::filesystem::path(EIKONAL_BINARY).parent_path() / "test-cache" / "temporary";
    std::filesystem::create_directories(folder);
    return folder.string();
}

TEST_F(Cli, ACacheThatCannotBeWrittenIsNoError) {
    const Outcome run = this->run({"render", "tiny.pbrt"}, {{"EIKONAL_CACHE_DIR", "/proc/no/such/place"}, {"TMPDIR", temporaryFiles()}});
    EXPECT_EQ(run.status, 0) << run.error;
    EXPECT_THAT(run.error, testing::ContainsRegex("warning: compiled kernels are kept in .*: /proc/no/such/place cannot be written"));
}

/// A disk of 200 KiB.
class TinyDisk : public Cli {
protected:
    TinyDisk() {
        std::filesystem::create_directory(disk_);
        mounted_ = ::mount("none", disk_.c_str(), "tmpfs", 0, "size=200k") == 0;
    }
    ~TinyDisk() override { if (mounted_) ::umount(disk_.c_str()); }
    const std::string disk_ = path("disk");
    bool mounted_ = false;
};

TEST_F(TinyDisk, IsNoPlaceForTheCache) {
    if (!mounted_) GTEST_SKIP() << "only root can make a disk";
    const Outcome run = this->run({"render", "tiny.pbrt"}, {{"EIKONAL_CACHE_DIR", disk_}, {"TMPDIR", temporaryFiles()}});
    EXPECT_EQ(run.status, 0) << run.error;
    EXPECT_THAT(run.error, testing::ContainsRegex("warning: compiled kernels are kept in .*: " + disk_ +
                                                  " is on a disk with 0\\.[0-9] MiB free; at least 16 MiB are needed"));
    EXPECT_TRUE(std::filesystem::is_empty(disk_));
}

}  // namespace
}  // namespace eikonal
