#include "image/image_file.h"

#include "error.h"
#include "image/atomic_file.h"
#include "image/channels.h"
#include "image/encode_exr.h"
#include "image/encode_png.h"
#include "standard_stream.h"
#include "color/primaries.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <exception>
#include <span>

namespace eikonal {
namespace {

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
    throw Error(ExitCode::scene,
                fmt::format("cannot write {}: {}", isStandardStream(path) ? "to standard output" : "\"" + path + "\"", reason));
}

const ImageFormat& formatOf(const std::string& path, const ImageEncoding& encoding) {
    if (const ImageFormat* format = findImageFormat(path, encoding)) return *format;
    fail(path, unknownFormat(path, encoding));
}

/// Pixel by pixel, with channels interleaved, as files store them.
std::vector<float> interleave(const std::vector<ChannelView<const float>>& channels, std::size_t pixels) {
    std::vector<float> values(pixels * channels.size());
    tbb::parallel_for(std::size_t(0), pixels, [&](std::size_t i) {
        for (std::size_t c = 0; c < channels.size(); ++c) {
            const float value = channels[c][i];
            values[i * channels.size() + c] = channels[c].use.isDepth && !std::isfinite(value) ? noDepth : value;
        }
    });
    return values;
}

std::vector<float> toneMapped(const FilmImage& image, const ToneMapping& mapping) {
    std::vector<float> values(3 * image.pixelCount());
    tbb::parallel_for(std::size_t(0), image.pixelCount(), [&](std::size_t i) {
        const glm::vec3 stored = toneMap(image.color[i], mapping);
        for (int c = 0; c < 3; ++c) values[3 * i + static_cast<std::size_t>(c)] = stored[c];
    });
    return values;
}

void addAttributes(EncodedImage& file, const Metadata& metadata, const ImageEncoding& encoding) {
    const auto add = [&](const char* name, auto value) { file.attributes.emplace_back(name, value); };
    const auto addText = [&](const char* name, const std::string& text) { if (!text.empty()) add(name, text); };
    if (metadata.samples) add("samplesPerPixel", *metadata.samples);
    if (metadata.meanSamples) add("meanSamplesPerPixel", static_cast<float>(*metadata.meanSamples));
    if (metadata.targetError) add("targetError", static_cast<float>(*metadata.targetError));
    if (metadata.error) add("errorEstimate", static_cast<float>(*metadata.error));
    if (metadata.errorLow) add("errorLow", static_cast<float>(*metadata.errorLow));
    if (metadata.errorHigh) add("errorHigh", static_cast<float>(*metadata.errorHigh));
    addText("errorMetric", metadata.errorMetric);
    addText("errorDoubt", metadata.errorDoubt);
    if (metadata.firefliesShare) add("firefliesShare", static_cast<float>(*metadata.firefliesShare));
    addText("partial", metadata.partial);
    if (metadata.renderSeconds && encoding.recordsTime) add("renderTimeSeconds", static_cast<float>(*metadata.renderSeconds));
    if (metadata.seed) add("seed", *metadata.seed);
    addText("Software", metadata.version);
    addText("scene", metadata.scene);
    addText("sceneHash", metadata.sceneHash);
    addText("device", metadata.device);
    addText("biasedChoices", metadata.biasedChoices);
    addText("commandLine", metadata.commandLine);
}

/// What only an EXR has.
void describeLayers(EncodedImage& file, const FilmImage& image, const Metadata& metadata, const ImageEncoding& encoding) {
    file.x = image.bounds.x0;
    file.y = image.bounds.y0;
    file.fullWidth = image.width;
    file.fullHeight = image.height;
    file.compression = encoding.compression.value_or(ExrCompression::zip);
    file.attributes.emplace_back("chromaticities", srgbPrimaries);
    if (metadata.worldToCamera) file.attributes.emplace_back("worldToCamera", *metadata.worldToCamera);
    if (metadata.worldToNdc) file.attributes.emplace_back("worldToNDC", *metadata.worldToNdc);
    for (const CryptomatteLayer& layer : image.cryptomattes)
        for (auto& attribute : cryptomatteAttributes(layer)) file.attributes.push_back(std::move(attribute));
    if (!image.spectrum.wavelengths.empty())
        for (const auto& [attribute, text] : spectralAttributes) file.attributes.emplace_back(attribute, text);
}

/// The description of the image for a file in this format, without the values.
EncodedImage describe(const ImageFormat& format, const FilmImage& image, const Metadata& metadata, const ImageEncoding& encoding) {
    using enum EncodedImage::Values;
    EncodedImage file;
    file.stored = format.content != ImageContent::screen ? floats : encoding.bits.value_or(format.bits) == 16 ? words : bytes;
    file.width = file.fullWidth = image.columns();
    file.height = file.fullHeight = image.rows();
    file.channels = {"R", "G", "B"};
    if (format.content == ImageContent::layers) describeLayers(file, image, metadata, encoding);
    addAttributes(file, metadata, encoding);
    return file;
}

/// Adds the values of all channels that the format holds, and their names.
void addChannels(EncodedImage& file, const ImageFormat& format, const FilmImage& image, const ImageEncoding& encoding) {
    const bool holdsLayers = format.content == ImageContent::layers;
    const ChannelNames spelling = encoding.channelNames.value_or(ChannelNames::eikonal);
    auto channels = channelsOf<const float>(image, spelling);
    if (!holdsLayers) channels.erase(channels.begin() + 3, channels.end());
    /* pbrt-v4 reads a file only if all its channels have the same type */
    const bool hasHalves = holdsLayers && encoding.halfFloats.value_or(image.halfFloats), hasOneType = spelling == ChannelNames::pbrt;
    file.channels.clear();
    for (const auto& channel : channels) {
        file.channels.push_back(channel.name);
        file.isHalf.push_back(hasHalves && !channel.use.isBits && (hasOneType || !channel.use.needsFloats));
    }
    file.values = interleave(channels, image.pixelCount());
    if (!format.holdsNegatives) std::ranges::transform(file.values, file.values.begin(), [](float v) { return v > 0 ? v : 0; });
}

/// The formats that every render writes do not need OpenImageIO.
std::vector<unsigned char> encode(const std::string& path, const ImageFormat& format, const EncodedImage& image) {
    const std::string name = format.name;
    try {
        if (name == "openexr") return encodeExr(image);
        if (name == "png") return encodePng(image);
    } catch (const std::bad_alloc&) {
        fail(path, "not enough memory");
    } catch (const std::exception& error) { fail(path, error.what()); }
    std::string error;
    std::vector<unsigned char> bytes = imageFormats().encode(name, format.extension, image, error);
    if (bytes.empty()) fail(path, error);
    return bytes;
}

/// OpenImageIO 2.4 reads the Portable Float Map but does not write it. Writes a header, then rows from the bottom; -1 means little endian.
std::vector<unsigned char> encodePfm(const FilmImage& image) {
    const std::string header =
        fmt::format("PF\n{} {}\n{}\n", image.columns(), image.rows(), std::endian::native == std::endian::little ? "-1.0" : "1.0");
    std::vector<unsigned char> bytes(header.begin(), header.end());
    for (int y = image.bounds.y1 - 1; y >= image.bounds.y0; --y) {
        const auto* row = reinterpret_cast<const unsigned char*>(&image.color[image.index(image.bounds.x0, y)]);
        bytes.insert(bytes.end(), row, row + static_cast<std::size_t>(image.columns()) * sizeof(glm::vec3));
    }
    return bytes;
}

}  // namespace

