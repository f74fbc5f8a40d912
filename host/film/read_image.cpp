#include "film/image_file.h"

#include "error.h"
#include "film/channels.h"
#include "film/primaries.h"
#include "scene/image.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace eikonal {
namespace {

using OIIO::TypeDesc;

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
    throw Error(ExitCode::scene, fmt::format("cannot read image \"{}\": {}", path, reason));
}

Metadata metadataOf(const OIIO::ImageSpec& spec) {
    Metadata metadata;
    int number = 0;
    if (spec.getattribute("samplesPerPixel", TypeDesc::INT, &number)) metadata.samples = number;
    if (spec.getattribute("seed", TypeDesc::INT, &number)) metadata.seed = number;
    const auto readNumber = [&](const char* name, std::optional<double>& value) {
        if (float found = 0; spec.getattribute(name, TypeDesc::FLOAT, &found)) value = found;
    };
    readNumber("renderTimeSeconds", metadata.renderSeconds);
    readNumber("meanSamplesPerPixel", metadata.meanSamples);
    readNumber("targetError", metadata.targetError);
    metadata.version = spec.get_string_attribute("Software");
    metadata.scene = spec.get_string_attribute("scene");
    metadata.sceneHash = spec.get_string_attribute("sceneHash");
    metadata.device = spec.get_string_attribute("device");
    metadata.commandLine = spec.get_string_attribute("commandLine");
    return metadata;
}

int find(const OIIO::ImageSpec& spec, const std::string& channel) {
    const auto found = std::ranges::find(spec.channelnames, channel);
    return found == spec.channelnames.end() ? -1 : static_cast<int>(found - spec.channelnames.begin());
}

/// An 8- or 16-bit file, decoded as a texture is.
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
    auto input = OIIO::ImageInput::open(path);
    if (!input || !input->spec().format.is_floating_point()) {
        OIIO::geterror();
        FilmImage image = decoded(path);
        return {std::move(image), input ? metadataOf(input->spec()) : Metadata{}};
    }
    const OIIO::ImageSpec& spec = input->spec();
    std::vector<float> values(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
    if (!input->read_image(0, 0, 0, spec.nchannels, TypeDesc::FLOAT, values.data())) fail(path, input->geterror());

    // Which of our channels the file has.
    const int grey = spec.nchannels == 1 ? 0 : find(spec, "R") < 0 ? find(spec, "Y") : -1;
    if (grey < 0 && (find(spec, "R") < 0 || find(spec, "G") < 0 || find(spec, "B") < 0)) fail(path, "it has no channel R G B or Y");
    const int x0 = spec.x - spec.full_x, y0 = spec.y - spec.full_y;
    FilmFile file{{spec.full_width, spec.full_height, {x0, x0 + spec.width, y0, y0 + spec.height}}, metadataOf(spec)};
    FilmImage& image = file.image;
    const auto has = [&](const char* name) { return find(spec, name) >= 0; };
    if (has("albedo.R") && has("albedo.G") && has("albedo.B")) image.albedo.resize(image.pixelCount());
    if (has("N.X") && has("N.Y") && has("N.Z")) image.normal.resize(image.pixelCount());
    if (has("Ng.X") && has("Ng.Y") && has("Ng.Z")) image.geometricNormal.resize(image.pixelCount());
    if (has("P.X") && has("P.Y") && has("P.Z")) image.position.resize(image.pixelCount());
    if (has("u") && has("v")) image.uv.resize(image.pixelCount());
    if (has("dzdx") && has("dzdy")) image.depthSlope.resize(image.pixelCount());
    if (has("motion.X") && has("motion.Y")) image.motion.resize(image.pixelCount());
    if (has("objectId")) image.object.resize(image.pixelCount());
    if (has("materialId")) image.material.resize(image.pixelCount());
    if (has("Z")) image.depth.resize(image.pixelCount());
    if (has("variance")) image.variance.resize(image.pixelCount());
    if (has("sampleCount")) image.sampleCount.resize(image.pixelCount());
    for (const std::string& name : spec.channelnames)
        if (const auto wavelength = wavelengthOfChannel(name)) image.spectrum.wavelengths.push_back(*wavelength);
    std::ranges::sort(image.spectrum.wavelengths);
    image.spectrum.radiance.resize(image.spectrum.wavelengths.size() * image.pixelCount());

    for (const auto& channel : channelsOf<float>(image)) {
        const bool isColor = channel.name == "R" || channel.name == "G" || channel.name == "B";
        const int from = isColor && grey >= 0 ? grey : find(spec, channel.name);
        for (std::size_t i = 0; i < image.pixelCount(); ++i) {
            const float value = values[i * static_cast<std::size_t>(spec.nchannels) + static_cast<std::size_t>(from)];
            channel[i] = channel.isDepth && value >= noDepth ? std::numeric_limits<float>::infinity() : value;
        }
    }

    if (Primaries primaries{}; spec.getattribute("chromaticities", TypeDesc(TypeDesc::FLOAT, 8), primaries.data()))
        if (const auto matrix = srgbFromPrimaries(primaries)) {
            convert(image.color, *matrix);
            convert(image.albedo, *matrix);
        }
    return file;
}

}  // namespace eikonal
