// EXR files with 16-bit floats: which channels have them, and what becomes of values that they cannot hold.

#include <OpenImageIO/imageio.h>

#include "image/image_file.h"
#include "unit/temporary_folder.h"

#include <gmock/gmock.h>

#include <map>

namespace eikonal {
namespace {

using HalfFloats = TemporaryFolder;

FilmImage sample() {
    FilmImage image(2, 1);
    image.color = {{1.f / 3, 1e6f, -1e6f}, {65504, 65520, 0}};
    image.albedo = {glm::vec3(1.f / 3), glm::vec3(0.5f)};
    image.depth = {1.f / 3, 12345.678f};
    image.object = {4097, 1};
    image.variance = {1e-9f, 1};
    return image;
}

std::map<std::string, std::string> typesIn(const std::string& path) {
    const auto file = OIIO::ImageInput::open(path);
    std::map<std::string, std::string> types;
    for (int c = 0; c < file->spec().nchannels; ++c)
        types[file->spec().channelnames[static_cast<size_t>(c)]] = file->spec().channelformat(c).c_str();
    return types;
}

TEST_F(HalfFloats, AreForWhatHasFewDigits) {
    FilmImage image = sample();
    writeImage(path("full.exr"), image, {});
    image.halfFloats = true;
    writeImage(path("half.exr"), image, {});
    for (const auto& [channel, type] : typesIn(path("full.exr"))) EXPECT_EQ(type, "float") << channel;
    for (const auto& [channel, type] : typesIn(path("half.exr"))) {
        const bool isColor = channel == "R" || channel == "G" || channel == "B" || channel.starts_with("albedo");
        EXPECT_EQ(type, isColor ? "half" : "float") << channel;
    }
}

// A half has 11 binary digits: 1/3 = 2^-2 * 1.0101010101|01..., so it becomes 2^-2 * (1 + 341/1024) = 1365 / 4096. The greatest is 65504.
TEST_F(HalfFloats, RoundAndClamp) {
    FilmImage image = sample();
    image.halfFloats = true;
    writeImage(path("half.exr"), image, {});
    const FilmImage read = readImage(path("half.exr")).image;
    EXPECT_EQ(read.color[0], glm::vec3(1365.f / 4096, 65504, -65504));
    EXPECT_EQ(read.color[1], glm::vec3(65504, 65504, 0));
    EXPECT_EQ(read.albedo[0], glm::vec3(1365.f / 4096));
    EXPECT_EQ(read.depth, image.depth);
    EXPECT_EQ(read.object, image.object);
    EXPECT_EQ(read.variance, image.variance);
}

}  // namespace
}  // namespace eikonal
