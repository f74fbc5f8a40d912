// What is read of an image file: the right texel in the right place, decoded as pbrt-v4 would.

#include <OpenImageIO/imageio.h>

#include "read/formats/image.h"

#include "available_memory.h"
#include "image/equal_area.h"
#include "unit/temporary_folder.h"

#include <gmock/gmock.h>
#include <zlib.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace eikonal {
namespace {

using OIIO::TypeDesc;
using testing::HasSubstr;

class Image : public TemporaryFolder {
protected:
    /// Writes values in [0, 1] (or any, for floats) of a width x height image with OpenImageIO.
    std::string save(const std::string& name, int width, int height, const std::vector<std::string>& channels, TypeDesc type,
                     const std::vector<float>& values,
                     const std::vector<std::pair<std::string, std::vector<float>>>& attributes = {}) const {
        OIIO::ImageSpec spec(width, height, static_cast<int>(channels.size()), type);
        spec.channelnames = channels;
        spec.attribute("oiio:UnassociatedAlpha", 1);
        spec.attribute("compression", "none");
        for (const auto& [key, value] : attributes)
            spec.attribute(key, TypeDesc(TypeDesc::FLOAT, static_cast<int>(value.size())), value.data());
        auto output = OIIO::ImageOutput::create(path(name));
        EXPECT_TRUE(output && output->open(path(name), spec) && output->write_image(TypeDesc::FLOAT, values.data()) && output->close())
            << OIIO::geterror();
        return path(name);
    }
    ImageData load(const std::string& file, ColorEncoding encoding = ColorEncoding::automatic, double gamma = 0) const {
        return *loadImage(ImageFile{.path = file, .encoding = encoding, .gamma = gamma});
    }
    std::string errorOf(const std::string& file) const {
        try {
            loadImage(ImageFile{.path = file, .where = {std::make_shared<std::string>("scene.pbrt"), 4, 9}});
            return "no error";
        } catch (const SceneError& error) { return error.what(); }
    }

    /// 2 x 2: black and white above, red and half grey below.
    const std::vector<float> colors_{0, 0, 0, 1, 1, 1, 1, 0, 0, 128 / 255.f, 128 / 255.f, 128 / 255.f};
};

void expectColors(const ImageData& image, double grey, double tolerance) {
    ASSERT_EQ(image.width, 2);
    ASSERT_EQ(image.height, 2);
    ASSERT_EQ(image.channels, 3);
    const double expected[2][2][3] = {{{0, 0, 0}, {1, 1, 1}}, {{1, 0, 0}, {grey, grey, grey}}};
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 2; ++x)
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(image.at(x, y, c), expected[y][x][c], tolerance) << x << ' ' << y << ' ' << c;
}

const double srgbGrey = std::pow((128 / 255. + 0.055) / 1.055, 2.4);
const std::vector<std::string> rgb{"R", "G", "B"}, rgba{"R", "G", "B", "A"};

TEST_F(Image, eightBitFilesStayEightBit) {
    for (const char* name : {"a.png", "a.tga", "a.bmp", "a.tif"}) {
        const std::string file = save(name, 2, 2, rgb, TypeDesc::UINT8, colors_);
        EXPECT_EQ(load(file).format, format_srgb8) << name;
        EXPECT_EQ(load(file).bytes.size(), 12u);
        expectColors(load(file), srgbGrey, 1e-6);
        EXPECT_EQ(load(file, ColorEncoding::linear).format, format_linear8) << name;
        expectColors(load(file, ColorEncoding::linear), 128 / 255., 1e-6);
        EXPECT_EQ(load(file, ColorEncoding::automatic, 2.2).format, format_float) << name;
        expectColors(load(file, ColorEncoding::automatic, 2.2), std::pow(128 / 255., 2.2), 1e-6);
    }
}

