// The command line as the program understands it. What it does then is tested in tests/render/cli_*_test.cpp.

#include "kinds/integrator_kind.h"
#include "app/frame_numbers.h"
#include "app/output.h"
#include "app/progress_display.h"
#include "app/options.h"
#include "app/render_jobs.h"
#include "test_paths.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <sstream>

namespace eikonal {
namespace {

using testing::HasSubstr;

/// Splits at spaces: no argument of these tests has any.
Options parse(const std::string& line) {
    std::istringstream words("eikonal " + line);
    return parseOptions({std::istream_iterator<std::string>(words), {}});
}

std::string messageOf(const std::string& line) {
    try {
        parse(line);
    } catch (const UsageError& error) {
        EXPECT_EQ(error.code(), ExitCode::usage);
        return error.what();
    }
    return "no error";
}

TEST(Options, WhatIsNotGivenStaysTheScenes) {
    const Options o = parse("render a.pbrt");
    EXPECT_EQ(o.command, Command::render);
    EXPECT_EQ(o.scene.path, "a.pbrt");
    EXPECT_FALSE(o.scene.spp || o.scene.seed || o.scene.sampler || o.scene.integrator || o.scene.maxDepth || o.scene.resolution ||
                 o.scene.cropWindow || o.scene.pixelBounds);
    EXPECT_FALSE(o.scene.camera || o.scene.lookAt || o.scene.up || o.scene.fov || o.output.timeLimit || o.device.wavePaths ||
                 o.device.localSize || o.device.itemsPerWorkItem);
    EXPECT_TRUE(o.output.files.empty());
    EXPECT_EQ(o.log, LogLevel::warning);
    EXPECT_TRUE(o.device.cache && o.device.contraction);
    EXPECT_EQ(o.commandLine, "eikonal render a.pbrt");
}

TEST(Options, PbrtsSpellingsMeanWhatTheyMeanThere) {
    const Options o =
        parse("render --spp 64 --seed 7 --outfile a.exr --nthreads 2 --cropwindow 0,0.5,.25,1 --quiet --log-level debug a.pbrt");
    EXPECT_EQ(o.scene.spp, 64);
    EXPECT_EQ(o.scene.seed, 7);
    EXPECT_THAT(o.output.files, testing::ElementsAre("a.exr"));
    EXPECT_EQ(o.device.threads, 2);
    EXPECT_EQ(o.scene.cropWindow, (std::array<double, 4>{0, 0.5, 0.25, 1}));
    EXPECT_EQ(o.log, LogLevel::error) << "--quiet wins";
    const PixelBounds b = parse("render a.pbrt --pixelbounds 1,20,3,40").scene.pixelBounds.value();
    EXPECT_EQ((std::array{b.x0, b.x1, b.y0, b.y1}), (std::array{1, 20, 3, 40}));
}

/// A name counts by its letters, whatever the dashes; values stay as they are.
TEST(Options, DashesAndCapitalsOfNamesDoNotMatter) {
    EXPECT_EQ(parse("render a.pbrt -spp 64").scene.spp, 64);
    EXPECT_EQ(parse("render a.pbrt -Spp=64 --SEED 3").scene.seed, 3);
    EXPECT_EQ(parse("render a.pbrt --pixel-bounds 1,20,3,40").scene.pixelBounds.value().x1, 20);
    EXPECT_EQ(parse("render a.pbrt --crop_window=0,0.5,.25,1").scene.cropWindow.value()[1], 0.5);
    EXPECT_EQ(parse("render a.pbrt --maxerror 5%").output.targetError, 0.05);
    EXPECT_EQ(parse("render a.pbrt -o --spp.exr --log-level verbose").log, LogLevel::debug);
    EXPECT_EQ(parse("render a.pbrt -quality draft").preset->name, std::string("draft"));
}

TEST(Options, PresetsStandForOptionsThatOthersOverride) {
    const Options draft = parse("render a.pbrt --quality draft");
    EXPECT_EQ(draft.scene.spp, 8);
    EXPECT_EQ(parse("render a.pbrt --quality reference").scene.regularize, false);
    EXPECT_EQ(draft.commandLine, "eikonal render a.pbrt --quality draft");
    const Options mine = parse("render --regularize on a.pbrt --quality=reference --spp 3");
    EXPECT_EQ(mine.scene.spp, 3);
    EXPECT_EQ(mine.scene.regularize, true);
    EXPECT_EQ(parse("info a.pbrt --quality reference").scene.colorMode, ColorMode::spectral);
    EXPECT_THAT(messageOf("render a.pbrt --quality best"), HasSubstr("draft, preview, final, reference"));
}

TEST(Options, ValuesOfEveryKindAreRead) {
    const Options o = parse(
        "render a.obj --camera -1,2.5,3e1 --look-at=0,0,0 --up 0,0,1 --fov 35 --resolution 640x480 --sampler independent --integrator "
        "whitted --max-depth 0 --roulette throughput --roulette-scale 2.5 --roulette-depth 1 "
        "--time-limit 1.5 --aov albedo,depth --tonemap filmic --exposure -1 --wave-paths 4096 --local-size 32 --items-per-work-item 8 "
        "--contraction off --no-cache --build-options=-cl-mad-enable --math-flags none --math-flags=intersect_rays:-cl-denorms-are-zero "
        "--dump-kernels k --device gpu --strict --stats -o a.exr -o b.png --seed -3");
    EXPECT_EQ(o.scene.camera, glm::dvec3(-1, 2.5, 30));
    EXPECT_EQ(o.scene.lookAt, glm::dvec3(0));
    EXPECT_EQ(o.scene.up, glm::dvec3(0, 0, 1));
    EXPECT_EQ(o.scene.fov, 35);
    EXPECT_EQ(o.scene.resolution, (std::array{640, 480}));
    EXPECT_EQ(o.scene.sampler, SamplerKind::independent);
    EXPECT_EQ(o.scene.integrator, &whitted_integrator);
    EXPECT_EQ(o.scene.maxDepth, 0);
    EXPECT_EQ(o.scene.roulette, RouletteRule::throughput);
    EXPECT_EQ(o.scene.rouletteScale, 2.5);
    EXPECT_EQ(o.scene.rouletteDepth, 1);
    EXPECT_EQ(o.scene.seed, -3);
    EXPECT_EQ(o.output.timeLimit, 1.5);
    EXPECT_TRUE(o.output.aovs.albedo && o.output.aovs.depth);
    EXPECT_FALSE(o.output.aovs.normal || o.output.aovs.variance || o.output.aovs.sampleCount);
    EXPECT_EQ(o.output.encoding.curve, ToneCurve::filmic);
    EXPECT_EQ(o.output.encoding.exposure, -1);
    EXPECT_EQ(o.device.wavePaths, 4096u);
    EXPECT_EQ(o.device.localSize, 32u);
    EXPECT_EQ(o.device.itemsPerWorkItem, 8u);
    EXPECT_FALSE(o.device.contraction || o.device.cache);
    EXPECT_EQ(o.device.buildOptions, "-cl-mad-enable");
    ASSERT_EQ(o.device.mathFlags.size(), 2u);
    EXPECT_EQ(o.device.mathFlags[0].stage + "|" + o.device.mathFlags[0].flags, "|");
    EXPECT_EQ(o.device.mathFlags[1].stage + "|" + o.device.mathFlags[1].flags, "intersect_rays|-cl-denorms-are-zero");
    EXPECT_EQ(o.device.dumpFolder, "k");
    EXPECT_EQ(o.device.device, "gpu");
    EXPECT_TRUE(o.scene.strict && o.output.stats);
    EXPECT_THAT(o.output.files, testing::ElementsAre("a.exr", "b.png"));
}

TEST(Options, AnErrorIsANumberOrAPercentageUnderEitherName) {
    for (const char* line : {"--max-error 0.02", "--max-error 2%", "--target-error 0.02", "--target-error=2%"})
        EXPECT_DOUBLE_EQ(parse("render a.pbrt " + std::string(line)).output.targetError.value(), 0.02) << line;
    EXPECT_EQ(parse("render a.pbrt").output.errorMetric, ErrorMetric::relmseRoot);
    EXPECT_EQ(parse("render a.pbrt --error-metric nrmse").output.errorMetric, ErrorMetric::nrmse);
    for (const char* bad : {"0", "-1%", "%", "2%%", "inf", "two"})
        EXPECT_THAT(messageOf("render a.pbrt --max-error " + std::string(bad)), HasSubstr("or a percentage like 2%")) << bad;
    EXPECT_THAT(messageOf("render a.pbrt --error-metric mse"), HasSubstr("relmse-root, relmse-scaled, mse-root, nrmse"));
}

TEST(Options, AllAovsAtOnce) {
    const Aovs a = parse("render a.pbrt --aov all").output.aovs;
    for (const AovName& each : aovNames)
        EXPECT_EQ(a.*each.asked, each.source != AovSource::lightGroups && each.source != AovSource::names) << each.name;
    const Aovs cryptomatte = parse("render a.pbrt --aov cryptomatte").output.aovs;
    for (const AovName& each : aovNames) EXPECT_EQ(cryptomatte.*each.asked, each.source == AovSource::names) << each.name;
    const Aovs passes = parse("render a.pbrt --aov passes,lightgroups").output.aovs;
    for (const AovName& each : aovNames)
        EXPECT_EQ(passes.*each.asked, each.source == AovSource::passes || each.source == AovSource::lightGroups) << each.name;
}

// Each channel by itself needs a file that can hold it: an EXR, in small or capital letters, which alone gets a PNG beside it.
TEST(Options, ChannelsNeedAnExr) {
    Scene scene;
    const auto filesOf = [&](const std::string& line) { return outputFiles(parse("render a.pbrt " + line).output, scene); };
    for (const AovName& each : aovNames) {
        const std::string aov = std::string("--aov ") + each.name;
        EXPECT_THROW(filesOf(aov + " -o x.jpg -o x.pfm"), UsageError) << each.name;
        EXPECT_THAT(filesOf(aov + " -o x.Exr"), testing::ElementsAre("x.Exr", "x.png")) << each.name;
        EXPECT_THAT(filesOf(aov + " -o x.jpg -o x.EXR"), testing::ElementsAre("x.jpg", "x.EXR")) << each.name;
    }
    EXPECT_THAT(filesOf("-o x.jpg"), testing::ElementsAre("x.jpg"));
}

/// What renderJobs makes of a command line: scene and files, or the error.
std::vector<std::string> jobsOf(const std::string& line) {
    std::vector<std::string> jobs;
    try {
        for (const RenderJob& job : renderJobs(parse("render " + line))) {
            jobs.push_back(job.scene);
            for (const std::string& file : job.files) jobs.back() += " " + file;
            if (!job.checkpoint.empty()) jobs.back() += " " + job.checkpoint;
        }
    } catch (const UsageError& error) { return {error.what()}; }
    return jobs;
}

TEST(Options, SeveralScenesShareAFolderAndNoFile) {
    using testing::ElementsAre;
    EXPECT_THAT(jobsOf("a.pbrt x/b.obj.gz -o out/"), ElementsAre("a.pbrt out/a.exr", "x/b.obj.gz out/b.exr"));
    EXPECT_THAT(jobsOf("a.pbrt - -o out/ --format png"), ElementsAre("a.pbrt out/a.png", "- out/stdin.png"));
    EXPECT_THAT(jobsOf("a.pbrt -o out/ -o b.png"), ElementsAre("a.pbrt out/a.exr b.png"));
    EXPECT_THAT(jobsOf("a.pbrt b.pbrt"), ElementsAre("a.pbrt", "b.pbrt"));
    EXPECT_THAT(jobsOf("a.pbrt b.pbrt -o c.exr"), ElementsAre(HasSubstr("-o FOLDER/")));
    EXPECT_THAT(jobsOf("a.pbrt b.pbrt -o - --format exr"), ElementsAre(HasSubstr("-o FOLDER/")));
    EXPECT_THAT(jobsOf("a.pbrt b.pbrt -o out/ --checkpoint c.film"), ElementsAre(HasSubstr("a call of its own")));
    EXPECT_THAT(jobsOf("a.pbrt x/a.pbrt -o out/"), ElementsAre(HasSubstr("out/a.exr would be the image of both a.pbrt and x/a.pbrt")));
    EXPECT_THAT(jobsOf("a.pbrt -o b.exr -o b.exr"), ElementsAre(HasSubstr("b.exr is named twice")));
    EXPECT_THAT(jobsOf("a.pbrt b.pbrt --deadline 9s -o out/"), ElementsAre(HasSubstr("--time-limit counts for each")));
    EXPECT_THAT(jobsOf("- -"), ElementsAre(HasSubstr("name it once")));
}

TEST(Options, FramesAreNumbersRangesAndSteps) {
    using testing::ElementsAre;
    const auto frames = [](const std::string& list) { return parse("render a.pbrt --fps 1 --frames " + list).frames; };
    EXPECT_THAT(frames("1-10:3,20"), ElementsAre(1, 4, 7, 10, 20));
    EXPECT_THAT(frames("7,3-5,4,007"), ElementsAre(7, 3, 4, 5));
    EXPECT_THAT(frames("0-0"), ElementsAre(0));
    for (const char* bad :
         {"a", "-5", "1-1e9", "1-", "-", "1--2", "1:2", "1-4:0", "1-4:-1", "1,,2", "1.5", "99999999999", "+1", "1-4:2:2"})
        EXPECT_THAT(messageOf("render a.pbrt --fps 1 --frames=" + std::string(bad)), HasSubstr("--frames takes whole numbers from 0"))
            << bad;
    EXPECT_THAT(messageOf("render a.pbrt --fps 1 --frames 10-1"), HasSubstr("the range 10-1 goes down; write 1-10"));
    EXPECT_THAT(messageOf("render a.pbrt --fps 1 --frames 0-2147483647"), HasSubstr("more than 100000 frames"));
    EXPECT_EQ(frameRanges({1, 2, 3, 7, 9, 10}), "1-3, 7, 9-10");
}

TEST(Options, FramesHaveScenesAndFilesOfTheirOwn) {
    using testing::ElementsAre;
    EXPECT_THAT(jobsOf("d#/a.##.pbrt --frames 2,100 -o b#/#.###.exr"),
                ElementsAre("d#/a.02.pbrt b#/2.002.exr", "d#/a.100.pbrt b#/100.100.exr"));
    EXPECT_THAT(jobsOf("a.#.pbrt b.#.pbrt --frames 1-2 -o out/"),
                ElementsAre("a.1.pbrt out/a.1.exr", "a.2.pbrt out/a.2.exr", "b.1.pbrt out/b.1.exr", "b.2.pbrt out/b.2.exr"));
    EXPECT_THAT(jobsOf("a.pbrt --fps 24 --frames 1-2 -o out/"), ElementsAre("a.pbrt out/a.0001.exr", "a.pbrt out/a.0002.exr"));
    EXPECT_THAT(jobsOf("a.#.pbrt --frames 1-2 -o p.##.film"), ElementsAre("a.1.pbrt p.01.film", "a.2.pbrt p.02.film"));
    EXPECT_THAT(jobsOf("a.#.pbrt --frames 1-2"), ElementsAre("a.1.pbrt", "a.2.pbrt"));
    EXPECT_THAT(jobsOf("a.pbrt --fps 24 --frames 7 -o b.exr"), ElementsAre("a.pbrt b.exr"));

    EXPECT_THAT(jobsOf("a.#.pbrt --frames 1-2 -o b.exr"), ElementsAre(HasSubstr("there are 2 frames; write #### where")));
    EXPECT_THAT(jobsOf("a.#.pbrt --frames 1-2 -o - --format exr"), ElementsAre(HasSubstr("there are 2 frames")));
    EXPECT_THAT(jobsOf("a.#.pbrt --frames 1-2 -o p.film"), ElementsAre(HasSubstr("one film, and there are 2 frames")));
    EXPECT_THAT(jobsOf("a.#.pbrt b.#.pbrt --frames 1-2 -o c.#.exr"), ElementsAre(HasSubstr("-o FOLDER/")));
    EXPECT_THAT(jobsOf("a.#.pbrt x/a.#.pbrt --frames 1 -o c/"), ElementsAre(HasSubstr("c/a.1.exr would be the image of both")));
    EXPECT_THAT(jobsOf("a.#.pbrt --frames 1-2 -o c.#.exr -o c.##.exr -o c.#.exr"),
                ElementsAre(HasSubstr("c.1.exr is named twice")));
    EXPECT_THAT(jobsOf("a.pbrt --fps 24 --frames 1-2"), ElementsAre(HasSubstr("need files of their own")));
    EXPECT_THAT(jobsOf("a.pbrt --frames 1 -o b.exr"), ElementsAre(HasSubstr("like scene.####.pbrt; or, if the scene moves")));
    EXPECT_THAT(jobsOf("a.#.pbrt --frames 1 --fps 24 -o b.exr"), ElementsAre(HasSubstr("give one of both")));
    EXPECT_THAT(jobsOf("a.#.pbrt -o b.exr"), ElementsAre(HasSubstr("there is no file \"a.#.pbrt\"; with --frames")));
    EXPECT_THAT(jobsOf("- --fps 1 --frames 1-2 -o b.#.exr"), ElementsAre(HasSubstr("frames need files")));
    EXPECT_THAT(jobsOf("a.#.pbrt --frames 1-2 --view -o b.#.exr"),
                ElementsAre(HasSubstr("--view shows one render, and there are 2 frames")));
    EXPECT_THAT(jobsOf("a.#.pbrt --frames 1-2 --deadline 9s -o b.#.exr"), ElementsAre(HasSubstr("--time-limit counts for each")));
    EXPECT_THAT(jobsOf("a.obj --turntable 2 -o b.#.exr"), ElementsAre("a.obj b.0.exr", "a.obj b.1.exr"));
    EXPECT_THAT(jobsOf("a.obj --turntable 36 --frames 9 -o b.exr"), ElementsAre("a.obj b.exr"));
    EXPECT_THAT(jobsOf("a.pbrt --turntable 2 -o b.#.exr"), ElementsAre(HasSubstr("--turntable is for OBJ files")));
    EXPECT_THAT(jobsOf("a.obj --fps 2 --frames 1 -o b.#.exr"), ElementsAre(HasSubstr("--fps is for pbrt scenes")));
    EXPECT_THAT(messageOf("render a.obj --turntable 0"), HasSubstr("from 1 to 100000"));
    EXPECT_THAT(messageOf("render a.obj --turntable 3 --fps 3 --frames 1"), HasSubstr("give one of them"));
    EXPECT_THAT(messageOf("render a.pbrt --fps 24"), HasSubstr("say which: --frames"));
    EXPECT_THAT(messageOf("render a.pbrt --shutter 0.5 --frames 1"), HasSubstr("--fps 24 --shutter 0.5"));
    EXPECT_THAT(messageOf("render a.pbrt --skip-existing"), HasSubstr("-o names"));
    EXPECT_THAT(messageOf("render a.pbrt --skip-existing -o a.film"), HasSubstr("--resume"));
}

struct BadValue { const char *line, *message; };
void PrintTo(const BadValue& bad, std::ostream* out) { *out << "eikonal " << bad.line; }
class BadValues : public testing::TestWithParam<BadValue> {};

/// A message names the option, what was found, and what would have worked.
TEST_P(BadValues, AreRefusedWithWhatWouldHaveWorked) { EXPECT_THAT(messageOf(GetParam().line), HasSubstr(GetParam().message)); }

INSTANTIATE_TEST_SUITE_P(Options, BadValues, testing::Values(
    BadValue{"render a.pbrt --spp 0", "--spp takes a whole number of at least 1, not \"0\""},
    BadValue{"render a.pbrt --spp 1.5", "--spp takes a whole number of at least 1, not \"1.5\""},
    BadValue{"render a.pbrt --spp 99999999999", "not \"99999999999\""},
    BadValue{"render a.pbrt --spp", "--spp needs a value: --spp N\n"},
    BadValue{"render a.pbrt --port 80", "--port needs --view; add it"},
    BadValue{"render a.pbrt --stats=banana", "--stats takes no value"},
    BadValue{"render a.pbrt --max-error 1 --target-error 2",
             "--target-error and --max-error are the same option, given 2 times; give it once"},
    BadValue{"render a.pbrt --device=", "--device needs a value: --device NAME|INDEX|all"},
    BadValue{"render a.pbrt -o a.film --denoise", "--denoise is of images, and only a film is written"},
    BadValue{"render a.pbrt -o a.film --format png", "--format is for images, and only a film is written; add `-o FILE.png`"},
    BadValue{"render a.pbrt -o a.film --compression zip", "--compression is for images, and only a film is written; add `-o FILE.exr`"},
    BadValue{"render a.pbrt -o a.film --write-partial-images", "only a film is written"},
    BadValue{"denoise a.exr -o a.film", "the extension \".film\" is not known"},
    BadValue{"render a.pbrt --tonemap clmp", "--tonemap is one of clamp, reinhard, filmic, not \"clmp\"; did you mean clamp?"},
    BadValue{"submit a.pbrt --engine slurm -o a.film --exposure 1", "only a film is written"},
    BadValue{"render a.pbrt -o a.film --exposure 1", "--exposure is for images, and only a film is written"},
    BadValue{"render a.pbrt -o a.xyz",
             "the extension \".xyz\" is not known; known are exr hdr pfm png jpg jpeg tif tiff tga bmp webp, and film"},
    BadValue{"render a.pbrt --seed x", "--seed takes a whole number, not \"x\""},
    BadValue{"render a.pbrt --nthreads 0", "--nthreads takes a whole number from 1 to 4096"},
    BadValue{"render a.pbrt --resolution 640", "like 800x600, not \"640\""},
    BadValue{"render a.pbrt --resolution 0x5", "like 800x600, not \"0x5\""},
    BadValue{"render a.pbrt --cropwindow 0,1,1,0", "0 <= y0 < y1 <= 1"},
    BadValue{"render a.pbrt --cropwindow 0,1,0", "not \"0,1,0\""},
    BadValue{"render a.pbrt --cropwindow 0,2,0,1", "not \"0,2,0,1\""},
    BadValue{"render a.pbrt --pixelbounds 5,5,0,1", "0 <= x0 < x1"},
    BadValue{"render a.pbrt --pixelbounds 0,1,0,1 --cropwindow 0,1,0,1", "give one of them"},
    BadValue{"render a.pbrt --sampler sobl", "independent, paddedsobol, sobol, zsobol, not \"sobl\"; did you mean sobol?"},
    BadValue{"render a.pbrt --time-limit 0", "--time-limit takes a time greater than 0"},
    BadValue{"render a.pbrt --time-limit 1ms", "in seconds, minutes or hours, like 90s"},
    BadValue{"render a.pbrt --spp 1 --spp 2", "--spp is given 2 times; give it once"},
    BadValue{"render a.pbrt --time-limit nan", "not \"nan\""},
    BadValue{"render a.pbrt --time-limit inf", "not \"inf\""},
    BadValue{"render a.pbrt --aov albdo", "did you mean albedo?"},
    BadValue{"render a.pbrt --local-size 48", "a power of two"},
    BadValue{"render a.pbrt --contraction maybe", "one of on, off"},
    BadValue{"render a.pbrt --math-flags=intersect_ray:-cl-mad-enable", "did you mean intersect_rays?"},
    BadValue{"render a.pbrt --log-level loud", "silent, error, warning, info, debug"},
    BadValue{"render a.obj --fov 180", "a number between 0 and 180, not \"180\""},
    BadValue{"render a.obj --camera 1,2", "three numbers separated by commas"},
    BadValue{"render a.obj --camera 1,2,3 --look-at 1,2,3", "must differ"},
    BadValue{"render a.obj --up 0,0,0", "must not be 0,0,0"},
    BadValue{"render a.pbrt --samples 3/2 -o a.film", "or part K/M of all, with K from 1 to M, like 2/4, not \"3/2\""},
    BadValue{"render a.pbrt --tile 0/2 -o a.film", "a part I/N, with I from 1 to N, like 2/4, not \"0/2\""},
    BadValue{"bench a.pbrt --repeats 0", "--repeats takes a whole number from 1 to 1000"},
    BadValue{"bench a.pbrt --reference b.exr", "--reference needs --efficiency"},
    BadValue{"bench a.pbrt --efficiency --repeats 3", "--repeats must be at least 4, not 3"}));

INSTANTIATE_TEST_SUITE_P(Commands, BadValues, testing::Values(
    BadValue{"", "eikonal render scene.pbrt -o image.exr"},
    BadValue{"rendr a.pbrt", "did you mean render?"},
    BadValue{"a.pbrt", "did you mean `eikonal render a.pbrt`?"},
    BadValue{"frobnicate", "the commands are render, info, bench, trade, cache, list-devices, compare"},
    BadValue{"render", "needs a scene"},
    BadValue{"info a.pbrt b.pbrt", "\"b.pbrt\""},
    BadValue{"render a.pbrt -o -", "add it: -o - --format exr"},
    BadValue{"render a.pbrt -o - -o - --format exr", "write `-o -` once"},
    BadValue{"render a.pbrt -o - --format exr --json", "the image and --json would both go to standard output"},
    BadValue{"render a.pbrt -o - --format exr --write-partial-images", "standard output holds one"},
    BadValue{"render a.pbrt --format gif", "--format is one of exr, hdr, pfm, png"},
    BadValue{"trade -", "standard input can be read once"},
    BadValue{"render a.pbrt --sp 3", "did you mean --spp?"},
    BadValue{"info a.pbrt --wave-paths 3", "info has no option --wave-paths; render has it"},
    BadValue{"--nonsense-of-all-kinds", "eikonal has no option --nonsense-of-all-kinds"},
    BadValue{"cache a.pbrt", "eikonal cache --warm a.pbrt"},
    BadValue{"cache --warm --no-cache", "--warm keeps kernels and --no-cache keeps none"},
    BadValue{"compare a.exr", "needs two images"},
    BadValue{"denoise", "denoise needs an image"},
    BadValue{"help rendr", "did you mean render?"},
    BadValue{"render a.pbrt --quick", "render has no option --quick; try --quality draft"},
    BadValue{"render a.pbrt --pixel 3,4", "try --pixelbounds x,x+1,y,y+1"},
    BadValue{"render a.pbrt --upgrade", "pbrt --upgrade old.pbrt > scene.pbrt"},
    BadValue{"render a.pbrt --interactive", "try --view"}));

TEST(Options, IntervalsAreOfCheckpointsAndOfImages) {
    for (const char* line : {"render a.pbrt --checkpoint a.film", "render a.pbrt --write-partial-images", "render a.pbrt -o a.film",
                             "submit a.pbrt --engine slurm"})
        EXPECT_EQ(parse(line + std::string(" --checkpoint-every 9s")).output.checkpointEvery, 9) << line;
}

TEST(Options, AnIntervalOfNothingIsWarnedOf) {
    testing::internal::CaptureStderr();
    parse("render a.pbrt --checkpoint-every 9s");
    EXPECT_THAT(testing::internal::GetCapturedStderr(), testing::HasSubstr("--checkpoint-every has no effect here"));
    testing::internal::CaptureStderr();
    parse("render a.pbrt --checkpoint-every 9s --quiet");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Options, SubsurfaceIsOfThePresetUnlessTheUserGaveIt) {
    EXPECT_TRUE(parse("render a.pbrt --quality draft").scene.isSubsurfaceOfPreset);
    EXPECT_FALSE(parse("render a.pbrt --quality draft --subsurface randomwalk").scene.isSubsurfaceOfPreset);
    EXPECT_FALSE(parse("render a.pbrt --subsurface randomwalk").scene.isSubsurfaceOfPreset);
}

/// As of a variable of the shell that is not set.
TEST(Options, NamesAreNotEmptyAndTextForTheCompilerMayBe) {
    const auto problemOf = [](const std::vector<std::string>& words) -> std::string {
        try {
            parseOptions(words);
            return "none";
        } catch (const UsageError& error) { return error.what(); }
    };
    for (const char* option : {"--checkpoint", "--log-file", "--device", "--outfile", "--dump-kernels"})
        EXPECT_THAT(problemOf({"eikonal", "render", "a.pbrt", option, ""}), HasSubstr(option + std::string(" takes "))) << option;
    EXPECT_EQ(problemOf({"eikonal", "bench", "a.pbrt", "--json", ""}), "--json takes FILE, not \"\"");
    EXPECT_EQ(problemOf({"eikonal", "merge", "", "-o", "a.exr"}), "merge PART is empty; give a name");
    EXPECT_EQ(problemOf({"eikonal", "render", "a.pbrt", "--build-options", ""}), "none");
    EXPECT_THAT(parseOptions({"eikonal", "submit", "a.pbrt", "--engine", "slurm", "--build-options", ""}).passedOn, testing::IsEmpty());
}

TEST(Options, OtherCommands) {
    EXPECT_EQ(parse("--list-devices").command, Command::listDevices);
    EXPECT_EQ(parse("list-devices").command, Command::listDevices);
    for (const char* line : {"render --list-devices", "render a.pbrt --list-devices", "bench --list-devices", "cache --list-devices"})
        EXPECT_EQ(parse(line).command, Command::listDevices) << line;
    EXPECT_TRUE(parse("info a.pbrt --json").json);
    EXPECT_EQ(parse("bench a.pbrt --json f.json --repeats 3").jsonFile, "f.json");
    EXPECT_EQ(parse("bench a.pbrt --repeats 3").repeats, 3);
    EXPECT_TRUE(parse("bench a.pbrt --loop").loop);
    EXPECT_FALSE(parse("bench a.pbrt").loop);
    EXPECT_TRUE(parse("bench a.pbrt --efficiency").efficiency);
    const Options cache = parse("cache --clear --warm a.pbrt b.pbrt");
    EXPECT_TRUE(cache.clearCache && cache.warmCache);
    EXPECT_THAT(cache.scenes, testing::ElementsAre("a.pbrt", "b.pbrt"));
    EXPECT_EQ(parse("compare a.exr b.exr").reference, "b.exr");
    EXPECT_EQ(parse("compare a.exr b.exr --fail-above 0.1").failAbove, 0.1);
    EXPECT_EQ(parse("compare a.exr b.exr --heat-map c.png").heatMap, "c.png");
}

TEST(Options, HelpAndVersionAreTextToPrint) {
    for (const char* line : {"--help", "--help-all", "render --help", "--version"}) EXPECT_EQ(parse(line).command, Command::print) << line;
    EXPECT_EQ(parse("--version").text, "eikonal " EIKONAL_VERSION "\n");
    EXPECT_THAT(parse("--help").text, HasSubstr("render"));
    EXPECT_THAT(parse("render --help").text, HasSubstr("--spp"));
    EXPECT_EQ(parse("help render").text, parse("render --help").text);
    EXPECT_EQ(parse("help").text, parse("--help").text);
    const std::string all = parse("--help-all").text;
    for (const std::string& name : allOptionNames()) EXPECT_THAT(all, HasSubstr(name));
}

TEST(Options, TheManualHasEveryOption) {
    std::ifstream file(EIKONAL_SOURCE_DIR "/docs/command-line.md");
    const std::string manual{std::istreambuf_iterator<char>(file), {}};
    ASSERT_FALSE(manual.empty());
    for (const std::string& name : allOptionNames()) EXPECT_THAT(manual, testing::ContainsRegex("`(-o, )?" + name + "[` ]"));
}

TEST(ProgressDisplay, TimesReadLikeAClock) {
    EXPECT_EQ(clockTime(0.9), "0:00");
    EXPECT_EQ(clockTime(75.4), "1:15");
    EXPECT_EQ(clockTime(4000), "1:06:40");
}

}  // namespace
}  // namespace eikonal
