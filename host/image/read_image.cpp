#include "image/image_file.h"

#include "error.h"
#include "image/channels.h"
#include "color/primaries.h"
#include "image/formats/image_formats.h"
#include "read/formats/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace eikonal {
namespace {

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
    throw Error(ExitCode::scene, fmt::format("cannot read image \"{}\": {}", path, reason));
}

Metadata metadataOf(const ImageReader& file) {
    return {.samples = file.integer("samplesPerPixel"),
            .meanSamples = file.number("meanSamplesPerPixel"),
            .targetError = file.number("targetError"),
            .error = file.number("errorEstimate"),
            .errorLow = file.number("errorLow"),
            .errorHigh = file.number("errorHigh"),
            .errorMetric = file.text("errorMetric"),
            .errorDoubt = file.text("errorDoubt"),
            .firefliesShare = file.number("firefliesShare"),
            .partial = file.text("partial"),
            .renderSeconds = file.number("renderTimeSeconds"),
            .seed = file.integer("seed"),
            .version = file.text("Software"),
            .scene = file.text("scene"),
            .sceneHash = file.text("sceneHash"),
            .device = file.text("device"),
            .biasedChoices = file.text("biasedChoices"),
            .commandLine = file.text("commandLine"),
            .worldToCamera = file.matrix("worldToCamera"),
            .worldToNdc = file.matrix("worldToNDC")};
}

int find(const ImageReader::Header& header, const std::string& channel) {
    const auto found = std::ranges::find(header.channels, channel);
    return found == header.channels.end() ? -1 : static_cast<int>(found - header.channels.begin());
}

/// Reads an 8- or 16-bit file, decoded like a texture.
FilmImage decoded(const std::string& path) {
    const auto texels = loadImage(ImageFile{.path = path});
    FilmImage image(texels->width, texels->height);
    for (int y = 0; y < texels->height; ++y)
        for (int x = 0; x < texels->width; ++x)
            for (int c = 0; c < 3; ++c) image.color[image.index(x, y)][c] = texels->at(x, y, texels->channels == 1 ? 0 : c);
    return image;
}

void convert(std::vector<glm::vec3>& colors, const glm::dmat3& matrix) {
    for (glm::vec3& color : colors) color = glm::vec3(matrix * glm::dvec3(color));
}

}  // namespace

FilmFile readImage(const std::string& path) {
    std::string reason;
    const auto input = openImage(path, false, reason);
    if (!input || !input->header().isFloatingPoint) {
        FilmImage image = decoded(path);
        return {std::move(image), input ? metadataOf(*input) : Metadata{}};
    }
    const ImageReader::Header& header = input->header();
    const std::size_t channelCount = header.channels.size();
    std::vector<float> values(header.pixels() * channelCount);
    if (!input->read(values.data())) fail(path, input->error());

    // Find which of our channels the file has.
    const int grey = channelCount == 1 ? 0 : find(header, "R") < 0 ? find(header, "Y") : -1;
    if (grey < 0 && (find(header, "R") < 0 || find(header, "G") < 0 || find(header, "B") < 0)) fail(path, "it has no channel R G B or Y");
    const int x0 = header.x, y0 = header.y;
    FilmFile file{{header.fullWidth, header.fullHeight, {x0, x0 + header.width, y0, y0 + header.height}}, metadataOf(*input)};
    FilmImage& image = file.image;
    const auto has = [&](const char* name) { return find(header, name) >= 0; };
    const ChannelNames spelling = has("Albedo.R") || has("Ns.X") || has("Variance.R") ? ChannelNames::pbrt : ChannelNames::eikonal;
    forChannels(image, spelling, [&](auto& values, const ComponentNames& names, ChannelUse) {
        if (std::ranges::all_of(names, [&](const char* name) { return !name || has(name); })) values.resize(image.pixelCount());
    });
    for (const std::string& name : header.channels)
        if (name.starts_with(lightGroupPrefix) && name.ends_with(".R")) {
            const std::string group = name.substr(std::strlen(lightGroupPrefix), name.size() - std::strlen(lightGroupPrefix) - 2);
            if (has(lightGroupChannel(group, 1).c_str()) && has(lightGroupChannel(group, 2).c_str()))
                image.lightGroups.push_back({group, std::vector<glm::vec3>(image.pixelCount())});
        }
    for (const char* const name : cryptomatteLayerNames) {
        std::size_t found = 0;
        while (found < CryptomatteLayer::perPixel && has(cryptomatteChannel(name, found).c_str())) ++found;
        if (found == CryptomatteLayer::perPixel)
            image.cryptomattes.push_back({name, input->text(cryptomatteAttribute(name, "manifest").c_str()),
                                          std::vector<float>(found * image.pixelCount())});
    }
    for (const std::string& name : header.channels)
        if (const auto wavelength = wavelengthOfChannel(name)) image.spectrum.wavelengths.push_back(*wavelength);
    std::ranges::sort(image.spectrum.wavelengths);
    image.spectrum.radiance.resize(image.spectrum.wavelengths.size() * image.pixelCount());

    for (const auto& channel : channelsOf<float>(image, spelling)) {
        const bool isColor = channel.name == "R" || channel.name == "G" || channel.name == "B";
        const int from = isColor && grey >= 0 ? grey : find(header, channel.name);
        for (std::size_t i = 0; i < image.pixelCount(); ++i) {
            const float value = values[i * channelCount + static_cast<std::size_t>(from)];
            channel[i] = channel.use.isDepth && value >= noDepth ? std::numeric_limits<float>::infinity() : value;
        }
    }

    if (const std::optional<Primaries> primaries = input->chromaticities())
        if (const auto matrix = srgbFromPrimaries(*primaries)) {
            for (auto* colors : {&image.color, &image.noisy, &image.fireflies, &image.emission, &image.direct, &image.indirect,
                                 &image.volume, &image.albedo})
                convert(*colors, *matrix);
            for (LightGroup& group : image.lightGroups) convert(group.color, *matrix);
        }
    return file;
}

}  // namespace eikonal
