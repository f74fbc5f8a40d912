// The files that a rendering leaves, and what options make of them.

#include "cli.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace eikonal {
namespace {

using testing::HasSubstr;

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
    EXPECT_FALSE(exr.metadata.renderSeconds) << "the file would differ in each run";
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
    ASSERT_EQ(
        run({"render", "tiny.pbrt", "-o", "bounds.exr", "--pixelbounds", "4,12,0,6", "--nthreads", "1", "--wave-paths", "100"}).status, 0);
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

// pbrt-v4 stores matrices for column vectors row by row. The camera of `LookAt 1 2 3  1 2 13  0 1 0` looks along +z from (1, 2, 3), x
// to the right: a translation. `fov` 90 is the angle of the shorter side, the tangent of whose half is 1; depths of 0.01 to 1000 become
// 0 to 1. NDC is half of that plus a half of w, which is z in camera space.
TEST_F(Cli, ExrFilesSayWhereTheCameraIs) {
    const std::string film = "Film \"rgb\" \"integer xresolution\" 16 \"integer yresolution\" 12\n",
                      world = "WorldBegin\nLightSource \"infinite\"\nShape \"sphere\"\n", place = "LookAt 1 2 3  1 2 13  0 1 0\n";
    write("camera.pbrt", place + "Camera \"perspective\" \"float fov\" 90\n" + film + world);
    ASSERT_EQ(run({"render", "camera.pbrt", "--spp", "1", "-o", "a.exr"}).status, 0);
    const Metadata found = readImage(path("a.exr")).metadata;
    ASSERT_TRUE(found.worldToCamera && found.worldToNdc);
    const auto expectNear = [](const std::array<float, 16>& values, const std::array<double, 16>& wanted) {
        for (size_t i = 0; i < 16; ++i) EXPECT_NEAR(values[i], wanted[i], 1e-5) << "row " << i / 4 << ", column " << i % 4;
    };
    const double scale = 1000 / (1000 - 0.01), shift = -0.01 * scale;
    expectNear(*found.worldToCamera, {1, 0, 0, -1, 0, 1, 0, -2, 0, 0, 1, -3, 0, 0, 0, 1});
    expectNear(*found.worldToNdc, {0.5, 0, 0.5, -0.5 - 1.5, 0, 0.5, 0.5, -1 - 1.5, 0, 0, (scale + 1) / 2, (shift - 3 * scale - 3) / 2, 0, 0,
                                   1, -3});

    /* Parts keep the camera */
    ASSERT_EQ(run({"render", "camera.pbrt", "--spp", "1", "-o", "part.film"}).status, 0);
    ASSERT_EQ(run({"merge", "part.film", "-o", "merged.exr"}).status, 0);
    const Metadata merged = readImage(path("merged.exr")).metadata;
    EXPECT_EQ(merged.worldToCamera, found.worldToCamera);
    EXPECT_EQ(merged.worldToNdc, found.worldToNdc);

    write("parallel.pbrt", place + "Camera \"orthographic\"\n" + film + world);
    ASSERT_EQ(run({"render", "parallel.pbrt", "--spp", "1", "-o", "b.exr"}).status, 0);
    expectNear(readImage(path("b.exr")).metadata.worldToNdc.value(), {0.5, 0, 0, 0, 0, 0.5, 0, -0.5, 0, 0, 0.5, -1, 0, 0, 0, 1});
    write("around.pbrt", place + "Camera \"spherical\"\n" + film + world);
    ASSERT_EQ(run({"render", "around.pbrt", "--spp", "1", "-o", "c.exr"}).status, 0);
    EXPECT_TRUE(readImage(path("c.exr")).metadata.worldToCamera);
    EXPECT_FALSE(readImage(path("c.exr")).metadata.worldToNdc) << "as in pbrt, which projects neither";
}

// Loading OpenImageIO takes longer than rendering a small scene, so only a file that it has to decode or encode loads it: neither the sky
// of an OBJ without lamps, nor EXR and PNG.
TEST_F(Cli, OnlyFilesOfImagesLoadOpenImageIo) {
    write("plain.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto loads = [&](const std::string& output) {
        const Outcome run =
            this->run({"render", "plain.obj", "--spp", "1", "--resolution", "16x16", "-o", output}, {{"LD_DEBUG", "files"}});
        EXPECT_EQ(run.status, 0);
        return run.error.find("libOpenImageIO.so") != std::string::npos;
    };
    EXPECT_FALSE(loads("a.exr"));
    EXPECT_TRUE(loads("a.tif")) << "or this test sees nothing";
}

// A user compares the files of two machines by their checksums.
TEST_F(Cli, TwoRunsWriteTheSameBytes) {
    const std::vector<std::string> files = {"a.exr", "a.png", "a.tif", "a.pfm", "a.hdr", "a.jpg"};
    std::vector<std::string> command = {"render", "tiny.pbrt", "--aov", "all"};
    for (const std::string& file : files) command.insert(command.end(), {"-o", file});
    std::vector<std::string> first;
    ASSERT_EQ(run(command).status, 0);
    for (const std::string& file : files) first.push_back(read(path(file)));
    ASSERT_EQ(run(command).status, 0);
    for (size_t i = 0; i < files.size(); ++i) EXPECT_TRUE(read(path(files[i])) == first[i]) << files[i];
    command.push_back("--record-time");
    ASSERT_EQ(run(command).status, 0);
    EXPECT_GE(readImage(path("a.exr")).metadata.renderSeconds.value_or(-1), 0);
}

TEST_F(Cli, FilesAreEncodedAsAskedFor) {
    ASSERT_EQ(run({"render", "tiny.pbrt", "-o", "a.exr", "--aov", "all", "--channel-names", "pbrt", "--pixel-type", "half", "--compression",
                   "piz", "--bit-depth", "16"}).status, 0);
    const FilmImage whole = image("a.exr");
    EXPECT_FALSE(whole.sampleVariance.empty() || whole.relativeVariance.empty() || whole.geometricNormal.empty() || whole.normal.empty());
    EXPECT_EQ(read(path("a.png"))[24], 16) << "the bit depth in IHDR";
    const Outcome late = run({"render", "tiny.pbrt", "-o", "b.jpg", "--bit-depth", "16"});
    EXPECT_EQ(late.status, 2);
    EXPECT_THAT(late.error, HasSubstr("--bit-depth 16: b.jpg holds 8 bits; png and tif hold 16"));
    EXPECT_FALSE(exists("b.jpg"));
    EXPECT_EQ(run({"denoise", "a.exr", "-o", "b.png", "--compression", "zip"}).status, 2);
    ASSERT_EQ(run({"render", "tiny.pbrt", "-o", "part.film", "--aov", "variance"}).status, 0);
    EXPECT_EQ(run({"merge", "part.film", "-o", "b.png", "--channel-names", "pbrt"}).status, 2);
    ASSERT_EQ(run({"merge", "part.film", "-o", "b.exr", "--channel-names", "pbrt"}).status, 0);
    EXPECT_FALSE(image("b.exr").sampleVariance.empty());
}

// pbrt-v4's film "gbuffer" asks for them all, in the camera's space unless it says otherwise; without an EXR that is said.
TEST_F(Cli, AFilmMayAskForAovs) {
    for (const char* space : {"camera", "world"}) {
        std::string scene = tinyScene();
        scene.replace(scene.find("\"rgb\""), 5, std::string("\"gbuffer\" \"string coordinatesystem\" \"") + space + "\"");
        write("gbuffer.pbrt", scene);
        ASSERT_EQ(run({"render", "gbuffer.pbrt", "-o", "a.exr"}).status, 0);
        const FilmImage seen = image("a.exr");
        ASSERT_FALSE(seen.albedo.empty() || seen.normal.empty() || seen.position.empty() || seen.uv.empty() || seen.depthSlope.empty() ||
                     seen.motion.empty() || seen.object.empty() || seen.variance.empty());
        EXPECT_NEAR(seen.position[seen.index(8, 6)].z, space == std::string("camera") ? 4 : 0, 0.1);
    }
    const Outcome run = this->run({"render", "gbuffer.pbrt", "-o", "a.png"});
    EXPECT_EQ(run.status, 0);
    EXPECT_THAT(run.error, HasSubstr("cannot hold them; add `-o FILE.exr`"));
}

// In the space of a camera that turns, what is seen at any time is where it is then: of a sphere around the camera, on which light falls,
// each pixel sees one point of that space. Each has its distance and its normal, and motion is as without the film.
TEST_F(Cli, AFilmMayHaveTheSpaceOfACameraThatMoves) {
    const auto scene = [](const char* film) {
        return std::string("ActiveTransform EndTime Rotate 90 0 1 0 ActiveTransform All Camera \"perspective\" \"float fov\" 60 "
                           "Film \"") + film + "\" \"integer xresolution\" 8 \"integer yresolution\" 8 Sampler \"zsobol\" "
                           "\"integer pixelsamples\" 256 PixelFilter \"box\" WorldBegin LightSource \"point\" Shape \"sphere\" "
                           "\"float radius\" 2";
    };
    write("turning.pbrt", scene("gbuffer"));
    ASSERT_EQ(run({"render", "turning.pbrt", "-o", "a.exr"}).status, 0);
    const FilmImage seen = image("a.exr");
    const glm::vec3 p = seen.position[seen.index(6, 2)], n = seen.normal[seen.index(6, 2)];
    const float x = 2.5f / 4 * std::tan(float(M_PI) / 6), y = 1.5f / 4 * std::tan(float(M_PI) / 6);
    const glm::vec3 expected = 2.f * glm::normalize(glm::vec3(x, y, 1));
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(p[c], expected[c], 5e-3) << c;
        EXPECT_NEAR(std::abs(n[c]), expected[c] / 2, 5e-3) << c;
    }
    write("world.pbrt", scene("rgb"));
    ASSERT_EQ(run({"render", "world.pbrt", "-o", "b.exr", "--aov", "motion,position"}).status, 0);
    const FilmImage inWorld = image("b.exr");
    EXPECT_LT(glm::length(inWorld.position[seen.index(6, 2)]), 1.9f) << "a mean over an arc";
    EXPECT_EQ(seen.color, inWorld.color);
    EXPECT_EQ(seen.motion, inWorld.motion);
}

