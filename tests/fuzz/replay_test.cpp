// Every file that fuzzing began with or has found: none of them takes long, or much memory, or ends in anything but an Error.

#include "targets.h"

#include "test_paths.h"

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

namespace eikonal::fuzz {
namespace {

namespace fs = std::filesystem;

double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// The most memory that this process has had.
double peakMegabytes() {
    struct rusage usage {};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

class FuzzReplay : public testing::TestWithParam<Target> {};

TEST_P(FuzzReplay, EveryFileHasAnAnswer) {
    const Target& target = GetParam();
    std::vector<fs::path> files;
    for (const char* kind : {"corpus", "findings"})
        if (const fs::path folder = fs::path(EIKONAL_SOURCE_DIR) / "tests/fuzz" / kind / target.name; fs::is_directory(folder))
            for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
    std::ranges::sort(files);
    ASSERT_FALSE(files.empty()) << "no file to begin with";
    const double before = peakMegabytes();
    for (const fs::path& file : files) {
        SCOPED_TRACE(file.string());
        std::ifstream stream(file, std::ios::binary);
        const std::string input(std::istreambuf_iterator<char>(stream), {});
        const double start = processorSeconds();
        try {
            target.run(input);
        } catch (const std::exception& error) {
            ADD_FAILURE() << "an exception that is no Error: " << error.what();
        }
        EXPECT_LT(processorSeconds() - start, 2) << "seconds of the processor";
        ASSERT_LT(peakMegabytes() - before, 1024) << "MB";
    }
}

INSTANTIATE_TEST_SUITE_P(All, FuzzReplay, testing::ValuesIn(targets().begin(), targets().end()),
                         [](const auto& target) { return std::string(target.param.name); });

}  // namespace
}  // namespace eikonal::fuzz
