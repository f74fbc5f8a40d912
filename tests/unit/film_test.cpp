// Images on disk: the same pixels, their place in the whole image, how they were made; and what is said when that cannot be.

#include <OpenImageIO/imageio.h>

#include "image/image_file.h"
#include "image/spectral_layout.h"
#include "image/tone_map.h"
#include "color/transfer.h"
#include "unit/temporary_folder.h"

#include <gmock/gmock.h>

#include <sys/resource.h>
#include <sys/stat.h>

#include <cmath>
#include <csignal>
#include <limits>
#include <set>

namespace eikonal {
namespace {

using testing::HasSubstr;

const float inf = std::numeric_limits<float>::infinity();

/// An image whose every value says where it belongs.
FilmImage numbered(int width, int height, const PixelBounds& bounds) {
    FilmImage image(width, height, bounds);
    for (int y = bounds.y0; y < bounds.y1; ++y)
        for (int x = bounds.x0; x < bounds.x1; ++x) image.color[image.index(x, y)] = {x / 8.f, y / 8.f, .25f};
    return image;
}
FilmImage numbered(int width, int height) { return numbered(width, height, {0, width, 0, height}); }

const Metadata metadata{.samples = 64,
                        .meanSamples = 80.5,
                        .targetError = 0.03125,
                        .error = 0.0625,
                        .errorLow = 0.03125,
                        .errorHigh = 0.125,
                        .errorMetric = "nrmse",
                        .errorDoubt = "very few pixels hold most of it",
                        .partial = "interrupted: 3 of 64 samples per pixel",
                        .renderSeconds = 12.5,
                        .seed = 7,
                        .version = "Eikonal 0.1.0",
                        .scene = "box.pbrt",
                        .sceneHash = "9f3c",
                        .device = "pthread-haswell",
                        .commandLine = "eikonal render box.pbrt -o \"a b.exr\""};

class Film : public TemporaryFolder {
protected:
    std::string errorOf(const std::string& file, std::uint64_t bytes = 0) const {
        try {
            checkWritable(file, bytes);
            return "no error";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::scene);
            return error.what();
        }
    }
    std::set<std::string> files() const {
        std::set<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(folder_)) names.insert(entry.path().filename().string());
        return names;
    }
};

TEST_F(Film, exrKeepsEveryBit) {
    FilmImage image = numbered(5, 4);
    image.color[7] = {1e-20f, 3e38f, -0.f};
    image.color[8] = {inf, -1, 1 / 3.f};
    writeImage(path("a.exr"), image, metadata, {.recordsTime = true});
    const FilmFile file = readImage(path("a.exr"));
    EXPECT_EQ(file.image.color, image.color);
    EXPECT_EQ(file.image.width, 5);
    EXPECT_EQ(file.image.height, 4);
    EXPECT_EQ(file.metadata, metadata);
    EXPECT_TRUE(file.image.albedo.empty() && file.image.normal.empty() && file.image.depth.empty());
    EXPECT_EQ(files(), std::set<std::string>{"a.exr"});
}

TEST_F(Film, exrSaysWhatItsColorsMean) {
    writeImage(path("a.exr"), numbered(2, 2), metadata, {.recordsTime = true});
    auto input = OIIO::ImageInput::open(path("a.exr"));
    float chromaticities[8] = {};
    ASSERT_TRUE(input->spec().getattribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), chromaticities));
    EXPECT_THAT(chromaticities, testing::ElementsAre(.64f, .33f, .3f, .6f, .15f, .06f, .3127f, .329f));
    EXPECT_EQ(input->spec().get_int_attribute("samplesPerPixel"), 64);
    EXPECT_EQ(input->spec().get_float_attribute("renderTimeSeconds"), 12.5f);
    EXPECT_EQ(input->spec().get_string_attribute("commandLine"), metadata.commandLine);
}

