#include "app/output.h"

#include "error.h"
#include "image/image_encoding.h"
#include "read/formats/input_files.h"
#include "standard_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace eikonal {

static bool anyHoldsChannels(const std::vector<std::string>& files, const ImageEncoding& encoding) {
    return std::ranges::any_of(files, [&](const std::string& file) { return holdsChannels(file, encoding); });
}

std::vector<std::string> outputFiles(const OutputOptions& options, const Scene& scene) {
    if (!options.hasImage) return {};
    std::vector<std::string> files = options.files;
    if (files.empty() && options.encoding.format.empty() && !scene.film.filename.empty()) files.push_back(scene.film.filename);
    if (files.empty()) files.push_back(scene.name + "." + chosenExtension(options.encoding));
    if (options.aovs.any() && !anyHoldsChannels(files, options.encoding))
        throw UsageError(
            fmt::format("--aov needs an EXR file, and {} cannot hold its channels; add `-o FILE.exr`", fmt::join(files, ", ")));
    if (options.aovs.has(AovSource::names) && options.encoding.compression.value_or(ExrCompression::zip) > ExrCompression::piz)
        throw UsageError("--aov cryptomatte needs --compression none, rle, zips, zip or piz: the others change the IDs");
    files = imageFiles(std::move(files), options.encoding);
    checkEncoding(files, options.encoding);
    return files;
}

std::vector<std::string> imageFiles(std::vector<std::string> files, const ImageEncoding& encoding) {
    if (files.size() == 1 && encoding.format.empty() && holdsChannels(files.front()))
        files.push_back(std::filesystem::path(files.front()).replace_extension(".png").string());
    return files;
}

/// Whether some file can hold additional channels; warns if none can.
static bool canHold(const char* what, const OutputOptions& options, const FilmDescription& film, const std::vector<std::string>& files,
                    Diagnostics& diagnostics) {
    if (files.empty() || anyHoldsChannels(files, options.encoding)) return true;
    diagnostics.warn(film.where, fmt::format("{} are omitted: {} cannot hold them; add `-o FILE.exr`", what, fmt::join(files, ", ")));
    return false;
}

Aovs aovsOf(const OutputOptions& options, const FilmDescription& film, const std::vector<std::string>& files, Diagnostics& diagnostics) {
    Aovs aovs = options.aovs;
    aovs.albedo |= options.denoise;
    aovs.normal |= options.denoise;
    if (film.gbuffer != GBuffer::none && canHold("the additional channels of film \"gbuffer\"", options, film, files, diagnostics))
        for (const AovName& each : aovNames)
            if (each.source == AovSource::surfaces || each.source == AovSource::statistics) aovs.*each.asked = true;
    return aovs;
}

bool keepsSpectrum(const OutputOptions& options, const FilmDescription& film, const std::vector<std::string>& files,
                   Diagnostics& diagnostics) {
    return film.spectrum && canHold("the channels of film \"spectral\"", options, film, files, diagnostics);
}

void checkIsNoInput(const std::string& output, const std::vector<std::string>& scenes) {
    std::vector<std::string> inputs = inputFiles();
    inputs.insert(inputs.end(), scenes.begin(), scenes.end());
    std::error_code absent;
    for (const std::string& input : inputs)
        if (!isStandardStream(output) && std::filesystem::equivalent(output, input, absent))
            throw Error(ExitCode::scene, fmt::format("cannot write \"{}\": the scene is read from it; name another file with -o", output));
}

void checkIsApart(const std::string& output, const Options& options) {
    if (isStandardStream(output)) return;
    const auto placeOf = [](const std::string& file) {
        std::error_code error;
        const std::filesystem::path place = std::filesystem::weakly_canonical(std::filesystem::absolute(file, error), error);
        return error ? std::filesystem::path(file) : place;
    };
    for (const auto& [option, file] : {std::pair("--checkpoint", options.output.checkpoint), {"--log-file", options.logFile}})
        if (!file.empty() && placeOf(file) == placeOf(output))
            throw UsageError(fmt::format("{} and -o both name \"{}\"; one would overwrite the other", option, output));
}

/// Calls visit(member of Aovs, values) for each vector of channels that --aov names.
template <class Image, class Visit>
static void forAovs(Image& image, Visit visit) {
    visit(&Aovs::emission, image.emission);
    visit(&Aovs::direct, image.direct);
    visit(&Aovs::indirect, image.indirect);
    visit(&Aovs::volume, image.volume);
    visit(&Aovs::lightGroups, image.lightGroups);
    visit(&Aovs::albedo, image.albedo);
    visit(&Aovs::normal, image.normal);
    visit(&Aovs::geometricNormal, image.geometricNormal);
    visit(&Aovs::position, image.position);
    visit(&Aovs::uv, image.uv);
    visit(&Aovs::depthSlope, image.depthSlope);
    visit(&Aovs::motion, image.motion);
    visit(&Aovs::depth, image.depth);
    visit(&Aovs::object, image.object);
    visit(&Aovs::material, image.material);
    visit(&Aovs::variance, image.variance);
    visit(&Aovs::sampleCount, image.sampleCount);
}

/// Whether --aov asks for a layer of Cryptomatte of this name.
static bool isAsked(const Aovs& aovs, const std::string& layer) {
    const auto& [objects, materials] = cryptomatteLayerNames;
    return (layer != objects || aovs.cryptoObject) && (layer != materials || aovs.cryptoMaterial);
}

void selectAovs(FilmImage& image, const Aovs& aovs) {
    forAovs(image, [&](bool Aovs::*asked, auto& values) {
        if (!(aovs.*asked)) values.clear();
    });
    std::erase_if(image.cryptomattes, [&](const CryptomatteLayer& layer) { return !isAsked(aovs, layer.name); });
}

const char* missingAov(const FilmImage& image, const Aovs& aovs) {
    Aovs missing;
    forAovs(image, [&](bool Aovs::*asked, auto& values) { missing.*asked = aovs.*asked && values.empty(); });
    missing.variance = missing.variance && image.sampleVariance.empty();  // in pbrt's spelling
    const auto& [objects, materials] = cryptomatteLayerNames;
    const auto hasLayer = [&](const char* name) {
        return std::ranges::any_of(image.cryptomattes, [&](const CryptomatteLayer& layer) { return layer.name == name; });
    };
    missing.cryptoObject = aovs.cryptoObject && !hasLayer(objects);
    missing.cryptoMaterial = aovs.cryptoMaterial && !hasLayer(materials);
    for (const AovName& each : aovNames)
        if (missing.*each.asked) return each.name;
    return nullptr;
}

}  // namespace eikonal
