// How files are encoded if asked to: compression, bits, spelling of channels; that the bytes depend on the image alone; and what a format
// cannot hold.

#include <OpenImageIO/imageio.h>

#include "error.h"
#include "image/image_file.h"
#include "image/sample_variance.h"
#include "unit/temporary_folder.h"

#include <gmock/gmock.h>

#include <tbb/global_control.h>

#include <set>
#include <thread>

namespace eikonal {
namespace {

using testing::HasSubstr;

class EncodedFiles : public TemporaryFolder {
protected:
    std::string bytesOf(const std::string& name, const FilmImage& image, const Metadata& metadata, const ImageEncoding& encoding = {}) {
        writeImage(path(name), image, metadata, encoding);
        return read(path(name));
    }
    std::map<std::string, std::string> typesIn(const std::string& name) const {
        const auto file = OIIO::ImageInput::open(path(name));
        std::map<std::string, std::string> types;
        for (int c = 0; c < file->spec().nchannels; ++c)
            types[file->spec().channelnames[static_cast<size_t>(c)]] = file->spec().channelformat(c).c_str();
        return types;
    }
};

/// 64 x 48 pixels with values of every size, and some other vectors.
FilmImage sample() {
    FilmImage image(64, 48);
    for (size_t i = 0; i < image.pixelCount(); ++i) {
        const float x = static_cast<float>(i * 2654435761u % 65536) / 65536;
        image.color[i] = {x, x * x * 8, 1 - x};
        image.albedo.emplace_back(0.25f, x, 0.5f);
        image.normal.emplace_back(0, 0, 1);
        image.geometricNormal.emplace_back(0, 1, 0);
        image.position.emplace_back(3 * x, 0, -1);
        image.variance.push_back(0.01f * x);
        image.sampleCount.push_back(4);
    }
    return image;
}

const Metadata described{.samples = 4, .renderSeconds = 12.5, .version = "Eikonal", .commandLine = "eikonal render a.pbrt"};

// Two renders of the same scene differ in their times, which --record-time keeps; OpenImageIO puts the date into TIFF files if it is let.
TEST_F(EncodedFiles, TheSameRenderGivesTheSameBytes) {
    Metadata later = described;
    later.renderSeconds = 13;
    for (const char* name : imageFormatNames()) {
        const std::string file = std::string("a.") + name, first = bytesOf(file, sample(), described);
        std::this_thread::sleep_for(std::chrono::milliseconds(1100 * (std::string(name) == "tif")));
        EXPECT_EQ(first == bytesOf(file, sample(), later), true) << name;
    }
    EXPECT_NE(bytesOf("a.exr", sample(), described, {.recordsTime = true}), bytesOf("a.exr", sample(), later, {.recordsTime = true}));
}

TEST_F(EncodedFiles, ThreadsChangeNoByteOfAnExr) {
    for (const auto& [name, compression] : exrCompressionNames) {
        const ImageEncoding encoding{.compression = compression};
        std::set<std::string> found;
        for (const size_t threads : {1, 2, 7}) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            found.insert(bytesOf("a.exr", sample(), described, encoding));
        }
        EXPECT_EQ(found.size(), 1u) << name;
    }
}

TEST_F(EncodedFiles, ExrHasTheCompressionAskedFor) {
    const FilmImage image = sample();
    for (const auto& [name, compression] : exrCompressionNames) {
        writeImage(path("a.exr"), image, described, {.compression = compression});
        EXPECT_EQ(OIIO::ImageInput::open(path("a.exr"))->spec().get_string_attribute("compression"), name);
        const FilmImage back = readImage(path("a.exr")).image;
        if (compression <= ExrCompression::piz) EXPECT_EQ(back.color, image.color) << name;
        else
            for (size_t i = 0; i < image.pixelCount(); ++i) ASSERT_NEAR(back.color[i].g, image.color[i].g, 0.3f) << name << ' ' << i;
    }
}

// sRGB of 16 bits has steps of at most 2 / 65535 in linear light, that of 8 bits of 2 / 255.
TEST_F(EncodedFiles, PngAndTiffHaveTheBitsAskedFor) {
    FilmImage image(256, 256);
    for (size_t i = 0; i < image.pixelCount(); ++i) image.color[i] = glm::vec3(static_cast<float>(i) / 65535);
    for (const char* name : {"a.png", "a.tif"})
        for (const int bits : {8, 16}) {
            writeImage(path(name), image, {}, {.bits = bits});
            EXPECT_EQ(OIIO::ImageInput::open(path(name))->spec().get_int_attribute("oiio:BitsPerSample", bits), bits) << name;
            std::set<float> values;
            const FilmImage back = readImage(path(name)).image;
            for (size_t i = 0; i < image.pixelCount(); ++i) {
                values.insert(back.color[i].r);
                ASSERT_NEAR(back.color[i].r, image.color[i].r, bits == 16 ? 1.5f / 65535 : 1.5f / 255) << name << ' ' << i;
            }
            if (bits == 8) EXPECT_EQ(values.size(), 256u) << name;
            else EXPECT_GT(values.size(), 20000u) << name;
        }
}

TEST_F(EncodedFiles, PbrtsNamesAreThoseOfItsGBuffer) {
    FilmImage image = sample();
    addSampleVariance(image);
    for (const bool isHalf : {false, true}) {
        writeImage(path("a.exr"), image, described, {.halfFloats = isHalf, .channelNames = ChannelNames::pbrt});
        std::set<std::string> names;
        for (const auto& [name, type] : typesIn("a.exr")) {
            names.insert(name);
            EXPECT_EQ(type, isHalf ? "half" : "float") << name << ": pbrt reads files of one type";
        }
        EXPECT_EQ(names, (std::set<std::string>{"R", "G", "B", "Albedo.R", "Albedo.G", "Albedo.B", "P.X", "P.Y", "P.Z", "N.X", "N.Y", "N.Z",
                                                "Ns.X", "Ns.Y", "Ns.Z", "Variance.R", "Variance.G", "Variance.B", "RelativeVariance.R",
                                                "RelativeVariance.G", "RelativeVariance.B", "sampleCount"}));
    }
    writeImage(path("a.exr"), image, described, {.channelNames = ChannelNames::pbrt});
    const FilmImage back = readImage(path("a.exr")).image;
    EXPECT_EQ(back.normal, image.normal);
    EXPECT_EQ(back.geometricNormal, image.geometricNormal);
    EXPECT_EQ(back.albedo, image.albedo);
    EXPECT_EQ(back.sampleVariance, image.sampleVariance);
    EXPECT_EQ(back.relativeVariance, image.relativeVariance);
}

// The variance of a mean of 4 samples is a quarter of that of a sample: 4 * 0.01 for grey 0.5, and that over 0.5. A channel of twice the
// luminance has four times its variance.
TEST(SampleVariance, IsThatOfOneSample) {
    FilmImage image(3, 1);
    image.color = {glm::vec3(0.5f), {1, 0, 0}, glm::vec3(0)};
    image.variance = {0.01f, 0.01f, 0.01f};
    image.sampleCount = {4, 4, 4};
    addSampleVariance(image);
    EXPECT_NEAR(image.sampleVariance[0].g, 0.04f, 1e-6);
    EXPECT_NEAR(image.relativeVariance[0].g, 0.08f, 1e-6);
    const float red = 0.2126f;   // of the luminance
    EXPECT_NEAR(image.sampleVariance[1].r, 0.04f / (red * red), 1e-2);
    EXPECT_EQ(image.sampleVariance[1].g, 0);
    EXPECT_EQ(image.sampleVariance[2], glm::vec3(0));
    EXPECT_EQ(image.relativeVariance[2], glm::vec3(0));
    image.sampleCount.clear();
    addSampleVariance(image, 8);
    EXPECT_NEAR(image.sampleVariance[0].g, 0.08f, 1e-6);
}

std::string problemOf(const std::vector<std::string>& files, const ImageEncoding& encoding) {
    try {
        checkEncoding(files, encoding);
        return "none";
    } catch (const UsageError& error) { return error.what(); }
}

TEST(CheckEncoding, SaysWhatWouldHaveWorked) {
    EXPECT_EQ(problemOf({"a.exr", "a.png"}, {.halfFloats = true, .compression = ExrCompression::piz, .bits = 16}), "none");
    EXPECT_EQ(problemOf({"a.tif"}, {.bits = 8}), "none");
    EXPECT_EQ(problemOf({"a.png"}, {.halfFloats = true}), "--pixel-type is for EXR files, and a.png is none; add `-o FILE.exr`");
    EXPECT_EQ(problemOf({"a.png", "b.hdr"}, {.compression = ExrCompression::piz}),
              "--compression is for EXR files, and a.png, b.hdr are none; add `-o FILE.exr`");
    EXPECT_THAT(problemOf({"a.pfm"}, {.channelNames = ChannelNames::pbrt}), HasSubstr("--channel-names is for EXR files"));
    EXPECT_EQ(problemOf({"a.png", "b.jpg"}, {.bits = 16}), "--bit-depth 16: b.jpg holds 8 bits; png and tif hold 16");
    EXPECT_EQ(problemOf({"a.exr"}, {.bits = 16}),
              "--bit-depth is for integer formats, and a.exr has floats; add `-o FILE.png`, or see --pixel-type");
}

/// Tone mapping changes integer formats, and the page that --view shows.
TEST(CheckEncoding, ToneMappingNeedsIntegers) {
    const ImageEncoding filmic{.curve = ToneCurve::filmic}, brighter{.exposure = 1};
    for (const char* file : {"a.png", "a.jpg", "a.tif"})
        for (const ImageEncoding& encoding : {filmic, brighter}) EXPECT_EQ(problemOf({"a.exr", file}, encoding), "none") << file;
    EXPECT_EQ(problemOf({"a.exr", "b.hdr"}, filmic), "--tonemap is for integer formats, and a.exr, b.hdr have floats; add `-o FILE.png`");
    EXPECT_EQ(problemOf({"a.pfm"}, brighter), "--exposure is for integer formats, and a.pfm has floats; add `-o FILE.png`");
    EXPECT_EQ(problemOf({"a.exr"}, {.exposure = 1, .isShown = true}), "none");
    EXPECT_EQ(problemOf({"a.png"}, {.curve = ToneCurve::clamp, .bits = 8}), "none");
}

TEST(CheckEncoding, AFilmAloneIsNoImage) {
    EXPECT_EQ(problemOf({}, {}), "none");
    EXPECT_THAT(problemOf({}, {.bits = 16}), HasSubstr("--bit-depth is for images, and only a film is written"));
    EXPECT_THAT(problemOf({}, {.compression = ExrCompression::piz}), HasSubstr("--compression is for images"));
}

}  // namespace
}  // namespace eikonal
