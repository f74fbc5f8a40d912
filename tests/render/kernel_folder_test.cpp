// Where the program finds its kernels: wherever they are installed, whatever the folder is called, and none of another version.

#include "run_program.h"
#include "test_paths.h"

#include <gmock/gmock.h>

#include <sys/wait.h>

#include <cstdlib>

namespace eikonal {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

class KernelFolder : public ProgramTest {
protected:
    KernelFolder() {
        write("tiny.pbrt", tinyScene());
        fs::create_directories(root_);
        fs::copy(EIKONAL_SOURCE_DIR "/kernels", root_ / "kernels", fs::copy_options::recursive);
        fs::copy(EIKONAL_SOURCE_DIR "/include", root_ / "include", fs::copy_options::recursive);
    }
    Environment own() const { return {{"EIKONAL_KERNELS", root_.string()}}; }
    void append(const fs::path& file, const std::string& text) const { std::ofstream(file, std::ios::app) << text; }

    fs::path root_ = folder_ / "My Projects; \"größer\" & 'more'";
};

TEST_F(KernelFolder, MayHaveAnyName) {
    /* One stage compiled anew, into a cache with such a name as well; all of them from the cache of tests */
    Environment environment = own();
    environment["EIKONAL_CACHE_DIR"] = (root_ / "my cache").string();
    const Outcome compiled = run({"compile-kernels", "0", "0", "0", "100"}, environment);
    EXPECT_EQ(compiled.status, 0) << compiled.error;
    EXPECT_THAT(run({"cache"}, environment).out, HasSubstr("\n1 compiled kernels"));
    const Outcome rendered = run({"render", "tiny.pbrt", "-o", "a.exr"}, own());
    EXPECT_EQ(rendered.status, 0) << rendered.error;
}

TEST_F(KernelFolder, IsNamedWithFileAndLineIfAKernelIsWrong) {
    append(root_ / "kernels" / "film" / "pixel.clh", "#error this is the last line\n");
    std::ifstream file(root_ / "kernels" / "film" / "pixel.clh");
    const auto lines = std::count(std::istreambuf_iterator<char>(file), {}, '\n');
    const Outcome run = this->run({"compile-kernels", "0", "0", "0", "100"}, own());
    EXPECT_EQ(run.status, 3);
    EXPECT_THAT(run.error, AllOf(HasSubstr("film/pixel.clh:" + std::to_string(lines) + ":"), HasSubstr("this is the last line"),
                                 HasSubstr(root_.string())));
}

TEST_F(KernelFolder, MustHoldTheHeadersThatTheProgramWasBuiltWith) {
    append(root_ / "include" / "eikonal" / "lights.h", "/* of another version */\n");
    const Outcome run = this->run({"render", "tiny.pbrt"}, own());
    EXPECT_EQ(run.status, 3);
    EXPECT_THAT(run.error, AllOf(HasSubstr("eikonal/lights.h is not the one that this program was built with"), HasSubstr(root_.string())));
}

TEST_F(KernelFolder, MayBeReadAsTheCompilerGetsIt) {
    const Outcome dumped = run({"render", "tiny.pbrt", "--dump-kernels", "dump"}, own());
    ASSERT_EQ(dumped.status, 0) << dumped.error;
    int files = 0;
    for (const auto& file : fs::directory_iterator(path("dump"))) {
        const std::string text = read(file.path());
        EXPECT_THAT(text, AllOf(testing::StartsWith("/* options: -cl-std=CL1.2 "), HasSubstr("#line 1 \"eikonal/portable.h\"")))
            << file.path();
        EXPECT_EQ(text.find("#include \""), std::string::npos) << file.path();
        ++files;
    }
    EXPECT_GE(files, 5);
    const Outcome refused = run({"render", "tiny.pbrt", "--dump-kernels", "/proc/no/such/place"});
    EXPECT_EQ(refused.status, 1);
    EXPECT_THAT(refused.error, AllOf(testing::StartsWith("error: cannot write /proc/no/such/place/"), HasSubstr("--dump-kernels")));
}

/// What a package would hold is enough.
class Installation : public ProgramTest {
protected:
    Installation() {
        write("tiny.pbrt", tinyScene());
        const std::string command = "cmake --install '" + fs::path(EIKONAL_BINARY).parent_path().string() + "' --prefix '" +
                                    prefix_.string() + "' > '" + path("log") + "' 2>&1";
        const int status = std::system(command.c_str());
        EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << read(path("log"));
        program_ = prefix_ / "bin" / "eikonal";
    }
    fs::path prefix_ = folder_ / "a prefix";
};

TEST_F(Installation, RendersWithItsOwnKernels) {
    const Outcome rendered = run({"render", "tiny.pbrt", "-o", "a.exr"});
    ASSERT_EQ(rendered.status, 0) << rendered.error;
    EXPECT_TRUE(fs::exists(path("a.exr")) && fs::exists(path("a.png")));
    EXPECT_TRUE(fs::exists(prefix_ / "share" / "eikonal" / "scenes" / "cornell-box.pbrt"));

    /* With one of them gone, the source tree's do not take its place */
    const fs::path kernels = prefix_ / "share" / "eikonal" / "kernels";
    fs::remove(kernels / "trace/bvh.clh");
    const Outcome run = this->run({"render", "tiny.pbrt"});
    EXPECT_EQ(run.status, 3);
    EXPECT_THAT(run.error, AllOf(HasSubstr("\"trace/bvh.clh\""), HasSubstr(kernels.string())));
}

}  // namespace
}  // namespace eikonal
