// Straight-line stages must be vectorised over slots by PoCL: eight at a time on AVX2 (docs/performance.md). A process compiles one
// stage and nothing else. The compiler's remarks say that a loop was widened; its machine code says that all of it was: each scalar
// operation belongs to the loop over the last few slots, and has a twin of eight lanes. (Remarks alone do not do: a loop that calls
// nothing of PoCL's library is widened by the front end, which makes none.)

#include "kind_features.h"
#include "measured_file.h"
#include "stage.h"
#include "test_paths.h"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace eikonal {
namespace {

struct VectorCase { std::string name, stage, world, head = {}; ColorMode color = ColorMode::automatic; };
void PrintTo(const VectorCase& c, std::ostream* out) { *out << c.name; }

constexpr const char* lamp = R"(
    AttributeBegin
    AreaLightSource "diffuse" "rgb L" [ 5 5 5 ]
    Shape "trianglemesh" "integer indices" [ 0 1 2 ] "point3 P" [ -1 3 -1  1 3 -1  0 3 1 ]
    AttributeEnd
)";

/// Every kind of light whose directions are an image's.
const std::string sky = "\"string filename\" \"" EIKONAL_SOURCE_DIR "/scenes/assets/sky.exr\" ";
const std::string imageLights = "LightSource \"infinite\" " + sky + "LightSource \"infinite\" " + sky +
                                "\"point3 portal\" [ -1 -1 4  -1 1 4  1 1 4  1 -1 4 ]\n"
                                "LightSource \"goniometric\" " +
                                sky + "LightSource \"projection\" " + sky;

std::string sphereOf(const std::string& material) { return std::string(lamp) + "Material " + material + "\nShape \"sphere\"\n"; }

/// A measured surface, of a file that the child writes.
fs::path measuredFile(bool isotropic) { return fs::temp_directory_path() / (isotropic ? "isotropic.bsdf" : "grain.bsdf"); }
std::string measuredSphere(bool isotropic) {
    return sphereOf("\"measured\" \"string filename\" \"" + measuredFile(isotropic).string() + "\"");
}