TEST_F(Image, jpegIsReadAsSrgb) {
    const ImageData image = load(save("a.jpg", 8, 8, rgb, TypeDesc::UINT8, std::vector<float>(3 * 64, 128 / 255.f)));
    EXPECT_EQ(image.format, format_srgb8);
    EXPECT_NEAR(image.at(3, 3, 1), srgbGrey, 0.01);
}

TEST_F(Image, sixteenBitFilesAreDecodedToFloats) {
    const std::string file = save("a.png", 2, 2, rgb, TypeDesc::UINT16, colors_);
    EXPECT_EQ(load(file).format, format_float);
    expectColors(load(file), srgbGrey, 2e-5);
    expectColors(load(file, ColorEncoding::linear), 128 / 255., 1e-5);
}

TEST_F(Image, floatsAreLinearWhateverTheEncoding) {
    for (const auto& [name, type, tolerance] :
         {std::tuple{"a.exr", TypeDesc::FLOAT, 0.}, {"half.exr", TypeDesc::HALF, 1e-3}, {"a.hdr", TypeDesc::FLOAT, 1e-2}}) {
        const std::string file = save(name, 2, 2, rgb, type, colors_);
        EXPECT_EQ(load(file).format, format_float) << name;
        expectColors(load(file), 128 / 255.f, tolerance);
        expectColors(load(file, ColorEncoding::srgb), 128 / 255.f, tolerance);
    }
}

TEST_F(Image, pfmKeepsItsRowsInBothByteOrders) {
    // 1 x 2, stored from the bottom: 2 below 8, and a scale that multiplies.
    const std::string file = write("big.pfm", std::string("Pf\n1 2\n1.0\n") + std::string("\x40\0\0\0\x41\0\0\0", 8));
    EXPECT_EQ(load(file).at(0, 0, 0), 8);
    EXPECT_EQ(load(file).at(0, 1, 0), 2);
    EXPECT_EQ(load(write("little.pfm", std::string("Pf\n1 2\n-1.0\n") + std::string("\0\0\0\x40\0\0\0\x41", 8))).at(0, 0, 0), 8);
}

TEST_F(Image, tgaKeepsItsRowsInBothOrders) {
    const auto tga = [](char descriptor, const std::string& rows) {
        return std::string("\0\0\3\0\0\0\0\0\0\0\0\0\1\0\2\0\10", 17) + descriptor + rows;
    };
    EXPECT_EQ(load(write("up.tga", tga(0, "\x40\xc0"))).bytes, (std::vector<std::uint8_t>{0xc0, 0x40}));
    EXPECT_EQ(load(write("down.tga", tga(0x20, "\x40\xc0"))).bytes, (std::vector<std::uint8_t>{0x40, 0xc0}));
}

// OpenImageIO would read these by content, with code that a file can make write beyond its memory.
TEST_F(Image, onlyTheFormatsOfTheListAreRead) {
    EXPECT_THAT(errorOf(write("a.png", "GIF89a and more")),
                HasSubstr("it is a GIF image; EXR, PNG, JPEG, HDR, PFM, PNM, TGA, TIFF, BMP and WebP are read"));
    EXPECT_THAT(errorOf(write("a.exr", "8BPS and more")), HasSubstr("it is a Photoshop image; "));
    EXPECT_THAT(errorOf(write("a.tga", "DDS and more")), HasSubstr("it is a DDS image; "));
    EXPECT_EQ(errorOf(write("a.tga", "P6 1 1 255\nabc")), "no error") << "a name says nothing";
    EXPECT_THAT(errorOf(write("a.jpg", "version https://git-lfs.github.com/spec/v1")), HasSubstr("git lfs pull"));
    EXPECT_THAT(errorOf(write("a.hdr", "")), HasSubstr("it is empty"));
    for (const std::string scale : {"nan", "0", "-0.0", "inf", "x"})
        EXPECT_THAT(errorOf(write("a.pfm", "PF\n1 1\n" + scale + "\n123456789012")), HasSubstr("its scale is ")) << scale;
    EXPECT_THAT(errorOf(write("a.pfm", "PF\n10 10\n-1\n123456789012")), HasSubstr("ends before its pixels are complete"));
    EXPECT_EQ(errorOf(write("a.pfm", "PF\n1 1\n-2\n123456789012")), "no error");
    /* A comment of any length, so that the part of the file that is looked at may end within the scale */
    for (const size_t length : {40, 48, 49, 50, 1008, 1009, 1010, 1011, 1012})
        EXPECT_EQ(errorOf(write("a.pfm", "PF\n#" + std::string(length, '-') + "\n1 1\n-2.00\n123456789012")), "no error") << length;
    EXPECT_EQ(errorOf(write("a.pfm", "PF # 3 3\n# by a tool\n1 1\n# scale\n-2\n123456789012")), "no error");
    EXPECT_THAT(errorOf("/dev/zero"), HasSubstr("it is not a file, but a device or a pipe"));

    std::string bmp = read(save("a.bmp", 2, 2, rgb, TypeDesc::UINT8, colors_));
    bmp[30] = 2;
    EXPECT_THAT(errorOf(write("a.bmp", bmp)), HasSubstr("compression 2 and 24 bits a pixel"));
}