TEST_F(Film, exrKeepsTheAuxiliaryChannels) {
    FilmImage image = numbered(3, 2);
    for (int i = 0; i < 6; ++i) {
        image.albedo.push_back({.1f, .2f, i / 10.f});
        image.normal.push_back({0, i / 5.f, -1});
        image.uv.push_back({i / 7.f, -2});
        image.depthSlope.push_back({.5f, i / 3.f});
        image.depth.push_back(i == 2 ? inf : i + .5f);
        image.variance.push_back(i * 1e-3f);
        image.sampleCount.push_back(16.f + i);
    }
    writeImage(path("a.exr"), image, metadata);
    const FilmImage back = readImage(path("a.exr")).image;
    EXPECT_EQ(back.color, image.color);
    EXPECT_EQ(back.albedo, image.albedo);
    EXPECT_EQ(back.normal, image.normal);
    EXPECT_EQ(back.uv, image.uv);
    EXPECT_EQ(back.depthSlope, image.depthSlope);
    EXPECT_EQ(back.depth, image.depth);
    EXPECT_EQ(back.variance, image.variance);
    EXPECT_EQ(back.sampleCount, image.sampleCount);

    auto input = OIIO::ImageInput::open(path("a.exr"));
    EXPECT_THAT(input->spec().channelnames, testing::UnorderedElementsAre("R", "G", "B", "albedo.R", "albedo.G", "albedo.B", "N.X", "N.Y",
                                                                          "N.Z", "u", "v", "dzdx", "dzdy", "Z", "variance", "sampleCount"));
    std::vector<float> raw(6 * 16);
    ASSERT_TRUE(input->read_image(0, 0, 0, 16, OIIO::TypeDesc::FLOAT, raw.data()));
    const auto depth =
        std::find(input->spec().channelnames.begin(), input->spec().channelnames.end(), "Z") - input->spec().channelnames.begin();
    EXPECT_EQ(raw[2 * 16 + static_cast<std::size_t>(depth)], 1e10f);
}

// The layout of Fichet et al. 2021, with pbrt-v4's names.
TEST_F(Film, exrKeepsSpectra) {
    FilmImage image = numbered(3, 2);
    image.spectrum.wavelengths = {374.6875, 404.0625, 1000};
    for (int i = 0; i < 18; ++i) image.spectrum.radiance.push_back(i / 7.f);
    writeImage(path("a.exr"), image, metadata);
    auto input = OIIO::ImageInput::open(path("a.exr"));
    EXPECT_THAT(input->spec().channelnames, testing::UnorderedElementsAre("R", "G", "B", "S0.374,688nm", "S0.404,062nm", "S0.1000,000nm"));
    EXPECT_EQ(input->spec().get_string_attribute("spectralLayoutVersion"), "1.0");
    EXPECT_EQ(input->spec().get_string_attribute("emissiveUnits"), "W.m^-2.sr^-1");
    const FilmImage back = readImage(path("a.exr")).image;
    EXPECT_EQ(back.spectrum.wavelengths, (std::vector<double>{374.688, 404.062, 1000}));
    EXPECT_EQ(back.spectrum.radiance, image.spectrum.radiance);
    EXPECT_EQ(back.color, image.color);

    writeImage(path("b.exr"), numbered(3, 2), metadata);
    EXPECT_EQ(OIIO::ImageInput::open(path("b.exr"))->spec().get_string_attribute("spectralLayoutVersion"), "");
    writeImage(path("a.pfm"), image, metadata);
    EXPECT_TRUE(readImage(path("a.pfm")).image.spectrum.wavelengths.empty());
    for (const char* other : {"S0.nm", "S0.4,0,0nm", "S0.400nm ", "S1.400,000nm", "T.400,000nm", "S0.400,000", "S0.xnm"})
        EXPECT_FALSE(wavelengthOfChannel(other)) << other;
}

/// As many channels as there can be at all.
TEST_F(Film, exrKeepsManyBuckets) {
    FilmImage image = numbered(2, 1);
    for (int b = 0; b < 512; ++b) image.spectrum.wavelengths.push_back(500 + b / 8.0);
    image.spectrum.radiance.assign(1024, .5f);
    image.spectrum.radiance[512 + 300] = 3;
    for (auto* v : {&image.albedo, &image.normal, &image.geometricNormal, &image.position}) v->resize(2);
    for (auto* v : {&image.variance, &image.depth, &image.sampleCount}) v->resize(2);
    writeImage(path("a.exr"), image, metadata);
    EXPECT_EQ(readImage(path("a.exr")).image.spectrum.radiance, image.spectrum.radiance);
}

TEST_F(Film, aCropIsADataWindowInExr) {
    const FilmImage crop = numbered(64, 48, {10, 14, 20, 23});
    writeImage(path("crop.exr"), crop, metadata);
    const FilmImage back = readImage(path("crop.exr")).image;
    EXPECT_EQ(back.width, 64);
    EXPECT_EQ(back.height, 48);
    EXPECT_EQ(back.bounds.x0, 10);
    EXPECT_EQ(back.bounds.x1, 14);
    EXPECT_EQ(back.bounds.y0, 20);
    EXPECT_EQ(back.bounds.y1, 23);
    EXPECT_EQ(back.color, crop.color);
}

TEST_F(Film, otherFormatsHoldTheCropAlone) {
    const FilmImage crop = numbered(64, 48, {4, 8, 2, 5});
    for (const char* name : {"a.png", "a.hdr", "a.pfm", "a.tif"}) {
        writeImage(path(name), crop, metadata);
        const FilmImage back = readImage(path(name)).image;
        ASSERT_EQ(back.width, 4) << name;
        ASSERT_EQ(back.height, 3) << name;
        for (std::size_t i = 0; i < crop.pixelCount(); ++i)
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(back.color[i][c], crop.color[i][c], .01) << name;
    }
}