std::vector<VectorCase> cases() {
    std::vector<VectorCase> list = {
        {"generate_rays", "generate_rays", lamp},
        {"generate_rays_spherical", "generate_rays", lamp, "Camera \"spherical\"\n"},
        {"generate_rays_moving", "generate_rays", lamp,
         "ActiveTransform EndTime Rotate 30 0 1 0 ActiveTransform All Camera \"perspective\"\n"},
        {"shade_misses", "shade_misses", "LightSource \"infinite\" \"rgb L\" [ 1 1 1 ]\nShape \"sphere\"\n"},
        {"shade_emitters", "shade_emitters", lamp},
        {"resolve_film", "resolve_film", lamp},
        {"resolve_film_with_auxiliary_channels", "resolve_film", lamp, "Film \"gbuffer\"\n"},
        {"shade_hits_diffuse", "shade_hits diffuse", sphereOf("\"diffuse\"")},
        {"shade_hits_with_an_environment_guide", "shade_hits diffuse", "LightSource \"infinite\"\n" + sphereOf("\"diffuse\"")},
        {"shade_hits_diffuse_transmission", "shade_hits diffuse_transmission", sphereOf("\"diffusetransmission\"")},
        {"shade_misses_with_a_portal", "shade_misses", imageLights + "Shape \"sphere\"\n"},
        {"shade_hits_with_images_and_a_light_tree", "shade_hits diffuse", imageLights + sphereOf("\"diffuse\""),
         "Integrator \"path\" \"string lightsampler\" \"bvh\"\n"},
        {"shade_hits_conductor", "shade_hits conductor", sphereOf("\"conductor\" \"float roughness\" 0.3")},
        {"shade_hits_compensated_conductor", "shade_hits compensated_conductor",
         sphereOf("\"conductor\" \"float roughness\" 0.3 \"bool energycompensation\" true")},
        {"shade_hits_compensated_dielectric", "shade_hits compensated_dielectric",
         sphereOf("\"dielectric\" \"float roughness\" 0.3 \"bool energycompensation\" true")},
        {"shade_hits_specular_conductor", "shade_hits specular_conductor", sphereOf("\"conductor\" \"float roughness\" 0")},
        {"shade_hits_dielectric", "shade_hits dielectric", sphereOf("\"dielectric\" \"float roughness\" 0.3")},
        {"shade_hits_specular_dielectric", "shade_hits specular_dielectric", sphereOf("\"dielectric\"")},
        {"shade_hits_thin_dielectric", "shade_hits thin_dielectric", sphereOf("\"thindielectric\"")},
        /* No pbrt material is principled: what counts is that the scene has directions along surfaces */
        {"shade_hits_principled", "shade_hits principled", sphereOf("\"conductor\" \"float uroughness\" 0.3")},
        {"shade_hits_coated_diffuse", "shade_hits coated_diffuse", sphereOf("\"coateddiffuse\"")},
        {"shade_hits_coated_conductor", "shade_hits coated_conductor", sphereOf("\"coatedconductor\"")},
        {"shade_hits_with_a_layer_medium", "shade_hits coated_diffuse", sphereOf("\"coateddiffuse\" \"rgb albedo\" [.8 .4 .2]")},
        {"shade_hits_henyey_greenstein", "shade_hits henyey_greenstein",
         "MakeNamedMedium \"m\" \"string type\" \"homogeneous\"\nMediumInterface \"m\" \"\"\n" + sphereOf("\"interface\""),
         "Integrator \"bdpt\"\n"},
        {"shade_hits_hair", "shade_hits hair", sphereOf("\"hair\"")},
        {"shade_hits_measured", "shade_hits measured", measuredSphere(true)},
        {"shade_hits_measured_with_a_grain", "shade_hits measured", measuredSphere(false)}};
    /* The same at wavelengths */
    for (VectorCase c : std::vector<VectorCase>(list)) {
        c.name += "_spectral";
        c.color = ColorMode::spectral;
        list.push_back(c);
    }
    /* Of a film that keeps a spectrum */
    const std::string film = "Film \"spectral\"\n";
    list.push_back({"shade_misses_for_spectra", "shade_misses", "LightSource \"infinite\" \"rgb L\" [ 1 1 1 ]\nShape \"sphere\"\n", film});
    list.push_back({"shade_hits_diffuse_for_spectra", "shade_hits diffuse", sphereOf("\"diffuse\""), film});
    /* Of other integrators */
    const std::string tree = "Integrator \"whitted\"\n";
    list.push_back({"shade_occlusions", "shade_occlusions", sphereOf("\"diffuse\""), "Integrator \"ambientocclusion\"\n"});
    list.push_back({"shade_hits_of_a_tree", "shade_hits specular_dielectric", sphereOf("\"dielectric\""), tree});
    list.push_back({"shade_hits_of_a_bundle", "shade_hits conductor", sphereOf("\"conductor\" \"float roughness\" 0.3"), tree});
    for (const auto& [bsdf, material] : {std::pair("diffuse", "\"diffuse\""), {"conductor", "\"conductor\" \"float roughness\" 0.3"},
                                         {"specular_dielectric", "\"dielectric\""}})
        for (const char* stage : {"shade_hits", "shade_light_hits"})
            for (const auto& [ends, integrator] :
                 {std::pair("_of_both_ends", "Integrator \"bdpt\"\n"), {"_of_merged_ends", "Integrator \"sppm\"\n"}})
                list.push_back({std::string(stage) + "_" + bsdf + ends, std::string(stage) + " " + bsdf, sphereOf(material), integrator});
    return list;
}

/// What must not pass for vectorised: walks of unknown length, which in a tree of rays do not go in step.
VectorCase aLoopingStage() {
    return {"shade_hits_walking_alone", "shade_hits coated_conductor", sphereOf("\"coatedconductor\""), "Integrator \"whitted\"\n"};
}

class Vectorizer : public testing::TestWithParam<VectorCase> {};

/// The work of the child: one stage built and launched, with the options that ship.
TEST(VectorizerChild, DISABLED_BuildsOneStage) {
    const char* wanted = std::getenv("EIKONAL_TEST_STAGE");
    ASSERT_NE(wanted, nullptr);
    std::vector<VectorCase> all = cases();
    all.push_back(aLoopingStage());
    for (const VectorCase& c : all) {
        if (c.name != wanted) continue;
        for (bool isotropic : {true, false}) {
            MeasuredFile file;
            file.isotropic = isotropic;
            file.write(measuredFile(isotropic));
        }
        PackedScene scene = packText(c.head + "Sampler \"sobol\"\nWorldBegin\n" + c.world, c.color);
        /* A hit queue with room for its parameters */
        if (c.stage == "shade_hits principled") scene.require(KindFeature::BSDF_PRINCIPLED, "the test");
        StageBench bench(scene, 64, false);
        for (const char* queue : {"hit", "miss", "emission"}) bench.clear(queue, 0);
        bench.run(c.stage, 1);
    }
}