// One pixel of four channels with the given bits, of interpretation 5: CMYK.
TEST_F(Image, tiffsOfOtherKindsAreRefused) {
    const auto tiff = [](char bits, char photometric) {
        const auto word = [](int value) { return std::string{static_cast<char>(value & 255), static_cast<char>(value >> 8)}; };
        const auto entry = [&](int tag, int count, int value) {
            return word(tag) + word(3) + word(count) + word(0) + word(value) + word(0);  // of type SHORT
        };
        const int entries = 8, after = 8 + 2 + 12 * entries + 4;
        return std::string("II*\0\10\0\0\0", 8) + word(entries) + entry(256, 1, 1) + entry(257, 1, 1) + entry(258, 4, after) +
               entry(259, 1, 1) +
               entry(262, 1, photometric) + entry(273, 1, after + 8) + entry(277, 1, 4) + entry(279, 1, 16) + std::string(4, '\0') +
               word(bits) + word(bits) + word(bits) + word(bits) + std::string(16, '\x40');
    };
    EXPECT_THAT(errorOf(write("a.tif", tiff(12, 5))),
                HasSubstr("it is a TIFF image with 12 bits a channel and photometric interpretation 5"));
    EXPECT_THAT(errorOf(write("a.tif", tiff(8, 5))), HasSubstr("grey and RGB with 8, 16 or 32 bits are read"));
    EXPECT_THAT(errorOf(write("a.tif", tiff(12, 2))), HasSubstr("12 bits"));
    EXPECT_EQ(errorOf(write("a.tif", tiff(8, 2))), "no error");
}

TEST_F(Image, runLengthsOfATgaAreComplete) {
    const std::string header = std::string("\0\0\13\0\0\0\0\0\0\0\0\0\2\0\2\0\10", 17) + '\x20';  // 2 x 2, grey
    EXPECT_EQ(load(write("a.tga", header + "\x81\x40\x01\x80\xc0")).bytes, (std::vector<std::uint8_t>{0x40, 0x40, 0x80, 0xc0}));
    EXPECT_THAT(errorOf(write("a.tga", header + "\x81\x40\x01\x80")), HasSubstr("it ends before its 2 x 2 pixels are complete"));
}

