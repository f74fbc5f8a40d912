// Mattes by name: coverages are shares of samples, sum to 1, and have the same bits however an image is rendered.

#include "cli.h"
#include "same_files.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <bit>
#include <cmath>

namespace eikonal {
namespace {

using testing::HasSubstr;

/// Two rectangles side by side, which meet at x = 12.25 and end at x = 30, and in front of them two instances of a square. One unit of
/// length is a pixel.
const std::string squares = R"(
LookAt 0 0 -1  0 0 0  0 1 0
Camera "orthographic" "float screenwindow" [0 32 0 16]
Film "rgb" "integer xresolution" 32 "integer yresolution" 16 "string filename" "squares.exr"
Sampler "independent" "integer pixelsamples" 64
Integrator "path" "integer maxdepth" 2
FILTER
WorldBegin
LightSource "distant" "point3 from" [0 0 -1]
MakeNamedMaterial "red" "string type" "diffuse" "rgb reflectance" [.8 .1 .1]
MakeNamedMaterial "mirror" "string type" "conductor" "float roughness" 0
ObjectBegin "tile"
  Material "diffuse"
  Shape "bilinearmesh" "point3 P" [0 0 0  1 0 0  0 1 0  1 1 0]
ObjectEnd
AttributeBegin
  NamedMaterial "red"
  Shape "bilinearmesh" "point3 P" [-50 -50 5  12.25 -50 5  -50 50 5  12.25 50 5]
AttributeEnd
AttributeBegin
  NamedMaterial "mirror"
  Shape "trianglemesh" "point3 P" [12.25 -50 5  30 -50 5  30 50 5  12.25 50 5] "integer indices" [0 1 2 0 2 3]
AttributeEnd
AttributeBegin Translate 20.5 3.5 1 ObjectInstance "tile" AttributeEnd
AttributeBegin Translate 12.5 9 1 ObjectInstance "tile" AttributeEnd
)";

class Cryptomatte : public Cli {
protected:
    void writeSquares(const std::string& filter) {
        std::string text = squares;
        write("squares.pbrt", text.replace(text.find("FILTER"), 6, filter));
    }
    FilmImage render(const std::vector<std::string>& more, const std::string& file = "a.exr") const {
        std::vector<std::string> words{"render", "squares.pbrt", "--aov", "cryptomatte", "-o", file};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        return image(file);
    }
};

float coverage(const CryptomatteLayer& layer, size_t pixel, float id) {
    float sum = 0;
    for (size_t rank = 0; rank < CryptomatteLayer::ranks; ++rank) {
        const float* const entry = &layer.values[pixel * CryptomatteLayer::perPixel + 2 * rank];
        if (std::bit_cast<uint>(entry[0]) == std::bit_cast<uint>(id)) sum += entry[1];
    }
    return sum;
}
float coverage(const CryptomatteLayer& layer, size_t pixel, const std::string& name) {
    return coverage(layer, pixel, std::bit_cast<float>(cryptomatteId(name)));
}

TEST_F(Cryptomatte, CoversWhatTheCameraSees) {
    writeSquares("PixelFilter \"box\"");
    const FilmImage image = render({"--spp", "1024"});
    ASSERT_EQ(image.cryptomattes.size(), 2u);
    const CryptomatteLayer &objects = image.cryptomattes[0], &materials = image.cryptomattes[1];
    EXPECT_EQ(objects.name, "CryptoObject");
    EXPECT_EQ(materials.name, "CryptoMaterial");
    const std::string left = "bilinear@squares.pbrt:18", right = "triangle@squares.pbrt:22", unnamed = "diffuse@squares.pbrt:13";
    for (const std::string& name : {left, right, std::string("tile")}) EXPECT_THAT(objects.manifest, HasSubstr('"' + name + '"'));
    for (const std::string& name : {unnamed, std::string("red"), std::string("mirror")})
        EXPECT_THAT(materials.manifest, HasSubstr('"' + name + '"'));

    /* Shares of area. 1024 samples: a standard deviation of at most 1/64 */
    const auto expect = [&](int x, int y, const CryptomatteLayer& layer, const std::string& name, double area) {
        EXPECT_NEAR(coverage(layer, image.index(x, y), name), area, area * (1 - area) > 0 ? 5. / 64 : 0) << x << ", " << y << " " << name;
    };
    expect(3, 8, objects, left, 1);
    expect(3, 8, materials, "red", 1);
    expect(12, 2, objects, left, .25);
    expect(12, 2, objects, right, .75);
    expect(25, 2, materials, "mirror", 1);
    /* y of the image goes down: row r is from 16 - r - 1 to 16 - r */
    for (const auto& [x, y] : {std::pair{20, 12}, {21, 12}, {20, 11}, {21, 11}}) expect(x, y, objects, "tile", .25);
    expect(12, 6, objects, "tile", .5);
    expect(12, 6, objects, left, .25);
    expect(12, 6, objects, right, .25);
    expect(12, 6, materials, unnamed, .5);
    EXPECT_EQ(coverage(objects, image.index(31, 3), 0.f), 1) << "no surface";

    for (const CryptomatteLayer& layer : image.cryptomattes)
        for (size_t i = 0; i < image.pixelCount(); ++i) {
            double sum = 0, before = 1;
            for (size_t rank = 0; rank < CryptomatteLayer::ranks; ++rank) {
                const double covered = layer.values[i * CryptomatteLayer::perPixel + 2 * rank + 1];
                EXPECT_LE(covered, before) << "of falling coverage";
                sum += before = covered;
            }
            EXPECT_NEAR(sum, 1, 1e-6);
        }
}

/// Signed weights: coverages still sum to 1.
TEST_F(Cryptomatte, HasTheWeightsOfTheImage) {
    writeSquares("PixelFilter \"mitchell\"");
    const FilmImage image = render({"--spp", "64"});
    const CryptomatteLayer& objects = image.cryptomattes.front();
    bool isNegative = false;
    for (size_t i = 0; i < image.pixelCount(); ++i) {
        double sum = 0;
        for (size_t rank = 0; rank < CryptomatteLayer::ranks; ++rank) {
            const float covered = objects.values[i * CryptomatteLayer::perPixel + 2 * rank + 1];
            sum += covered;
            isNegative |= covered < 0;
        }
        EXPECT_NEAR(sum, 1, 1e-5);
    }
    EXPECT_TRUE(isNegative) << "a lobe of the filter is";
}

TEST_F(Cryptomatte, HasTheSameBitsHoweverItIsRendered) {
    writeSquares("PixelFilter \"gaussian\"");
    render({"--spp", "600"}, "whole.exr");
    render({"--spp", "600", "--wave-paths", "1024", "--nthreads", "1"}, "small.exr");
    expectSameFiles(path("whole.exr"), path("small.exr"));
    std::vector<std::string> merge{"merge", "-o", "merged.exr"};
    for (const std::string tile : {"1/2", "2/2"})
        for (const std::string samples : {"48:600", "0:48"}) {
            merge.push_back("part" + std::to_string(merge.size()) + ".film");
            const Outcome part = run({"render", "squares.pbrt", "--aov", "cryptomatte", "--spp", "600", "--tile", tile, "--samples",
                                      samples, "-o", merge.back()});
            ASSERT_EQ(part.status, 0) << part.error;
        }
    const Outcome merged = run(merge);
    ASSERT_EQ(merged.status, 0) << merged.error;
    expectSameFiles(path("whole.exr"), path("merged.exr"));
    EXPECT_THAT(image("merged.exr").cryptomattes.back().manifest, HasSubstr("\"mirror\""));
}

/// Resumed, in parts and in small waves, also where a pixel shows more names than its slots hold, so that some lose theirs: disks of radius
/// 0.1, each its own object, 19 of them in a pixel of a square of 1.5.
TEST_F(Cryptomatte, HasTheSameBitsWhenItGoesOn) {
    std::string scene = "Film \"rgb\" \"integer xresolution\" 4 \"integer yresolution\" 4 Sampler \"independent\"\n"
                        "PixelFilter \"gaussian\" LookAt 0 0 -9 0 0 0 0 1 0 Camera \"perspective\" \"float fov\" 37 WorldBegin\n";
    for (int i = 0; i < 300; ++i)
        scene += fmt::format("Material \"diffuse\"\nAttributeBegin Translate {} {} 0 Shape \"disk\" \"float radius\" .1 AttributeEnd\n",
                             i * 37 % 300 * .02 - 3, i * 101 % 300 * .02 - 3);
    write("crowd.pbrt", scene);
    const auto render = [&](const std::string& image, std::vector<std::string> more) {
        more.insert(more.begin(), {"render", "crowd.pbrt", "--aov", "cryptomatte", "-o", image});
        return run(more).status;
    };
    ASSERT_EQ(render("whole.exr", {"--spp", "3000"}), 0);
    ASSERT_EQ(render("small.exr", {"--spp", "3000", "--wave-paths", "777", "--nthreads", "1"}), 0);
    expectSameFiles(path("whole.exr"), path("small.exr"));

    const std::vector<std::string> checkpoint{"--checkpoint", "c.film", "--resume"};
    const auto with = [&](std::vector<std::string> words) {
        words.insert(words.end(), checkpoint.begin(), checkpoint.end());
        return words;
    };
    for (const char* samples : {"24", "600", "1100"}) ASSERT_EQ(render("resumed.exr", with({"--spp", samples})), 0);
    render("resumed.exr", with({"--spp", "3000", "--time-limit", "0.02"}));
    ASSERT_EQ(render("resumed.exr", with({"--spp", "3000"})), 0);
    expectSameFiles(path("whole.exr"), path("resumed.exr"));

    std::vector<std::string> merge{"merge", "-o", "merged.exr"};
    for (const std::string samples : {"1600:3000", "0:1008", "1008:1600"}) {
        merge.push_back("part" + std::to_string(merge.size()) + ".film");
        ASSERT_EQ(render(merge.back(), {"--spp", "3000", "--samples", samples}), 0);
    }
    ASSERT_EQ(run(merge).status, 0);
    expectSameFiles(path("whole.exr"), path("merged.exr"));
}

/// Other channels keep their bits, IDs theirs where colours have 16, and what would change them is refused.
TEST_F(Cryptomatte, KeepsBits) {
    writeSquares("");
    ASSERT_EQ(run({"render", "squares.pbrt", "-o", "plain.exr"}).status, 0);
    const FilmImage with = render({});
    EXPECT_EQ(image("plain.exr").color, with.color);
    for (const char* names : {"eikonal", "pbrt"})
        EXPECT_EQ(render({"--pixel-type", "half", "--channel-names", names}, "half.exr").cryptomattes[0].values,
                  with.cryptomattes[0].values);
    const Outcome lossy = run({"render", "squares.pbrt", "--aov", "cryptoObject", "--compression", "pxr24", "-o", "lossy.exr"});
    EXPECT_EQ(lossy.status, 2);
    EXPECT_THAT(lossy.error, HasSubstr("the others change the IDs"));
    const std::vector<std::string> one{"render", "squares.pbrt", "--aov", "cryptoMaterial", "-o", "one.exr"};
    ASSERT_EQ(run(one).status, 0);
    ASSERT_EQ(image("one.exr").cryptomattes.size(), 1u);
    EXPECT_EQ(image("one.exr").cryptomattes[0].values, with.cryptomattes[1].values);
}

TEST_F(Cryptomatte, NamesOfAnObj) {
    write("model.obj", "mtllib model.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 4\no chair\nusemtl wood\nf 1 2 3\n");
    write("model.mtl", "newmtl wood\nKd 1 0 0\n");
    ASSERT_EQ(run({"render", "model.obj", "--aov", "cryptomatte", "--spp", "1", "--resolution", "8x8", "-o", "obj.exr"}).status, 0);
    const FilmImage found = image("obj.exr");
    EXPECT_EQ(found.cryptomattes.at(0).manifest,
              cryptomatteManifest({{"chair", cryptomatteId("chair")}, {"model", cryptomatteId("model")}}));
    EXPECT_THAT(found.cryptomattes.at(1).manifest, HasSubstr("\"wood\""));
}

}  // namespace
}  // namespace eikonal
