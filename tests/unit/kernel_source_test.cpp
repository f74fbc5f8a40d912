// Kernels and all that they include become one text, whose errors still name our files and lines.

#include "device/source.h"

#include "error.h"
#include "unit/temporary_folder.h"

#include <gmock/gmock.h>

namespace eikonal {
namespace {

using testing::HasSubstr;
using testing::Not;

class KernelSources : public TemporaryFolder {
protected:
    KernelSources() {
        std::filesystem::create_directories(folder_ / "kernels");
        std::filesystem::create_directories(folder_ / "include" / "eikonal");
    }
    KernelSource source(const std::string& text) const {
        KernelFiles files({path("kernels"), path("include")});
        return {files, text};
    }
};

// A file without an include guard comes each time.
TEST_F(KernelSources, TakeInEachGuardedFileOnceWhereItIsFirstIncluded) {
    write("kernels/a.cl", "first\n#include \"b.clh\"\n  #include \"eikonal/c.h\"  /* why */\nlast");
    write("kernels/b.clh", "#include \"eikonal/c.h\"\nb\n");
    write("include/eikonal/c.h", "c\n#ifndef C_H\n#endif\n");
    write("kernels/d.clh", "d\n");
    EXPECT_THAT(source("#include \"d.clh\"\n#include \"d.clh\"\n").text(), HasSubstr("d\n#line 2 \"program\"\n#line 1 \"d.clh\"\nd\n"));
    EXPECT_EQ(source("#define X 1\n#include \"a.cl\"\n").text(),
              "#line 1 \"program\"\n#define X 1\n"
              "#line 1 \"a.cl\"\nfirst\n"
              "#line 1 \"b.clh\"\n"
              "#line 1 \"eikonal/c.h\"\nc\n#ifndef C_H\n#endif\n"
              "#line 2 \"b.clh\"\nb\n"
              "#line 3 \"a.cl\"\n\nlast\n"
              "#line 3 \"program\"\n");
}

TEST_F(KernelSources, NameTheFileThatIsMissing) {
    write("kernels/a.cl", "#include \"none.clh\"\n");
    try {
        source("#include \"a.cl\"\n");
        FAIL() << "included a file that is not there";
    } catch (const DeviceError& error) { EXPECT_THAT(error.what(), testing::AllOf(HasSubstr("\"none.clh\""), HasSubstr(path("kernels")))); }
}

TEST_F(KernelSources, DefineTheFeaturesAndConstantsThatTheyMention) {
    write("kernels/a.cl", "#if HAS_MEDIA\nITEMS_PER_WORK_ITEM\n#endif\n");
    const std::string options =
        source("#include \"a.cl\"\n").options(Features().require(Feature::MEDIA), {{"ITEMS_PER_WORK_ITEM", 8}, {"LOCAL_SIZE", 4}});
    EXPECT_THAT(options, HasSubstr(" -DHAS_MEDIA=1"));
    EXPECT_THAT(options, HasSubstr(" -DITEMS_PER_WORK_ITEM=8"));
    EXPECT_THAT(options, Not(HasSubstr("LOCAL_SIZE")));
    EXPECT_THAT(options, Not(HasSubstr("HAS_FILTER")));
    EXPECT_THAT(options, Not(HasSubstr(folder_.string()))) << "a path would have to survive every implementation's parsing of options";
}

}  // namespace
}  // namespace eikonal
