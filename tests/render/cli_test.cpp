// The program from outside: exit statuses, messages, and the files that it leaves.

#include "run_program.h"

#include "feature_set.h"
#include "film/image_file.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <sys/mount.h>

#include <algorithm>
#include <csignal>
#include <iterator>

namespace eikonal {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Cli : public ProgramTest {
protected:
    Cli() { write("tiny.pbrt", tinyScene()); }
    bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }
    FilmImage image(const std::string& name) const { return readImage(path(name)).image; }
};

// ---- the image ----------------------------------------------------------------------------------------------------------

TEST_F(Cli, ASingleExrLeavesAPngBesideIt) {
    const Outcome run = this->run({"render", "tiny.pbrt", "-o", "a.exr", "--seed", "5"});
    ASSERT_EQ(run.status, 0) << run.error;
    EXPECT_THAT(run.error, HasSubstr("wrote a.exr and a.png"));
    const FilmFile exr = readImage(path("a.exr"));
    EXPECT_EQ(exr.image.width, 16);
    EXPECT_EQ(exr.image.height, 12);
    EXPECT_EQ(exr.image.columns(), 16);
    EXPECT_GT(exr.image.color[exr.image.index(8, 6)].r, 0.1f) << "the square is lit";
    EXPECT_EQ(exr.image.color[0], glm::vec3(0)) << "nothing is in the corner";
    EXPECT_EQ(image("a.png").pixelCount(), 16u * 12u);
    EXPECT_EQ(exr.metadata.samples, 4);
    EXPECT_EQ(exr.metadata.seed, 5);
    EXPECT_EQ(exr.metadata.version, "Eikonal " EIKONAL_VERSION);
    EXPECT_EQ(exr.metadata.scene, "tiny.pbrt");
    EXPECT_EQ(exr.metadata.sceneHash.size(), 16u);
    EXPECT_FALSE(exr.metadata.device.empty());
    EXPECT_GE(exr.metadata.renderSeconds.value_or(-1), 0);
}

TEST_F(Cli, TheSceneHashChangesWithTheSceneAndNotWithSamplesOrSeed) {
    write("other.pbrt", tinyScene("", "Translate 0 0 0.5"));
    const auto hash = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"info", "--json"});
        return nlohmann::json::parse(run(more).out).at("sceneHash").get<std::string>();
    };
    const std::string tiny = hash({"tiny.pbrt"});
    EXPECT_EQ(hash({"tiny.pbrt", "--seed", "9", "--spp", "77"}), tiny);
    EXPECT_NE(hash({"other.pbrt"}), tiny);
}

TEST_F(Cli, SeveralFilesMayBeAskedFor) {
    ASSERT_EQ(run({"render", "tiny.pbrt", "-o", "a.exr", "--outfile", "b.jpg"}).status, 0);
    EXPECT_TRUE(exists("a.exr") && exists("b.jpg"));
    EXPECT_FALSE(exists("a.png")) << "the user has said which files there are to be";
}

TEST_F(Cli, WithoutANameTheImageIsCalledLikeTheScene) {
    ASSERT_EQ(run({"render", "tiny.pbrt"}).status, 0);
    EXPECT_TRUE(exists("tiny.exr") && exists("tiny.png"));
}

TEST_F(Cli, ACropHasTheSamePixelsAsTheWhole) {
    ASSERT_EQ(run({"render", "tiny.pbrt", "-o", "whole.exr"}).status, 0);
    ASSERT_EQ(run({"render", "tiny.pbrt", "-o", "crop.exr", "--cropwindow", "0.25,0.75,0,0.5"}).status, 0);
    ASSERT_EQ(run({"render", "tiny.pbrt", "-o", "bounds.exr", "--pixelbounds", "4,12,0,6", "--nthreads", "1", "--wave-paths", "100"}).status, 0);
    const FilmImage whole = image("whole.exr"), crop = image("crop.exr"), bounds = image("bounds.exr");
    for (const FilmImage* part : {&crop, &bounds}) {
        EXPECT_EQ(part->width, 16);
        EXPECT_EQ(part->height, 12);
        ASSERT_EQ((std::array{part->bounds.x0, part->bounds.x1, part->bounds.y0, part->bounds.y1}), (std::array{4, 12, 0, 6}));
        for (int y = 0; y < 6; ++y)
            for (int x = 4; x < 12; ++x) EXPECT_EQ(part->color[part->index(x, y)], whole.color[whole.index(x, y)]) << x << " " << y;
    }
}

