// Straight-line stages must be vectorised over work-items by PoCL: eight at a time on AVX2 (docs/performance.md). The compiler's
// remarks say so, in the output of a process that compiles one stage and nothing else.

#include "stage.h"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace fs = std::filesystem;

namespace eikonal {
namespace {

struct VectorCase { std::string name, stage, world; };
void PrintTo(const VectorCase& c, std::ostream* out) { *out << c.name; }

constexpr const char* lamp = R"(
    AttributeBegin
    AreaLightSource "diffuse" "rgb L" [ 5 5 5 ]
    Shape "trianglemesh" "integer indices" [ 0 1 2 ] "point3 P" [ -1 3 -1  1 3 -1  0 3 1 ]
    AttributeEnd
)";

std::string sphereOf(const std::string& material) { return std::string(lamp) + "Material " + material + "\nShape \"sphere\"\n"; }

std::vector<VectorCase> cases() {
    return {{"generate_rays", "generate_rays", lamp},
            {"shade_misses", "shade_misses", "LightSource \"infinite\" \"rgb L\" [ 1 1 1 ]\nShape \"sphere\"\n"},
            {"shade_hits_diffuse", "shade_hits diffuse", sphereOf("\"diffuse\"")},
            {"shade_hits_conductor", "shade_hits conductor", sphereOf("\"conductor\" \"float roughness\" 0.3")},
            {"shade_hits_dielectric", "shade_hits dielectric", sphereOf("\"dielectric\" \"float roughness\" 0.3")}};
}

class Vectorizer : public testing::TestWithParam<VectorCase> {};

/// The work of the child: one stage built and launched, with the options that ship.
TEST(VectorizerChild, DISABLED_BuildsOneStage) {
    const char* wanted = std::getenv("EIKONAL_TEST_STAGE");
    ASSERT_NE(wanted, nullptr);
    for (const VectorCase& c : cases()) {
        if (c.name != wanted) continue;
        const PackedScene scene = packText("Sampler \"sobol\"\nWorldBegin\n" + c.world);
        StageBench bench(scene, 64, false);
        for (const char* name : {"tile_x", "tile_y", "tile_log2_width", "tile_log2_height", "end_x", "end_y", "first_sample", "samples"}) bench.set(name, 0);
        for (const char* queue : {"hit", "miss"}) bench.clear(queue, 0);
        bench.run(c.stage, 1);
    }
}

/// How often a text occurs in a file.
size_t occurrences(const fs::path& file, const std::string& wanted) {
    std::ifstream stream(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    size_t count = 0;
    for (size_t at = text.find(wanted); at != std::string::npos; at = text.find(wanted, at + 1)) ++count;
    return count;
}

/// The first reason that is given for not vectorising, cut short.
std::string reason(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    const size_t at = text.find("loop not vectorized: ");
    return at == std::string::npos ? "no remark about a loop" : text.substr(at, std::min<size_t>(text.find('<', at) - at, 160));
}

TEST_P(Vectorizer, VectorisesTheStageByEight) {
    if (testContext().device().platformName.find("Portable Computing Language") == std::string::npos) GTEST_SKIP() << "only PoCL has these remarks";
#ifdef __x86_64__
    if (!__builtin_cpu_supports("avx2")) GTEST_SKIP() << "without AVX2 there are no eight lanes";
#else
    GTEST_SKIP() << "the width is that of AVX2";
#endif
    const fs::path folder = fs::temp_directory_path() / ("eikonal-vectorizer-" + std::to_string(getpid()));
    fs::create_directories(folder);
    const fs::path remarks = folder / "remarks";
    const std::string command = "cd '" + folder.string() + "' && env -u POCL_CACHE_DIR TMPDIR='" + folder.string() + "' EIKONAL_TEST_STAGE=" + GetParam().name +
                                " POCL_VECTORIZER_REMARKS=1 '" + fs::read_symlink("/proc/self/exe").string() +
                                "' --gtest_also_run_disabled_tests --gtest_filter=VectorizerChild.* > '" + remarks.string() + "' 2>&1";
    const int status = std::system(command.c_str());
    /* A loop that calls nothing of PoCL's library is widened by the front end already, which makes no remark; later passes then find it done */
    const size_t vectorised = occurrences(remarks, "vectorized loop (vectorization width: 8") + occurrences(remarks, "the loop has already been vectorized");
    const std::string why = reason(remarks);
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    ASSERT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "the process that compiles " << GetParam().stage << " failed";
    EXPECT_GE(vectorised, 1u) << GetParam().stage << " is not vectorised: " << why;
}

INSTANTIATE_TEST_SUITE_P(Stages, Vectorizer, testing::ValuesIn(cases()), [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace eikonal