TEST_F(Image, channelsAreThoseThatPbrtReads) {
    EXPECT_EQ(load(save("grey.png", 1, 1, {"Y"}, TypeDesc::UINT8, {.5f})).channels, 1);
    EXPECT_EQ(load(save("any.exr", 1, 1, {"height"}, TypeDesc::FLOAT, {.5f})).floats, std::vector<float>{.5f});

    const ImageData greyAlpha = load(save("ya.png", 1, 1, {"Y", "A"}, TypeDesc::UINT8, {1, .2f}));
    EXPECT_EQ(greyAlpha.channels, 1);
    EXPECT_EQ(greyAlpha.bytes, std::vector<std::uint8_t>{255});

    const ImageData clear = load(save("clear.png", 1, 1, rgba, TypeDesc::UINT8, {1, .6f, .2f, 0}));
    EXPECT_EQ(clear.channels, 4);
    EXPECT_EQ(clear.bytes, (std::vector<std::uint8_t>{255, 153, 51, 0}));  // not multiplied by alpha
    EXPECT_EQ(load(save("opaque.png", 1, 1, rgba, TypeDesc::UINT8, {1, .6f, .2f, 1})).channels, 3);
    EXPECT_EQ(load(save("opaque.exr", 1, 1, rgba, TypeDesc::FLOAT, {1, .6f, .2f, 1})).channels, 3);

    const ImageData many = load(save("aovs.exr", 1, 1, {"R", "G", "B", "Z", "N.X"}, TypeDesc::FLOAT, {1, 2, 3, 4, 5}));
    EXPECT_EQ(many.floats, (std::vector<float>{1, 2, 3}));
    EXPECT_EQ(errorOf(save("none.exr", 1, 1, {"Z", "U"}, TypeDesc::FLOAT, {1, 2})),
              "scene.pbrt:4:9: cannot read image \"" + path("none.exr") + "\": it has none of the channels R G B or Y; its channels: Z U");
}

TEST_F(Image, aFloatTextureReadsAlphaOrGreyOrTheMean) {
    const ImageData alpha = scalarImage(load(save("rgba.png", 1, 1, rgba, TypeDesc::UINT8, {1, 1, 1, 0.2f})));
    EXPECT_EQ(alpha.channels, 1);
    EXPECT_EQ(alpha.bytes, std::vector<std::uint8_t>{51});

    const ImageData grey = scalarImage(load(save("grey.png", 1, 1, rgb, TypeDesc::UINT8, {.2f, .2f, .2f})));
    EXPECT_EQ(grey.format, format_srgb8);
    EXPECT_EQ(grey.bytes, std::vector<std::uint8_t>{51});

    const ImageData mean = scalarImage(load(save("rgb.png", 1, 1, rgb, TypeDesc::UINT8, {1, 128 / 255.f, 0})));
    EXPECT_EQ(mean.format, format_float);
    EXPECT_NEAR(mean.at(0, 0, 0), (1 + srgbGrey) / 3, 1e-6);
    EXPECT_NEAR(scalarImage(load(save("rgb.exr", 1, 1, rgb, TypeDesc::FLOAT, {1, 2, 6}))).at(0, 0, 0), 3, 1e-6);
}

TEST_F(Image, otherPrimariesBecomeThoseOfSrgb) {
    // Rec. 2020's red is (1.6605, -0.1246, -0.0182) in sRGB (ITU-R BT.2087); white stays white.
    const std::vector<float> rec2020{0.708f, 0.292f, 0.170f, 0.797f, 0.131f, 0.046f, 0.3127f, 0.3290f};
    const ImageData image = load(save("wide.exr", 2, 1, rgb, TypeDesc::FLOAT, {1, 0, 0, 1, 1, 1}, {{"chromaticities", rec2020}}));
    const double expected[] = {1.6605, -0.1246, -0.0182, 1, 1, 1};
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(image.floats[i], expected[i], 2e-4);
}

TEST_F(Image, whatIsNotFiniteIsReplacedAndCounted) {
    const float inf = std::numeric_limits<float>::infinity();
    const ImageData image = load(save("a.exr", 1, 1, rgb, TypeDesc::FLOAT, {inf, std::nanf(""), -inf}));
    EXPECT_EQ(image.replaced, 3u);
    EXPECT_EQ(image.floats, (std::vector<float>{65504, 0, -65504}));
}