std::string contents(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// The first reason that is given for not vectorising, cut short.
std::string reason(const std::string& remarks) {
    const size_t at = remarks.find("loop not vectorized: ");
    return at == std::string::npos ? "no remark about a loop" : remarks.substr(at, std::min<size_t>(remarks.find('<', at) - at, 160));
}

/// Additions, multiplications, divisions, roots, minima and maxima in a program: those of the loop over the last few slots, which works on
/// one slot at a time, and the lanes of those of the wide loop. Where a processor gathers no faster than it loads, the compiler splits a
/// gather and what follows it into halves of four lanes, with single operations between; those stand near operations of eight lanes, as
/// nothing in the other loop does.
struct Arithmetic {
    size_t scalar = 0, lanes = 0;
    size_t wide() const { return lanes / 8; }
};

Arithmetic countArithmetic(const std::string& disassembly) {
    static const std::regex operation(R"(\tv(?:add|sub|mul|div|sqrt|min|max|fn?m(?:add|sub)[0-9]+)(ss|ps) +([^\n]*))");
    std::vector<size_t> single, four, eight;
    std::istringstream lines(disassembly);
    std::string line;
    for (size_t number = 0; std::getline(lines, line); ++number) {
        std::smatch at;
        if (!std::regex_search(line, at, operation)) continue;
        (at[1] == "ss" ? single : at[2].str().find("ymm") == std::string::npos ? four : eight).push_back(number);
    }
    auto isInWideLoop = [&](size_t number) {
        constexpr size_t near = 60;
        const auto next = std::lower_bound(eight.begin(), eight.end(), number);
        return (next != eight.end() && *next - number < near) || (next != eight.begin() && number - *std::prev(next) < near);
    };
    const auto split = static_cast<size_t>(std::count_if(four.begin(), four.end(), isInWideLoop));
    const auto alone = static_cast<size_t>(std::count_if(single.begin(), single.end(), std::not_fn(isInWideLoop)));
    return {alone, 8 * eight.size() + 4 * split};
}

/// What PoCL made of a stage.
struct Compiled { bool ok = false; std::string remarks; Arithmetic arithmetic; };

Compiled compile(const std::string& name) {
    const fs::path folder = fs::temp_directory_path() / ("eikonal-vectorizer-" + std::to_string(getpid()));
    fs::create_directories(folder);
    const std::string command = "cd '" + folder.string() + "' && env -u GTEST_TOTAL_SHARDS -u GTEST_SHARD_INDEX TMPDIR='" +
                                folder.string() + "' POCL_CACHE_DIR='" + folder.string() + "' EIKONAL_TEST_STAGE=" + name +
                                " POCL_VECTORIZER_REMARKS=1 '" + fs::read_symlink("/proc/self/exe").string() +
                                "' --gtest_also_run_disabled_tests --gtest_filter=VectorizerChild.* > remarks 2>&1" +
                                " && find . -name '*.so' -exec objdump --disassemble --no-show-raw-insn {} + > code";
    const int status = std::system(command.c_str());
    Compiled result{WIFEXITED(status) && WEXITSTATUS(status) == 0, contents(folder / "remarks"),
                    countArithmetic(contents(folder / "code"))};
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    return result;
}

/// Why this machine cannot tell, or nothing.
std::string obstacle() {
    if (testContext().device().platformName.find("Portable Computing Language") == std::string::npos) return "only PoCL has these remarks";
#ifdef __x86_64__
    if (!__builtin_cpu_supports("avx2")) return "without AVX2 there are no eight lanes";
    return std::system("objdump --version > /dev/null 2>&1") == 0 ? "" : "there is no objdump (binutils)";
#else
    return "the width is that of AVX2";
#endif
}

/// The share of operations that need a wide twin: a few are made once for all slots.
constexpr double allButAFew = 0.9;

bool isVectorised(const Arithmetic& a) {
    return a.wide() > 0 && static_cast<double>(a.wide()) >= allButAFew * static_cast<double>(a.scalar);
}

TEST_P(Vectorizer, VectorisesTheStageByEight) {
    if (!obstacle().empty()) GTEST_SKIP() << obstacle();
    const Compiled stage = compile(GetParam().name);
    ASSERT_TRUE(stage.ok) << "the process that compiles " << GetParam().stage << " failed: " << stage.remarks;
    EXPECT_TRUE(isVectorised(stage.arithmetic))
        << GetParam().stage << " is not vectorised: " << stage.arithmetic.scalar << " scalar operations, " << stage.arithmetic.wide()
        << " of eight lanes; " << reason(stage.remarks);
    const bool byFrontEnd = stage.remarks.find("vectorized loop (vectorization width: 8") == std::string::npos;
    EXPECT_TRUE(!byFrontEnd || stage.remarks.find("the loop has already been vectorized") != std::string::npos)
        << "no remark about a loop of eight lanes";
}

TEST(VectorizerControl, ALoopOfUnknownLengthIsNotTakenForVectorised) {
    if (!obstacle().empty()) GTEST_SKIP() << obstacle();
    const Compiled stage = compile(aLoopingStage().name);
    ASSERT_TRUE(stage.ok);
    EXPECT_FALSE(isVectorised(stage.arithmetic));
    EXPECT_GT(stage.arithmetic.scalar, 100u);
}

INSTANTIATE_TEST_SUITE_P(Stages, Vectorizer, testing::ValuesIn(cases()), [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace eikonal