TEST_F(Film, everyFormatHasTheSamePicture) {
    FilmImage image(32, 16);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 32; ++x) image.color[image.index(x, y)] = {x < 16 ? .8f : .1f, y < 8 ? .6f : .05f, .3f};
    for (const char* name :
         {"a.exr", "a.hdr", "a.pfm", "a.png", "a.jpg", "a.jpeg", "a.tif", "a.tiff", "a.tga", "a.bmp", "a.webp", "A.PNG"}) {
        writeImage(path(name), image, metadata);
        const FilmImage back = readImage(path(name)).image;
        ASSERT_EQ(back.pixelCount(), image.pixelCount()) << name;
        for (const auto& [x, y] : {std::pair{4, 3}, {28, 3}, {4, 13}, {28, 13}})
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(back.color[back.index(x, y)][c], image.color[image.index(x, y)][c], .02) << name << ' ' << x << ' ' << y;
    }
}

TEST_F(Film, floatFormatsAreNotToneMapped) {
    FilmImage image(2, 1);
    image.color = {{100, 2, .01f}, {0, 50, 1}};
    writeImage(path("a.pfm"), image, metadata, {.exposure = 3});
    EXPECT_EQ(readImage(path("a.pfm")).image.color, image.color);
    writeImage(path("a.hdr"), image, metadata, {.exposure = 3});
    EXPECT_NEAR(readImage(path("a.hdr")).image.color[0].x, 100, .5);
}

TEST_F(Film, pngTellsHowItWasMade) {
    writeImage(path("a.png"), numbered(2, 2), metadata);
    EXPECT_EQ(readImage(path("a.png")).metadata.version, "Eikonal 0.1.0");
}

// ---- tone mapping -----------------------------------------------------------------------------------------------------------

TEST(ToneMap, clampShowsWhatViewersShow) {
    const ToneMapping plain;
    EXPECT_EQ(toneMap({0, 1, 5}, plain), glm::vec3(0, 1, 1));
    EXPECT_EQ(toneMap({-1, inf, std::nanf("")}, plain), glm::vec3(0, 1, 0));
    EXPECT_NEAR(toneMap({.18f, 0, 0}, plain).x, 0.461356, 1e-5);  // middle grey: 1.055 * 0.18^(1/2.4) - 0.055
    EXPECT_NEAR(toneMap({.001f, 0, 0}, plain).x, .01292, 1e-7);
}

TEST(ToneMap, exposureIsInStops) {
    for (const ToneCurve curve : {ToneCurve::clamp, ToneCurve::reinhard, ToneCurve::filmic})
        EXPECT_EQ(toneMap({.1f, .2f, .05f}, {curve, 1}), toneMap({.2f, .4f, .1f}, {curve, 0}));
}

TEST(ToneMap, curvesRiseToOne) {
    for (const ToneCurve curve : {ToneCurve::clamp, ToneCurve::reinhard, ToneCurve::filmic}) {
        float last = -1;
        for (float x = 0; x < 1e6f; x = x * 1.3f + .001f) {
            const float y = toneMap(glm::vec3(x), {curve, 0}).x;
            EXPECT_GE(y, last);
            EXPECT_LE(y, 1);
            last = y;
        }
        EXPECT_GT(last, .99f);
        EXPECT_EQ(toneMap(glm::vec3(inf), {curve, 0}).x, 1);
    }
    EXPECT_NEAR(toneMap(glm::vec3(1), {ToneCurve::reinhard, 0}).x, srgbFromLinear(.5), 1e-6);
}

TEST(ToneMap, namesItsCurves) {
    EXPECT_EQ(toneCurve("filmic"), ToneCurve::filmic);
    EXPECT_THAT([] { toneCurve("flimic"); },
                testing::ThrowsMessage<UsageError>("unknown tone curve \"flimic\"; known: clamp reinhard filmic"));
}

TEST(Transfer, isItsOwnInverse) {
    for (int i = 0; i <= 255; ++i) EXPECT_NEAR(srgbFromLinear(linearFromSrgb(i / 255.)), i / 255., 1e-7);
}

// ---- what cannot be written -------------------------------------------------------------------------------------------------