TEST_F(Image, manyAreReadAtOnceAndAllErrorsListed) {
    std::vector<ImageFile> files;
    for (int i = 0; i < 20; ++i)
        files.push_back({.path = save("v" + std::to_string(i) + ".png", 1, 1, {"Y"}, TypeDesc::UINT8, {i / 255.f})});
    const auto images = loadImages(files);
    for (int i = 0; i < 20; ++i) EXPECT_EQ(images[i]->bytes, std::vector<std::uint8_t>{static_cast<std::uint8_t>(i)});

    files[3].path = path("absent.png");
    files[7].path = folder_.string();
    files[7].where = {std::make_shared<std::string>("scene.pbrt"), 2, 1};
    try {
        loadImages(files);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.what(), "cannot read image \"" + path("absent.png") +
                                    "\": there is no such file\nscene.pbrt:2:1: cannot read image \"" + folder_.string() +
                                    "\": it is a folder");
    }
}

TEST_F(Image, pixelsOfItsOwnAreTaken) {
    ImageFile file{.path = "sky"};
    file.pixels = std::make_shared<ImageData>(ImageData{.width = 1, .height = 1, .floats = {.5f}});
    EXPECT_EQ(loadImage(file), file.pixels);
}

TEST_F(Image, anUnknownFormatListsTheKnownOnes) {
    const std::string ending = "its format is not known; EXR, PNG, JPEG, HDR, PFM, PNM, TGA, TIFF, BMP and WebP are read";
    EXPECT_EQ(errorOf(write("a.foo", "no image")), "scene.pbrt:4:9: cannot read image \"" + path("a.foo") + "\": " + ending);
    EXPECT_THAT(errorOf(write("a.png", "no image")), HasSubstr("a.png\": " + ending));
    EXPECT_THAT(errorOf(write("a.png", "\x89PNG\r\n\x1a\n")), HasSubstr("a.png\": "));
}

/// 65,500^2 pixels, of 3 values of 4 bytes each, which are there three times on their way to the scene's tables.
TEST_F(Image, whatDoesNotFitIntoMemoryIsRefusedBeforeItIsTaken) {
    const auto number = [](std::uint32_t n) {
        std::string bytes;
        for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(n >> shift & 255);
        return bytes;
    };
    const auto chunk = [&](const std::string& type, const std::string& data) {
        const std::string all = type + data;
        const auto sum = ::crc32(0, reinterpret_cast<const Bytef*>(all.data()), static_cast<uInt>(all.size()));
        return number(static_cast<std::uint32_t>(data.size())) + all + number(static_cast<std::uint32_t>(sum));
    };
    const std::string header = number(65500) + number(65500) + std::string("\x10\x02\0\0\0", 5);   // 16 bits, RGB
    if (availableMemory() > 154e9) GTEST_SKIP() << "it fits";
    const std::string file = write("large.png", "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) +
                                                    chunk("IDAT", std::string(16'000'000, '\0')) + chunk("IEND", ""));
    EXPECT_EQ(errorOf(file), "scene.pbrt:4:9: cannot read image \"" + file +
                                 "\": it has 65500 x 65500 pixels, which take 154.4 GB, and there is not as much memory");
}

TEST_F(Image, damagedFilesAreRefusedOrReadButNeverCrash) {
    std::mt19937 random(1);
    std::vector<float> values(16 * 16 * 3);
    for (float& value : values) value = static_cast<float>(random() % 256) / 255;
    for (const auto& [name, type] : {std::pair{"a.png", TypeDesc::UINT8},
                                     {"b.png", TypeDesc::UINT16},
                                     {"a.tga", TypeDesc::UINT8},
                                     {"a.jpg", TypeDesc::UINT8},
                                     {"a.bmp", TypeDesc::UINT8},
                                     {"a.tif", TypeDesc::UINT8},
                                     {"a.exr", TypeDesc::FLOAT},
                                     {"a.hdr", TypeDesc::FLOAT}}) {
        const std::string whole = read(save(name, 16, 16, rgb, type, values));
        int refused = 0;
        for (int i = 0; i < 60; ++i) {
            const std::size_t size = i < 20 ? static_cast<std::size_t>(i) * 3 : random() % whole.size();
            const bool isRefused = errorOf(write(name, whole.substr(0, size))) != "no error";
            EXPECT_TRUE(isRefused || size > whole.size() / 2) << name << ", with missing pixels: " << size << " of " << whole.size();
            refused += isRefused;
            std::string changed = whole;
            changed[i < 40 ? static_cast<std::size_t>(i) % whole.size() : random() % whole.size()] ^= static_cast<char>(1 + random() % 255);
            errorOf(write(name, changed));
        }
        EXPECT_GT(refused, 20) << name;
    }
}

