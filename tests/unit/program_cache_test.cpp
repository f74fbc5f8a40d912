// The folder in which compiled kernels are kept.

#include "device/cache.h"
#include "device/private_folder.h"

#include "unit/temporary_folder.h"

#include <sys/stat.h>

#include <cstdlib>
#include <map>
#include <optional>

namespace eikonal {
namespace {

namespace fs = std::filesystem;

/// Sets variables of the environment, and puts back what was there.
class WithEnvironment : public TemporaryFolder {
protected:
    void set(const std::string& name, const std::string& value) {
        const char* before = std::getenv(name.c_str());
        if (!saved_.count(name)) saved_[name] = before ? std::optional<std::string>(before) : std::nullopt;
        ::setenv(name.c_str(), value.c_str(), 1);
    }
    ~WithEnvironment() override {
        for (const auto& [name, value] : saved_) value ? ::setenv(name.c_str(), value->c_str(), 1) : ::unsetenv(name.c_str());
    }

private:
    std::map<std::string, std::optional<std::string>> saved_;
};

class CacheFolder : public WithEnvironment {
protected:
    /// Nothing but the folder of temporary files can be written.
    CacheFolder() {
        set("EIKONAL_CACHE_DIR", "/proc/no/such/place");
        set("TMPDIR", folder_.string());
        shared_ = path("eikonal-" + std::to_string(::geteuid()));
    }
    std::string shared_;   ///< the shared folder, whose name is predictable
};

TEST_F(CacheFolder, AmongTemporaryFilesIsForItsUserAlone) {
    EXPECT_EQ(ProgramCache::defaultFolder(), shared_);
    EXPECT_EQ(fs::status(shared_).permissions(), fs::perms::owner_all);
    EXPECT_EQ(ProgramCache::defaultFolder(), shared_) << "it may be there already";
}

TEST_F(CacheFolder, IsNotUsedIfOthersMayWriteToIt) {
    fs::create_directory(shared_);
    for (const mode_t mode : {0777, 0770, 0702}) {
        ASSERT_EQ(::chmod(shared_.c_str(), mode), 0);
        EXPECT_EQ(ProgramCache::defaultFolder(), "") << std::oct << mode;
    }
    ASSERT_EQ(::chmod(shared_.c_str(), 0755), 0);
    EXPECT_EQ(ProgramCache::defaultFolder(), shared_);
}

TEST_F(CacheFolder, IsNotUsedIfItIsALinkOrSomeoneElses) {
    fs::create_directory(path("elsewhere"));
    fs::create_directory_symlink(path("elsewhere"), shared_);
    EXPECT_EQ(ProgramCache::defaultFolder(), "");
    fs::remove(shared_);
    if (::geteuid() != 0) GTEST_SKIP() << "only root can give a folder away";
    fs::create_directory(shared_);
    ASSERT_EQ(::chown(shared_.c_str(), 12345, 12345), 0);
    EXPECT_EQ(ProgramCache::defaultFolder(), "");
}

TEST_F(CacheFolder, IsClearedOfWhatWasNeverFinished) {
    const ProgramCache cache(folder_.string());
    cache.store("a key", {{1, 2, 3}, {"argument"}, 0.5});
    const auto kept = cache.load("a key");
    ASSERT_TRUE(kept);
    EXPECT_EQ(kept->binary, (std::vector<unsigned char>{1, 2, 3}));
    EXPECT_EQ(kept->arguments, std::vector<std::string>{"argument"});
    EXPECT_EQ(kept->seconds, 0.5);
    write("0123456789abcdef.program.42.4711", "half of it");
    write("a note", "not ours");
    EXPECT_EQ(cache.clear(), 1);
    EXPECT_FALSE(cache.load("a key"));
    EXPECT_FALSE(fs::exists(path("0123456789abcdef.program.42.4711")));
    EXPECT_TRUE(fs::exists(path("a note")));
}

using PrivateFolders = TemporaryFolder;

TEST_F(PrivateFolders, GoWithTheirObjectAndNotBefore) {
    std::string where;
    {
        const PrivateFolder one(folder_.string()), two(folder_.string());
        where = one.path();
        EXPECT_TRUE(fs::is_directory(one.path())) << "the second is not to take it for one that was left";
        EXPECT_EQ(fs::status(one.path()).permissions(), fs::perms::owner_all);
        EXPECT_NE(one.path(), two.path());
        std::ofstream(one.path() + "/file") << "content";
    }
    EXPECT_TRUE(fs::is_empty(folder_)) << where;
    EXPECT_EQ(PrivateFolder(path("not there")).path(), "");
}

TEST_F(PrivateFolders, ThatWereLeftAreRemovedByTheNext) {
    fs::create_directory(path("eikonal-pocl-abcdef"));
    std::ofstream(path("eikonal-pocl-abcdef/file")) << "content";
    fs::create_directory(path("something else"));
    const PrivateFolder next(folder_.string());
    EXPECT_FALSE(fs::exists(path("eikonal-pocl-abcdef")));
    EXPECT_TRUE(fs::exists(path("something else")));
}

}  // namespace
}  // namespace eikonal
