// More files are read in turns than a process may open.

#include "film/reopened_file.h"
#include "unit/temporary_folder.h"

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <cerrno>
#include <filesystem>
#include <memory>
#include <vector>

namespace eikonal {
namespace {

class Reopened : public TemporaryFolder {
protected:
    Reopened() {
        ::getrlimit(RLIMIT_NOFILE, &before_);
        struct rlimit few = before_;
        few.rlim_cur = 64;
        ::setrlimit(RLIMIT_NOFILE, &few);
    }
    ~Reopened() override { ::setrlimit(RLIMIT_NOFILE, &before_); }
    struct rlimit before_ {};
};

TEST_F(Reopened, MoreFilesThanAProcessMayOpen) {
    std::vector<std::unique_ptr<ReopenedFile>> files;
    for (int i = 0; i < 200; ++i) files.push_back(std::make_unique<ReopenedFile>(write(std::to_string(i), std::to_string(1000 + i))));
    for (int round = 0; round < 3; ++round)
        for (int i = 0; i < 200; ++i) {
            char text[4];
            ASSERT_TRUE(files[i]->isOpen()) << i;
            ASSERT_EQ(files[i]->read(text, 4, 0), 4) << i;
            EXPECT_EQ(std::string(text, 4), std::to_string(1000 + i));
        }
}

/// What was read of one file does not go with what is read of another.
TEST_F(Reopened, AFileThatWasReplacedIsNoticed) {
    const ReopenedFile first(write("first", "one"));
    std::vector<std::unique_ptr<ReopenedFile>> others;
    for (int i = 0; i < 100; ++i) others.push_back(std::make_unique<ReopenedFile>(write("other" + std::to_string(i), "x")));
    std::filesystem::rename(write("second", "two"), path("first"));
    char text[3];
    EXPECT_EQ(first.read(text, 3, 0), -1);
    EXPECT_EQ(errno, ESTALE);
}

TEST_F(Reopened, AMissingFileIsNotOpen) {
    const ReopenedFile missing(path("missing"));
    EXPECT_FALSE(missing.isOpen());
}

}  // namespace
}  // namespace eikonal
