// Animations: the frames of scenes.

#include "cli.h"
#include "same_files.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <sstream>

namespace eikonal {
namespace {

using testing::HasSubstr;
using Words = std::vector<std::string>;

class Frames : public Cli {
protected:
    /// Renders scene.pbrt, where a square moves to the right from time 0 to 2.
    void writeMovingScene() { write("scene.pbrt", movingScene("0", "0.25")); }
    static std::string movingScene(const std::string& opens, const std::string& closes) {
        std::string scene = tinyScene("TransformTimes 0 2", "ActiveTransform EndTime Translate 1.5 0 0 ActiveTransform All");
        const std::string camera = "\"float fov\" 40";
        return scene.insert(scene.find(camera), "\"float shutteropen\" " + opens + " \"float shutterclose\" " + closes + " ");
    }
    /// Scenes of frames 1, 2 and 4: the square comes nearer.
    void writeScenes() {
        for (const char* number : {"1", "2", "4"})
            write("s.000" + std::string(number) + ".pbrt", tinyScene("", "Translate 0 0 -0." + std::string(number)));
    }
};

TEST_F(Frames, HaveTheBitsOfSingleRuns) {
    writeScenes();
    const Outcome all = run({"render", "s.####.pbrt", "--frames", "1-2,4", "-o", "f.###.exr", "--aov", "depth"});
    ASSERT_EQ(all.status, 0) << all.error;
    for (const char* n : {"1", "2", "4"}) {
        const std::string number = n;
        ASSERT_EQ(run({"render", "s.000" + number + ".pbrt", "-o", "alone.exr", "--aov", "depth"}).status, 0);
        expectSameFiles(path("f.00" + number + ".exr"), path("alone.exr"));
        EXPECT_TRUE(exists("f.00" + number + ".png"));
    }
    EXPECT_NE(image("f.001.exr").color, image("f.002.exr").color);
}

/// Frame f of a scene that moves is the scene whose shutter opens f / fps later.
TEST_F(Frames, OfOneSceneMoveTheShutter) {
    writeMovingScene();
    const Outcome all = run({"render", "scene.pbrt", "--frames", "0-3:3", "--fps", "2", "-o", "out.##.exr", "--spp", "16"});
    ASSERT_EQ(all.status, 0) << all.error;
    write("later.pbrt", movingScene("1.5", "1.75"));
    ASSERT_EQ(run({"render", "later.pbrt", "-o", "later.exr", "--spp", "16"}).status, 0);
    ASSERT_EQ(run({"render", "scene.pbrt", "-o", "first.exr", "--spp", "16"}).status, 0);
    ASSERT_EQ(run({"render", "scene.pbrt", "--frames", "3", "--fps", "2", "-o", "alone.exr", "--spp", "16"}).status, 0);
    expectSameFiles(path("out.03.exr"), path("later.exr"));
    expectSameFiles(path("out.03.exr"), path("alone.exr"));
    expectSameFiles(path("out.00.exr"), path("first.exr"));
    EXPECT_NE(image("out.00.exr").color, image("out.03.exr").color);

    /* The share of a frame that the shutter is open */
    write("wide.pbrt", movingScene("0.5", "0.75"));
    ASSERT_EQ(run({"render", "wide.pbrt", "-o", "wide.exr", "--spp", "16"}).status, 0);
    write("long.pbrt", movingScene("0", "1"));
    ASSERT_EQ(run({"render", "long.pbrt", "--frames", "1", "--fps", "2", "--shutter", "0.5", "-o", "short.exr", "--spp", "16"}).status, 0);
    expectSameFiles(path("wide.exr"), path("short.exr"));
    const Outcome still = run({"render", "tiny.pbrt", "--frames", "1-2", "--fps", "24", "-o", "still.#.exr"});
    EXPECT_EQ(still.status, 0);
    EXPECT_THAT(still.error, HasSubstr("warning: --fps: nothing moves in this scene"));
}

/// All that are missing are told first; the others are rendered, also after one that fails.
TEST_F(Frames, ThatFailDoNotKeepTheOthersFromRendering) {
    writeScenes();
    write("s.0002.pbrt", "WorldBegin Shape \"a\"\n");
    const Outcome run = this->run({"render", "s.####.pbrt", "--frames", "0-6", "-o", "f.#.exr"});
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.error, testing::StartsWith("error: s.####.pbrt has no file for frames 0, 3, 5-6: there is no \"s.0000.pbrt\""));
    EXPECT_THAT(run.error, HasSubstr("s.0002.pbrt:1:12: "));
    EXPECT_THAT(run.error, HasSubstr("s.0002.pbrt was not rendered"));
    EXPECT_TRUE(exists("f.1.exr") && exists("f.4.exr") && !exists("f.2.exr"));
    EXPECT_EQ(this->run({"render", "s.####.pbrt", "--frames", "1-4", "-o", "f.#.exr", "--time-limit", "0.2", "--spp", "100000000"}).status,
              1)
        << "an error is worse than a partial image";
}

/// What is there is left alone, unless it is damaged or partial.
TEST_F(Frames, ThatAreThereAreSkipped) {
    writeScenes();
    const Words render{"render", "s.####.pbrt", "--frames", "1-2,4", "-o", "f.#.exr"};
    const auto again = [&](Words more) {
        Words words = render;
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    };
    ASSERT_EQ(again({}).status, 0);
    const FilmImage whole = image("f.2.exr");
    const auto written = std::filesystem::last_write_time(path("f.1.exr"));
    std::filesystem::resize_file(path("f.2.exr"), 400);
    std::filesystem::remove(path("f.4.png"));
    const Outcome rest = again({"--skip-existing", "--json"});
    ASSERT_EQ(rest.status, 0) << rest.error;
    EXPECT_THAT(rest.error, HasSubstr("skipped s.0001.pbrt: the images are there"));
    EXPECT_THAT(rest.error, HasSubstr("f.2.exr is rendered again: cannot read image"));
    EXPECT_EQ(std::filesystem::last_write_time(path("f.1.exr")), written);
    EXPECT_EQ(image("f.2.exr").color, whole.color);
    EXPECT_TRUE(exists("f.4.png"));
    std::istringstream lines(rest.out);
    std::string line;
    std::vector<std::pair<int, bool>> told;
    while (std::getline(lines, line)) {
        const auto json = nlohmann::json::parse(line);
        told.emplace_back(json.at("frame"), json.value("isSkipped", false));
    }
    EXPECT_EQ(told, (std::vector<std::pair<int, bool>>{{1, true}, {2, false}, {4, false}}));

    EXPECT_THAT(again({"--skip-existing", "--spp", "8"}).error, HasSubstr("f.1.exr is rendered again: it has 4 of 8 samples per pixel"));
    EXPECT_THAT(again({"--skip-existing", "--resolution", "20x10"}).error, HasSubstr("f.4.png is rendered again: it has 16 x 12 pixels"));
    for (const char* file : {"part.exr", "part.png"}) {
        ASSERT_EQ(run({"render", "tiny.pbrt", "-o", file, "--time-limit", "0.2", "--spp", "100000000"}).status, 4);
        const Outcome finished = run({"render", "tiny.pbrt", "-o", file, "--skip-existing"});
        EXPECT_THAT(finished.error, HasSubstr(std::string(file) + " is rendered again: it is partial: ended by --time-limit: "));
        EXPECT_EQ(run({"render", "tiny.pbrt", "-o", file, "--skip-existing"}).error,
                  "skipped tiny.pbrt: the image" + std::string(file == std::string("part.exr") ? "s are" : " is") + " there\n");
    }
}

/// A whole image of something else than the options ask for is rendered again: it lacks a layer, or shows another part.
TEST_F(Frames, ThatAreThereInAnotherFormAreRenderedAgain) {
    const auto render = [&](Words more) {
        more.insert(more.begin(), {"render", "tiny.pbrt", "--spp", "2", "--skip-existing"});
        const Outcome outcome = run(more);
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        return outcome.error;
    };
    const Words layers{"-o", "a.exr", "--aov", "all,cryptomatte,lightgroups"};
    render({"-o", "a.exr", "--aov", "depth,cryptoObject"});
    EXPECT_THAT(render(layers), HasSubstr("a.exr is rendered again: it has no layer \"albedo\""));
    EXPECT_THAT(render(layers), HasSubstr("skipped tiny.pbrt"));
    EXPECT_THAT(render({"-o", "a.exr", "--aov", "depth"}), HasSubstr("skipped tiny.pbrt"));
    EXPECT_THAT(render({"-o", "a.exr", "--aov", "all", "--channel-names", "pbrt"}), HasSubstr("skipped tiny.pbrt"));
    const Words part{"-o", "b.exr", "--pixelbounds", "2,6,2,6"}, small{"-o", "b.png", "--resolution", "16x12", "--cropwindow", "0,0.5,0,1"};
    render({"-o", "b.exr"});
    EXPECT_THAT(render(part), HasSubstr("b.exr is rendered again: it shows another part of the image"));
    EXPECT_THAT(render(part), HasSubstr("skipped tiny.pbrt"));
    EXPECT_THAT(render(small), HasSubstr("b.png is rendered again: it shows another part of the image"));
    EXPECT_THAT(render(small), HasSubstr("skipped tiny.pbrt"));
}

/// Each frame has a film of its own, from which it goes on.
TEST_F(Frames, HaveCheckpointsOfTheirOwn) {
    writeMovingScene();
    const Words render{"render", "scene.pbrt", "--frames", "1-2", "--fps", "2", "--spp", "32"};
    const auto with = [&](Words more) {
        Words words = render;
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    };
    ASSERT_EQ(with({"-o", "p.#.film", "--samples", "1/2"}).status, 0);
    ASSERT_EQ(with({"-o", "q.#.film", "--samples", "2/2"}).status, 0);
    ASSERT_EQ(with({"-o", "whole.#.exr"}).status, 0);
    for (const std::string n : {"1", "2"}) {
        ASSERT_EQ(run({"merge", "p." + n + ".film", "q." + n + ".film", "-o", "m.exr"}).status, 0);
        expectSameFiles(path("m.exr"), path("whole." + n + ".exr"));
    }
    EXPECT_THAT(run({"merge", "p.1.film", "q.2.film", "-o", "m.exr"}).error, HasSubstr("is of another render"));
    const Outcome resumed = with({"-o", "p.#.film", "--samples", "1/2", "--resume"});
    EXPECT_EQ(resumed.status, 0);
    EXPECT_THAT(resumed.error, HasSubstr("p.2.film has all samples"));
}

/// An image that frames share is decoded once; one that changes meanwhile is not taken for what it was.
TEST_F(Frames, ShareImagesThatStayTheSame) {
    const std::string textured = tinyScene("",
                                           "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"wall.png\" "
                                           "Material \"diffuse\" \"texture reflectance\" \"t\" Translate 0 0 -1 Shape \"sphere\"");
    for (const char* name : {"s.1.pbrt", "s.2.pbrt", "s.3.pbrt"}) write(name, textured);
    ASSERT_EQ(run({"render", "tiny.pbrt", "-o", "wall.png"}).status, 0);
    const Outcome same = run({"render", "s.#.pbrt", "--frames", "1-3", "-o", "f.#.exr", "--json"});
    ASSERT_EQ(same.status, 0) << same.error;
    expectSameFiles(path("f.1.exr"), path("f.3.exr"));
    std::istringstream lines(same.out);
    for (std::string line; std::getline(lines, line);)
        EXPECT_EQ(nlohmann::json::parse(line).at("hashes").at("files").size(), 2u) << "the image is of each frame";

    /* A frame that the next one reads */
    write("s.2.pbrt", tinyScene("", "Translate 0 0 0.5"));
    const Outcome fed = run({"render", "s.1.pbrt", "s.2.pbrt", "s.3.pbrt", "-o", "./", "--format", "png"});
    ASSERT_EQ(fed.status, 0) << fed.error;
    const FilmImage before = image("s.1.png");
    std::string reads = textured;
    reads.replace(reads.find("wall.png"), 8, "s.2.png");
    write("s.1.pbrt", reads);
    write("s.3.pbrt", reads);
    write("s.2.pbrt", tinyScene("", "Translate 1 0 0"));
    ASSERT_EQ(run({"render", "s.1.pbrt", "s.2.pbrt", "s.3.pbrt", "-o", "./", "--format", "png"}).status, 0);
    const FilmImage third = image("s.3.png");
    ASSERT_EQ(run({"render", "s.3.pbrt", "-o", "alone.png"}).status, 0);
    EXPECT_EQ(third.color, image("alone.png").color);
    EXPECT_NE(third.color, image("s.1.png").color);
}

/// A frame of a turntable has the bits of a run for it alone, and is what a camera at that place sees.
TEST_F(Frames, OfATurntableGoRoundTheModel) {
    write("model.obj",
          "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv 0 1.5 0\nf 4 3 5\nf 3 2 5\nf 2 1 5\nf 1 4 5\nf 1 2 3 4\n"
          "v 1.5 0 0\nv 1.5 .5 0\nv 1 .5 0\nf 6 7 8\n");
    const Words settings{"--resolution", "24x16", "--spp", "4"};
    const auto render = [&](Words words) {
        words.insert(words.begin(), {"render", "model.obj"});
        words.insert(words.end(), settings.begin(), settings.end());
        return run(words);
    };
    ASSERT_EQ(render({"--turntable", "4", "-o", "t.##.exr"}).status, 0);
    for (const char* number : {"00", "01", "02", "03"}) EXPECT_TRUE(exists("t." + std::string(number) + ".exr"));
    EXPECT_FALSE(exists("t.04.exr"));
    ASSERT_EQ(render({"--turntable", "4", "--frames", "3", "-o", "alone.exr"}).status, 0);
    expectSameFiles(path("t.03.exr"), path("alone.exr"));
    ASSERT_EQ(render({"--turntable", "4", "--frames", "7", "-o", "again.exr"}).status, 0);
    expectSameFiles(path("t.03.exr"), path("again.exr"));
    EXPECT_NE(image("t.01.exr").color, image("t.03.exr").color);

    /* A camera that the user places, after a quarter of a turn */
    const Words view{"--look-at", "0,0.5,0", "--fov", "40"};
    const auto at = [&](Words words) {
        words.insert(words.end(), view.begin(), view.end());
        return render(words);
    };
    ASSERT_EQ(at({"--camera", "0,2,6", "--turntable", "4", "--frames", "0", "-o", "q.exr", "--aov", "depth"}).status, 0);
    ASSERT_EQ(at({"--camera", "0,2,6", "-o", "placed.exr", "--aov", "depth"}).status, 0);
    expectSameFiles(path("q.exr"), path("placed.exr"));
}

TEST_F(Frames, AreToldInProgress) {
    writeScenes();
    const Outcome json = run({"render", "s.####.pbrt", "--frames", "2,4", "-o", "f.#.exr", "--progress", "json"});
    EXPECT_THAT(json.error, HasSubstr("\"frame\":4,\"render\":2,\"rendersInAll\":2"));
    const Outcome openjd = run({"render", "s.####.pbrt", "--frames", "2,4", "-o", "f.#.exr", "--progress", "openjd"});
    EXPECT_THAT(openjd.error, HasSubstr("openjd_progress: 50.0\n"));
    EXPECT_THAT(openjd.error, HasSubstr("openjd_progress: 100.0\nopenjd_status: rendering, frame 4, 2 of 2"));
}

}  // namespace
}  // namespace eikonal