TEST_F(Cli, AovsAreThereWhenAskedFor) {
    ASSERT_EQ(run({"render", "tiny.pbrt", "-o", "all.exr", "--aov", "all"}).status, 0);
    ASSERT_EQ(run({"render", "tiny.pbrt", "-o", "none.exr"}).status, 0);
    const FilmImage all = image("all.exr"), none = image("none.exr");
    const size_t middle = all.index(8, 6);
    ASSERT_FALSE(all.albedo.empty() || all.normal.empty() || all.depth.empty() || all.variance.empty() || all.sampleCount.empty());
    EXPECT_NEAR(std::abs(all.normal[middle].z), 1, 1e-4) << "the square stands across z";
    EXPECT_NEAR(all.depth[middle], 4, 0.1) << "the camera is 4 away";
    EXPECT_EQ(all.sampleCount[middle], 4);
    EXPECT_TRUE(none.albedo.empty() && none.normal.empty() && none.depth.empty() && none.variance.empty() && none.sampleCount.empty());
}

TEST_F(Cli, AovsNeedAnExr) {
    write("named.pbrt", "Film \"rgb\" \"string filename\" \"a.jpg\"\nWorldBegin\nShape \"sphere\"\n");
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{"tiny.pbrt", "-o", "a.png", "-o", "a.jpg"}, {"named.pbrt"}}) {
        std::vector<std::string> all{"render", "--aov", "object"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        const Outcome run = this->run(all);
        EXPECT_EQ(run.status, 2);
        EXPECT_THAT(run.error, HasSubstr("--aov asks for channels that only an EXR has"));
        EXPECT_FALSE(exists("a.png") || exists("a.jpg"));
    }
    EXPECT_EQ(run({"render", "tiny.pbrt", "-o", "a.png", "-o", "b.exr", "--aov", "albedo"}).status, 0);
}

TEST_F(Cli, OptionsCountMoreThanTheFile) {
    ASSERT_EQ(run({"render", "tiny.pbrt", "-o", "a.exr", "--resolution", "20x10", "--spp", "2"}).status, 0);
    const FilmFile exr = readImage(path("a.exr"));
    EXPECT_EQ(exr.image.width, 20);
    EXPECT_EQ(exr.image.height, 10);
    EXPECT_EQ(exr.metadata.samples, 2);
}

TEST_F(Cli, SamplesThatAreNotFiniteAreReportedAndBlack) {
    write("blinding.pbrt", tinyScene("", "LightSource \"point\" \"rgb I\" [3e38 3e38 3e38] \"point3 from\" [0 0 -0.001]"));
    const Outcome run = this->run({"render", "blinding.pbrt", "-o", "a.exr"});
    EXPECT_EQ(run.status, 0);
    EXPECT_THAT(run.error, testing::ContainsRegex("not finite, .* the first is in pixel \\([0-9]+, [0-9]+\\)"));
    for (const glm::vec3& c : image("a.exr").color) EXPECT_TRUE(std::isfinite(c.r + c.g + c.b));
}

// ---- ending early -------------------------------------------------------------------------------------------------------

TEST_F(Cli, TheTimeLimitLeavesAWholeImage) {
    const Outcome run = this->run({"render", "tiny.pbrt", "-o", "a.exr", "--spp", "100000000", "--time-limit", "0.2", "--aov", "sampleCount"});
    EXPECT_EQ(run.status, 0);
    EXPECT_THAT(run.error, testing::ContainsRegex("ended by --time-limit: [0-9].* of 100000000 samples a pixel"));
    const FilmFile exr = readImage(path("a.exr"));
    EXPECT_GE(exr.metadata.samples.value_or(0), 1);
    EXPECT_LT(exr.metadata.samples.value_or(0), 100000000);
    EXPECT_GE(*std::min_element(exr.image.sampleCount.begin(), exr.image.sampleCount.end()), 1);
}