// pbrt-v4's film "spectral": an EXR has the spectra, beside the channels that are asked for; another file has the colours, and that is
// said.
TEST_F(Cli, AFilmMayKeepSpectra) {
    std::string scene = tinyScene();
    scene.replace(scene.find("\"rgb\""), 5, "\"spectral\" \"integer nbuckets\" 5 \"float lambdamin\" 450 \"float lambdamax\" 700");
    write("spectral.pbrt", scene);
    ASSERT_EQ(run({"render", "spectral.pbrt", "-o", "a.exr", "--aov", "depth", "--spp", "16"}).status, 0);
    const FilmImage seen = image("a.exr");
    EXPECT_EQ(seen.spectrum.wavelengths, (std::vector<double>{475, 525, 575, 625, 675}));
    EXPECT_FALSE(seen.depth.empty());
    EXPECT_GT(seen.spectrum.radiance[seen.index(8, 6) * 5 + 2], 0.01f) << "the square is lit";
    EXPECT_EQ(seen.spectrum.radiance[2], 0) << "nothing is in the corner";
    ASSERT_EQ(run({"render", "spectral.pbrt", "-o", "crop.exr", "--pixelbounds", "4,12,0,6", "--spp", "16", "--wave-paths", "100"}).status,
              0);
    const FilmImage crop = image("crop.exr");
    for (size_t b = 0; b < 5; ++b)
        EXPECT_EQ(crop.spectrum.radiance[crop.index(8, 5) * 5 + b], seen.spectrum.radiance[seen.index(8, 5) * 5 + b]);

    const Outcome png = run({"render", "spectral.pbrt", "-o", "a.png"});
    EXPECT_EQ(png.status, 0);
    EXPECT_THAT(png.error, HasSubstr("cannot hold them; add `-o FILE.exr`"));
    const Outcome inRgb = run({"render", "spectral.pbrt", "-o", "b.exr", "--color", "rgb"});
    EXPECT_EQ(inRgb.status, 1);
    EXPECT_THAT(inRgb.error, testing::ContainsRegex("spectral.pbrt:[0-9]+:[0-9]+: film \"spectral\""));
    EXPECT_FALSE(exists("b.exr"));

    /* A film that is larger than memory is refused before it is begun */
    scene.replace(scene.find("\"integer nbuckets\" 5"), 20, "\"integer nbuckets\" 512");
    write("large.pbrt", scene);
    const Outcome large = run({"render", "large.pbrt", "-o", "b.exr", "--resolution", "60000x60000"});
    EXPECT_EQ(large.status, 1);
    EXPECT_THAT(large.error,
                testing::ContainsRegex(
                    "large.pbrt:[0-9]+:[0-9]+: 60000 x 60000 pixels with spectra of 512 buckets need .*; render parts with --pixelbounds"));
}

TEST_F(Cli, AovsNeedAnExr) {
    write("named.pbrt", "Film \"rgb\" \"string filename\" \"a.jpg\"\nWorldBegin\nShape \"sphere\"\n");
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"tiny.pbrt", "-o", "a.png", "-o", "a.jpg"}, {"named.pbrt"}}) {
        std::vector<std::string> all{"render", "--aov", "object"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        const Outcome run = this->run(all);
        EXPECT_EQ(run.status, 2);
        EXPECT_THAT(run.error, HasSubstr("--aov needs an EXR file"));
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
    EXPECT_THAT(run.error, testing::ContainsRegex("not finite.* the first is in pixel \\([0-9]+, [0-9]+\\)"));
    for (const glm::vec3& c : image("a.exr").color) EXPECT_TRUE(std::isfinite(c.r + c.g + c.b));
}

}  // namespace
}  // namespace eikonal