void checkHolds(const std::string& path, int columns, int rows, const ImageEncoding& encoding) {
    const ImageFormat& format = formatOf(path, encoding);
    if (std::max(columns, rows) > format.mostPixels)
        fail(path, fmt::format("a file of this kind holds at most {0} x {0} pixels, and the image has {1} x {2}", format.mostPixels,
                               columns, rows));
}

/// Where an image goes.
static void store(const std::string& path, std::span<const unsigned char> content) {
    if (isStandardStream(path)) writeToStandardOutput(content);
    else writeFileAtomically(path, content);
}

void writeImage(const std::string& path, const FilmImage& image, const Metadata& metadata, const ImageEncoding& encoding) {
    const ImageFormat& format = formatOf(path, encoding);
    if (image.pixelCount() == 0) fail(path, "the image has no pixels");
    checkHolds(path, image.columns(), image.rows(), encoding);
    if (std::string(format.name) == "pfm") {
        store(path, encodePfm(image));
        return;
    }
    EncodedImage file = describe(format, image, metadata, encoding);
    if (format.content == ImageContent::screen) file.values = toneMapped(image, encoding.toneMapping());
    else addChannels(file, format, image, encoding);
    store(path, encode(path, format, file));
}

void checkWritable(const std::string& path, std::uint64_t bytes, const ImageEncoding& encoding) {
    formatOf(path, encoding);
    if (isStandardStream(path)) checkStandardOutput();
    else checkFileWritable(path, bytes);
}

}  // namespace eikonal