TEST_F(Film, saysWhatWouldWork) {
    const std::string known = "; known are exr hdr pfm png jpg jpeg tif tiff tga bmp webp";
    EXPECT_EQ(errorOf(path("a.exr")), "no error");
    EXPECT_EQ(errorOf(path("a.xyz")), "cannot write \"" + path("a.xyz") + "\": the extension \".xyz\" is not known" + known);
    EXPECT_EQ(errorOf(path("a")), "cannot write \"" + path("a") + "\": its name has no extension" + known);
    EXPECT_EQ(errorOf(path("b/a.exr")), "cannot write \"" + path("b/a.exr") + "\": there is no folder \"" + path("b") +
                                            "\"; make it: mkdir -p " + path("b"));
    std::filesystem::create_directory(path("c.exr"));
    EXPECT_EQ(errorOf(path("c.exr")), "cannot write \"" + path("c.exr") + "\": it is a folder");
    ASSERT_EQ(::mkfifo(path("pipe.exr").c_str(), 0600), 0);
    EXPECT_EQ(errorOf(path("pipe.exr")), "cannot write \"" + path("pipe.exr") + "\": it is not a regular file");
    EXPECT_THAT(
        errorOf(path("a.exr"), 1ull << 62),
        testing::MatchesRegex("cannot write \".*a.exr\": it needs about 4611686018427.4 MB in \".*\", but only [0-9.]+ MB are free"));
    EXPECT_THAT(errorOf("/proc/a.exr"), HasSubstr("cannot create a file in \"/proc\": "));
    EXPECT_EQ(files(), (std::set<std::string>{"c.exr", "pipe.exr"}));
}

TEST_F(Film, refusesAnImageWithoutPixels) {
    EXPECT_THAT([&] { writeImage(path("a.exr"), FilmImage{}, {}); }, testing::ThrowsMessage<Error>(HasSubstr("the image has no pixels")));
}

TEST_F(Film, aLinkStaysALink) {
    write("real.exr", "old");
    std::filesystem::create_symlink(path("real.exr"), path("link.exr"));
    writeImage(path("link.exr"), numbered(2, 2), {});
    EXPECT_TRUE(std::filesystem::is_symlink(path("link.exr")));
    EXPECT_EQ(readImage(path("real.exr")).image.pixelCount(), 4u);
}

TEST_F(Film, aFullDiskLeavesWhatWasThere) {
    // A limit on the size of files stands for the full disk: write() fails half way in the same manner.
    write("a.exr", "old");
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{1000, before.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    std::string message = "no error";
    try {
        FilmImage noise(64, 64);
        for (std::size_t i = 0; i < noise.color.size(); ++i) noise.color[i] = glm::vec3(static_cast<float>(std::sin(double(i * i))));
        writeImage(path("a.exr"), noise, {});
    } catch (const Error& error) { message = error.what(); }
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(message, "cannot write \"" + path("a.exr") + "\": File too large");
    EXPECT_EQ(read(path("a.exr")), "old");
    EXPECT_EQ(files(), std::set<std::string>{"a.exr"});
}

TEST_F(Film, readsTheImagesOfOthers) {
    const auto save = [&](const std::string& name, const std::vector<std::string>& channels, std::vector<float> values) {
        OIIO::ImageSpec spec(1, 1, static_cast<int>(channels.size()), OIIO::TypeDesc::HALF);
        spec.channelnames = channels;
        spec.x = spec.full_x = 5;
        auto output = OIIO::ImageOutput::create(path(name));
        EXPECT_TRUE(output->open(path(name), spec) && output->write_image(OIIO::TypeDesc::FLOAT, values.data()) && output->close());
        return path(name);
    };
    const FilmImage grey = readImage(save("grey.exr", {"Y"}, {.5f})).image;
    EXPECT_EQ(grey.color, std::vector<glm::vec3>{glm::vec3(.5f)});
    EXPECT_EQ(grey.bounds.x0, 0);
    EXPECT_THAT(
        [&] {
            readImage(save("odd.exr", {"U", "V"}, {1, 2}));
        },
        testing::ThrowsMessage<Error>(HasSubstr("it has no channel R G B or Y")));
    EXPECT_THAT([&] { readImage(path("absent.exr")); },
                testing::ThrowsMessage<Error>("cannot read image \"" + path("absent.exr") + "\": there is no such file"));
}

TEST_F(Film, refusesTruncatedFiles) {
    writeImage(path("a.exr"), numbered(40, 40), metadata);
    const std::string whole = read(path("a.exr"));
    for (std::size_t size = 0; size + 1 < whole.size(); size += 1 + size / 20) {
        write("b.exr", whole.substr(0, size));
        EXPECT_THROW(readImage(path("b.exr")), Error) << size;
    }
}

// A shared exponent leaves no sign.
TEST_F(Film, anHdrHasNoNegativeValues) {
    FilmImage image(2, 1);
    image.color = {glm::vec3(-0.5f, 2, 8), glm::vec3(1, std::numeric_limits<float>::quiet_NaN(), -1e-8f)};
    writeImage(path("a.hdr"), image, {});
    const FilmImage stored = readImage(path("a.hdr")).image;
    EXPECT_EQ(stored.color[0], glm::vec3(0, 2, 8));
    EXPECT_EQ(stored.color[1], glm::vec3(1, 0, 0));
}

}  // namespace
}  // namespace eikonal
