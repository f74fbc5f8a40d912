#include "film/image_file.h"

#include "error.h"
#include "film/atomic_file.h"
#include "film/channels.h"
#include "film/primaries.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <filesystem>

namespace eikonal {
namespace {

using OIIO::TypeDesc;

enum class Content { layers, linear, screen8, screen16 };
struct Format { const char *extension, *name; Content content; };

constexpr std::array<Format, 11> formats{{{"exr", "openexr", Content::layers},
                                          {"hdr", "hdr", Content::linear},
                                          {"pfm", "pfm", Content::linear},
                                          {"png", "png", Content::screen8},
                                          {"jpg", "jpeg", Content::screen8},
                                          {"jpeg", "jpeg", Content::screen8},
                                          {"tif", "tiff", Content::screen16},
                                          {"tiff", "tiff", Content::screen16},
                                          {"tga", "targa", Content::screen8},
                                          {"bmp", "bmp", Content::screen8},
                                          {"webp", "webp", Content::screen8}}};

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
    throw Error(ExitCode::scene, fmt::format("cannot write \"{}\": {}", path, reason));
}

std::string extensionOf(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    return extension;
}

/// The format that a name's extension stands for, in small or capital letters; null: none.
const Format* findFormat(const std::string& path) {
    const auto found = std::ranges::find_if(formats, [&](const Format& format) { return extensionOf(path) == std::string(".") + format.extension; });
    return found == formats.end() ? nullptr : &*found;
}

const Format& formatOf(const std::string& path) {
    if (const Format* format = findFormat(path)) return *format;
    const std::string extension = extensionOf(path);
    std::string known;
    for (const Format& format : formats) known += std::string(" ") + format.extension;
    fail(path,
         (extension.empty() ? "its name has no extension" : "the extension \"" + extension + "\" is not known") + "; known are" + known);
}

/// Channel after channel of each pixel, as OpenImageIO wants them.
std::vector<float> interleave(const std::vector<ChannelView<const float>>& channels, std::size_t pixels) {
    std::vector<float> values(pixels * channels.size());
    tbb::parallel_for(std::size_t(0), pixels, [&](std::size_t i) {
        for (std::size_t c = 0; c < channels.size(); ++c) {
            const float value = channels[c][i];
            values[i * channels.size() + c] = channels[c].isDepth && !std::isfinite(value) ? noDepth : value;
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

void addAttributes(OIIO::ImageSpec& spec, const Metadata& metadata) {
    const auto addText = [&](const char* name, const std::string& text) { if (!text.empty()) spec.attribute(name, text); };
    if (metadata.samples) spec.attribute("samplesPerPixel", *metadata.samples);
    if (metadata.meanSamples) spec.attribute("meanSamplesPerPixel", static_cast<float>(*metadata.meanSamples));
    if (metadata.targetError) spec.attribute("targetError", static_cast<float>(*metadata.targetError));
    if (metadata.renderSeconds) spec.attribute("renderTimeSeconds", static_cast<float>(*metadata.renderSeconds));
    if (metadata.seed) spec.attribute("seed", *metadata.seed);
    addText("Software", metadata.version);
    addText("scene", metadata.scene);
    addText("sceneHash", metadata.sceneHash);
    addText("device", metadata.device);
    addText("commandLine", metadata.commandLine);
}

OIIO::ImageSpec specOf(const Format& format, const FilmImage& image, const std::vector<std::string>& names) {
    const TypeDesc type = format.content == Content::screen8    ? TypeDesc::UINT8
                          : format.content == Content::screen16 ? TypeDesc::UINT16
                                                                : TypeDesc::FLOAT;
    OIIO::ImageSpec spec(image.columns(), image.rows(), static_cast<int>(names.size()), type);
    spec.channelnames = names;
    if (format.content == Content::layers) {
        spec.x = image.bounds.x0;
        spec.y = image.bounds.y0;
        spec.full_x = spec.full_y = 0;
        spec.full_width = image.width;
        spec.full_height = image.height;
        spec.attribute("compression", "zip");
        spec.attribute("chromaticities", TypeDesc(TypeDesc::FLOAT, 8), srgbPrimaries.data());
        if (!image.spectrum.wavelengths.empty())
            for (const auto& [attribute, text] : spectralAttributes) spec.attribute(attribute, text);
    } else if (format.content != Content::linear) {
        // Not for TIFF: OpenImageIO 2.4 would add an EXIF directory, and in memory that damages the file.
        const std::string name = format.name;
        if (name != "tiff") spec.attribute("oiio:ColorSpace", "sRGB");
        if (name == "jpeg" || name == "webp") spec.attribute("compression", name + ":95");
        if (name == "jpeg") spec.attribute("jpeg:subsampling", "4:4:4");
    }
    return spec;
}

/// The file, made in memory: not every encoder notices that a disk is full.
std::vector<unsigned char> encode(const std::string& path, const Format& format, const OIIO::ImageSpec& spec,
                                  const std::vector<float>& values) {
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    auto output = OIIO::ImageOutput::create(format.name);
    if (!output) fail(path, OIIO::geterror());
    if (!output->set_ioproxy(&memory) || !output->open(std::string("image.") + format.extension, spec) ||
        !output->write_image(TypeDesc::FLOAT, values.data()) || !output->close())
        fail(path, output->geterror());
    return bytes;
}

/// OpenImageIO 2.4 reads the Portable Float Map but does not write it: a header, then rows from the bottom; -1 means little endian.
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

void writeImage(const std::string& path, const FilmImage& image, const Metadata& metadata, const ToneMapping& mapping) {
    const Format& format = formatOf(path);
    if (image.pixelCount() == 0) fail(path, "the image has no pixels");
    std::vector<std::string> names{"R", "G", "B"};
    std::vector<float> values;
    if (format.content == Content::screen8 || format.content == Content::screen16) {
        values = toneMapped(image, mapping);
    } else {
        auto channels = channelsOf<const float>(image);
        if (format.content == Content::linear) channels.erase(channels.begin() + 3, channels.end());
        names.clear();
        for (const auto& channel : channels) names.push_back(channel.name);
        values = interleave(channels, image.pixelCount());
    }

    OIIO::ImageSpec spec = specOf(format, image, names);
    addAttributes(spec, metadata);

    writeFileAtomically(path, std::string(format.name) == "pfm" ? encodePfm(image) : encode(path, format, spec, values));
}

bool holdsChannels(const std::string& path) {
    const Format* format = findFormat(path);
    return format && format->content == Content::layers;
}

void checkWritable(const std::string& path, std::uint64_t bytes) {
    formatOf(path);
    checkFileWritable(path, bytes);
}

}  // namespace eikonal