class Signals : public Cli, public testing::WithParamInterface<int> {};

TEST_P(Signals, LeaveTheImageSoFar) {
    const Running running = start({"render", "tiny.pbrt", "-o", "a.exr", "--spp", "100000000", "--log-level", "info"});
    EXPECT_TRUE(printed(running, "rendering 16 x 12 pixels"));
    ::usleep(300'000);
    ::kill(running.process, GetParam());
    const Outcome run = wait(running);
    EXPECT_EQ(run.status, 128 + GetParam());
    EXPECT_THAT(run.error, HasSubstr("interrupted: "));
    EXPECT_LT(run.seconds, 10);
    EXPECT_GT(image("a.exr").color[6 * 16 + 8].r, 0.1f);
}

INSTANTIATE_TEST_SUITE_P(Cli, Signals, testing::Values(SIGINT, SIGTERM));

/// As for a command that a script starts with `&`: Ctrl-C is meant for what is in front.
TEST_F(Cli, ASignalThatIsIgnoredStaysIgnored) {
    const auto before = std::signal(SIGINT, SIG_IGN);   // inherited
    const Running running = start({"render", "tiny.pbrt", "-o", "a.exr", "--spp", "100000000", "--time-limit", "1.5", "--log-level", "info"});
    std::signal(SIGINT, before);
    EXPECT_TRUE(printed(running, "rendering 16 x 12 pixels"));
    ::usleep(300'000);
    for (int i = 0; i < 2; ++i) ::kill(running.process, SIGINT);
    const Outcome run = wait(running);
    EXPECT_EQ(run.status, 0);
    EXPECT_THAT(run.error, HasSubstr("ended by --time-limit: "));
}

/// The processes whose parent is this one.
static std::vector<int> childrenOf(int process) {
    std::ifstream list("/proc/" + std::to_string(process) + "/task/" + std::to_string(process) + "/children");
    return {std::istream_iterator<int>(list), {}};
}

/// Whether it is there and no zombie.
static bool runs(int process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/stat");
    std::string number, name, state;
    return file >> number >> name >> state && state != "Z";
}

TEST_F(Cli, WorkersEndWithTheProgram) {
    const Running running = start({"render", "tiny.pbrt", "--nthreads", "2"}, {{"EIKONAL_CACHE_DIR", path("cache")}});
    std::vector<int> workers;
    for (int i = 0; i < 60'000 && workers.size() < 2 && runs(running.process); ++i) {
        ::usleep(1000);
        workers = childrenOf(running.process);
    }
    EXPECT_EQ(workers.size(), 2u);
    ::kill(running.process, SIGINT);
    EXPECT_EQ(wait(running).status, 128 + SIGINT);
    for (const int worker : workers) {
        for (int i = 0; i < 600 && runs(worker); ++i) ::usleep(100'000);
        EXPECT_FALSE(runs(worker));
    }
    for (const auto& file : std::filesystem::directory_iterator(path("cache")))
        EXPECT_NE(file.path().extension(), ".program") << "it went on to make " << file.path();
}

/// All samples are taken, and all of them will be on disk: that is no early end.
TEST_F(Cli, ASignalWhileAFinishedImageIsWrittenChangesNothing) {
    const Running running = start({"render", "tiny.pbrt", "-o", "a.exr", "--resolution", "800x600", "--spp", "1"});
    for (int i = 0; i < 60'000 && !exists("a.exr"); ++i) ::usleep(1000);
    EXPECT_FALSE(exists("a.png")) << "it comes after the EXR";
    ::kill(running.process, SIGINT);
    const Outcome run = wait(running);
    EXPECT_EQ(run.status, 0) << run.error;
    EXPECT_EQ(image("a.png").pixelCount(), 480'000u);
}

// ---- errors -------------------------------------------------------------------------------------------------------------

TEST_F(Cli, ErrorsInASceneSayWhereAndExitWith1) {
    write("bad.pbrt", tinyScene() + "Shape \"sphere\" \"float radius\" oops\n");
    const Outcome bad = run({"render", "bad.pbrt"});
    EXPECT_EQ(bad.status, 1);
    EXPECT_THAT(bad.error, testing::MatchesRegex("bad.pbrt:[0-9]+:[0-9]+: .*\n"));
    EXPECT_FALSE(exists("bad.exr"));
    write("worse.pbrt", "WorldBegin\nShape \"a\"\nShape \"b\"\n");
    EXPECT_THAT(run({"info", "worse.pbrt"}).error, testing::MatchesRegex("worse.pbrt:2:1: .*\nworse.pbrt:3:1: .*\n")) << "each line begins with its place";
    EXPECT_EQ(run({"render", "absent.pbrt"}).status, 1);
    EXPECT_EQ(run({"info", "absent.obj"}).status, 1);
    EXPECT_EQ(run({"compare", "absent.exr", "absent.exr"}).status, 1);
    write("scene.blend", "");
    const Outcome unknown = run({"render", "scene.blend"});
    EXPECT_EQ(unknown.status, 1);
    EXPECT_THAT(unknown.error, HasSubstr(".pbrt or .obj"));
}

TEST_F(Cli, OutputThatCannotBeWrittenIsSaidBeforeRendering) {
    for (const char* file : {"absent/a.exr", "a.xyz", "."}) {
        const Outcome run = this->run({"render", "tiny.pbrt", "-o", file, "--spp", "100000000"});
        EXPECT_EQ(run.status, 1) << file;
        EXPECT_THAT(run.error, HasSubstr("cannot write")) << file;
        EXPECT_LT(run.seconds, 5) << file;
    }
}

TEST_F(Cli, ASceneThatIsNoTextDoesNotReachTheTerminal) {
    write("binary.pbrt", "\x1b]0;title\a\x1b[2J");
    const Outcome run = this->run({"info", "binary.pbrt"});
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.error, HasSubstr("binary.pbrt:1:1: \"\\x1b\""));
    for (const char c : run.error) EXPECT_TRUE(c == '\n' || !std::iscntrl(static_cast<unsigned char>(c)));
}

TEST_F(Cli, ErrorsOfUsageExitWith2) {
    for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{{}, {"rendr"}, {"render"}, {"render", "tiny.pbrt", "--no-such-option"}, {"render", "tiny.pbrt", "--spp", "0"},
                                                                                          {"render", "tiny.pbrt", "--camera", "0,0,1"}, {"render", "tiny.pbrt", "--local-size", "1048576"}}) {
        const Outcome run = this->run(arguments);
        EXPECT_EQ(run.status, 2) << testing::PrintToString(arguments) << run.error;
        EXPECT_THAT(run.error, HasSubstr("error: "));
        EXPECT_THAT(run.out, IsEmpty());
    }
}

TEST_F(Cli, ErrorsOfTheDeviceExitWith3) {
    const Outcome unknown = run({"render", "tiny.pbrt", "--device", "no such thing"});
    EXPECT_EQ(unknown.status, 3);
    EXPECT_THAT(unknown.error, HasSubstr("There are:\n  0  "));
    const Outcome none = run({"render", "tiny.pbrt"}, {{"OCL_ICD_VENDORS", path("")}});
    EXPECT_EQ(none.status, 3);
    EXPECT_THAT(none.error, HasSubstr("pocl-opencl-icd"));
}

TEST_F(Cli, StrictTurnsWhatIsNotRenderedIntoAnError) {
    write("photons.pbrt", tinyScene("Integrator \"sppm\""));
    const Outcome lax = run({"info", "photons.pbrt"}), strict = run({"info", "photons.pbrt", "--strict"});
    EXPECT_EQ(lax.status, 0);
    EXPECT_THAT(lax.error, HasSubstr("warning: "));
    EXPECT_EQ(strict.status, 1);
    EXPECT_THAT(strict.error, HasSubstr("--strict"));
}

/// The option counts more than the scene, and then there is nothing to be warned of.
TEST_F(Cli, TheIntegratorMayBeChosen) {
    write("photons.pbrt", tinyScene("Integrator \"sppm\""));
    const Outcome lax = run({"info", "photons.pbrt"}), chosen = run({"info", "photons.pbrt", "--integrator", "ambientocclusion", "--strict"});
    EXPECT_EQ(lax.error.find("warning: "), lax.error.rfind("warning: ")) << "one warning: " << lax.error;
    EXPECT_EQ(chosen.status, 0);
    EXPECT_EQ(chosen.error, "");
    EXPECT_THAT(chosen.out, HasSubstr("AMBIENT_OCCLUSION"));
    const Outcome unknown = run({"info", "photons.pbrt", "--integrator", "bdpt"});
    EXPECT_EQ(unknown.status, 2);
    EXPECT_THAT(unknown.error, HasSubstr("--integrator is one of volpath, path, direct, whitted"));
}

// ---- what is printed ----------------------------------------------------------------------------------------------------

TEST_F(Cli, LoadingKernelsIsNotCalledCompiling) {
    ASSERT_EQ(run({"render", "tiny.pbrt"}).status, 0);
    const Running running = start({"render", "tiny.pbrt", "--log-level", "info"});
    EXPECT_TRUE(printed(running, "memory to be taken"));
    /* A machine that is busy with something else */
    for (int i = 0; i < 4; ++i) {
        ::kill(running.process, SIGSTOP);
        ::usleep(600'000);
        ::kill(running.process, SIGCONT);
        ::usleep(20'000);
    }
    const Outcome run = wait(running);
    EXPECT_EQ(run.status, 0);
    EXPECT_THAT(run.error, Not(HasSubstr("compiling")));
}

TEST_F(Cli, QuietPrintsNothing) {
    const Outcome run = this->run({"render", "tiny.pbrt", "--quiet"});
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.out + run.error, "");
}

TEST_F(Cli, StatsTellWhereTimeAndMemoryWent) {
    const Outcome run = this->run({"render", "tiny.pbrt", "--stats"});
    for (const char* what : {"read the scene", "compile the kernels", "intersect_rays", "until the first ray", "render ", "shadow rays", "Memory: scene tables"})
        EXPECT_THAT(run.out, HasSubstr(what));
}

TEST_F(Cli, InfoTellsWhatASceneRequiresAndWhy) {
    const Outcome text = run({"info", "tiny.pbrt"});
    EXPECT_EQ(text.status, 0);
    EXPECT_THAT(text.out, HasSubstr("2 triangles"));
    EXPECT_THAT(text.out, HasSubstr("tiny.pbrt:"));
    const auto json = nlohmann::json::parse(run({"info", "tiny.pbrt", "--json"}).out);
    EXPECT_EQ(json.at("counts").at("triangles"), 2);
    EXPECT_GT(json.at("memory").at("queues"), 0);
    const auto requires_ = [&](const char* name) {
        return std::any_of(json.at("features").begin(), json.at("features").end(), [&](const auto& f) { return f.at("name") == name; });
    };
    EXPECT_TRUE(requires_("BSDF_DIFFUSE"));
    EXPECT_FALSE(requires_("MEDIA"));
    write("empty.pbrt", "WorldBegin\n");
    EXPECT_THAT(run({"info", "empty.pbrt"}).out, HasSubstr("holds      nothing\n"));
}

TEST_F(Cli, InfoNeedsNoDevice) { EXPECT_EQ(run({"info", "tiny.pbrt"}, {{"OCL_ICD_VENDORS", path("")}}).status, 0); }

TEST_F(Cli, AnObjIsASceneByItself) {
    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Outcome run = this->run({"info", "a.obj", "--camera", "0,0,3", "--look-at", "0.3,0.3,0", "--fov", "30", "--resolution", "32x16"});
    EXPECT_EQ(run.status, 0) << run.error;
    EXPECT_THAT(run.out, HasSubstr("32 x 16"));
    EXPECT_THAT(run.out, HasSubstr("1 triangles"));
}

TEST_F(Cli, BenchCountsRealRaysOnly) {
    const Outcome run = this->run({"bench", "tiny.pbrt", "--repeats", "2", "--json", "bench.json"});
    ASSERT_EQ(run.status, 0) << run.error;
    const auto json = nlohmann::json::parse(read(path("bench.json")));
    EXPECT_EQ(json.at("paths"), 16 * 12 * 4);
    EXPECT_GE(json.at("rays"), 16 * 12 * 4) << "one from the camera for each path";
    EXPECT_LE(json.at("shadowRays"), json.at("rays"));
    EXPECT_GT(json.at("shadowRays"), 0);
    EXPECT_GT(json.at("raysPerSecond"), 0);
    for (const auto& stage : json.at("stages")) {
        EXPECT_GT(stage.at("seconds"), 0) << stage;
        EXPECT_GT(stage.at("occupancy"), 0) << stage;
        EXPECT_LE(stage.at("occupancy"), 1) << stage;
    }
    /* 16 x 12 pixels are a tile of 16 x 16; every stage that runs over the rays' slots has their holes */
    const auto occupancy = [&](const std::string& name) {
        for (const auto& stage : json.at("stages")) if (stage.at("stage") == name) return stage.at("occupancy").get<double>();
        return -1.;
    };
    EXPECT_LT(occupancy("generate_rays"), 1);
    EXPECT_EQ(occupancy("resolve_film"), occupancy("generate_rays")) << "of the same tiles";
    EXPECT_EQ(occupancy("classify_flights"), occupancy("intersect_rays"));
    EXPECT_EQ(occupancy("route_flights"), occupancy("intersect_rays"));
}

TEST_F(Cli, CompareFindsAnImageEqualToItself) {
    ASSERT_EQ(run({"render", "tiny.pbrt", "-o", "a.exr"}).status, 0);
    const auto json = nlohmann::json::parse(run({"compare", "a.exr", "a.exr", "--json"}).out);
    EXPECT_EQ(json.at("relativeMse"), 0);
    EXPECT_EQ(json.at("blocksOff"), 0);
}

TEST_F(Cli, DevicesAreListed) {
    for (const char* spelling : {"list-devices", "--list-devices"}) {
        const Outcome run = this->run({spelling});
        EXPECT_EQ(run.status, 0);
        EXPECT_THAT(run.out, testing::StartsWith("0  "));
    }
}

// ---- the cache of kernels -----------------------------------------------------------------------------------------------

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
        std::ofstream(file, std::ios::in | std::ios::out | std::ios::binary).seekp(40) << "random bytes: \x91\x02\xf7\x5c\xa8\x33\xd0\x6e\x1b\x84";
    };
    ASSERT_EQ(run(compileOne, own).status, 0);
    const std::vector<std::pair<std::string, int>> kinds{{".so", 0}, {".so", 1}, {".so", 2}, {".bc", 0}, {".bc", 1}, {".bc", 2}, {".program", 2}};
    for (const auto& [kind, how] : kinds) {
        for (const auto& file : std::filesystem::recursive_directory_iterator(path("cache")))
            if (file.path().extension() == kind) damage(file.path(), how);
        const Outcome damaged = run(compileOne, own);
        EXPECT_EQ(damaged.status, 0) << kind << " " << how << ": " << damaged.error;
    }
    EXPECT_EQ(std::distance(std::filesystem::recursive_directory_iterator(path("cache")), {}), 1) << "the program and nothing else";
}

TEST_F(Cli, AWorkerCompilesEveryKernelThatASceneNeeds) {
    std::string bits(featureCount, '0');
    const auto info = nlohmann::json::parse(run({"info", "tiny.pbrt", "--json"}).out);
    for (const auto& feature : info.at("features"))
        bits.at(static_cast<size_t>(featureNamed(feature.at("name")))) = '1';
    const Environment own{{"EIKONAL_CACHE_DIR", path("cache")}};
    EXPECT_EQ(run({"compile-kernels", bits, "0", "0", "1"}, own).status, 0);
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
    EXPECT_THAT(run.error, testing::ContainsRegex("warning: compiled kernels are kept in .*: " + disk_ + " is on a disk with 0\\.[0-9] MiB left, of 16 at least"));
    EXPECT_TRUE(std::filesystem::is_empty(disk_));
}

}  // namespace
}  // namespace eikonal