// ---- equal-area maps --------------------------------------------------------------------------------------------------------

TEST(EqualArea, squareAndDirectionInvertEachOther) {
    for (int j = 0; j < 64; ++j)
        for (int i = 0; i < 64; ++i) {
            const glm::dvec2 p((i + .5) / 64, (j + .5) / 64);
            const glm::dvec3 d = directionFromSquare(p);
            EXPECT_NEAR(glm::length(d), 1, 1e-12);
            EXPECT_LT(glm::distance(squareFromDirection(3. * d), p), 1e-7);
        }
}

TEST(EqualArea, hasThePlacesOfPbrt) {
    const auto expectNear = [](glm::dvec2 p, glm::dvec3 d) {
        EXPECT_LT(glm::distance(directionFromSquare(p), d), 1e-12) << p.x << ' ' << p.y;
    };
    expectNear({.5, .5}, {0, 0, 1});
    expectNear({1, .5}, {1, 0, 0});
    expectNear({.5, 1}, {0, 1, 0});
    expectNear({0, .5}, {-1, 0, 0});
    expectNear({0, 0}, {0, 0, -1});
    expectNear({1, 1}, {0, 0, -1});
}

TEST(EqualArea, keepsAreas) {
    // With equal areas, the mean of z^2 over the square is that over the sphere, 1/3, and that of each coordinate is 0.
    glm::dvec3 mean(0), squares(0);
    const int n = 256;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const glm::dvec3 d = directionFromSquare({(i + .5) / n, (j + .5) / n});
            mean += d / double(n * n);
            squares += d * d / double(n * n);
        }
    EXPECT_LT(glm::length(mean), 1e-10);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(squares[c], 1. / 3, 2e-5);
}

TEST(EqualArea, latLongKeepsItsDirectionsAndItsLight) {
    ImageData latLong{.width = 128, .height = 64, .channels = 3};
    const double pi = std::numbers::pi;
    glm::dvec3 integral(0);
    for (int y = 0; y < latLong.height; ++y)
        for (int x = 0; x < latLong.width; ++x) {
            const double theta = (y + .5) / latLong.height * pi, phi = (x + .5) / latLong.width * 2 * pi;
            const glm::dvec3 value = 1. + glm::dvec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
            integral += value * std::sin(theta);
            for (int c = 0; c < 3; ++c) latLong.floats.push_back(static_cast<float>(value[c]));
        }
    integral *= (pi / latLong.height) * (2 * pi / latLong.width) / (4 * pi);

    const ImageData square = equalAreaFromLatLong(latLong);
    EXPECT_EQ(square.width, 128);
    EXPECT_EQ(square.height, 128);
    glm::dvec3 mean(0);
    for (int y = 0; y < square.height; ++y)
        for (int x = 0; x < square.width; ++x)
            for (int c = 0; c < 3; ++c) {
                const double expected = 1 + directionFromSquare({(x + .5) / 128, (y + .5) / 128})[c];
                EXPECT_NEAR(square.at(x, y, c), expected, 0.02);
                mean[c] += square.at(x, y, c) / (128. * 128);
            }
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c], integral[c], 1e-3);
}

}  // namespace
}  // namespace eikonal
