#include "app/existing_images.h"

#include "app/output.h"
#include "diagnostics.h"
#include "error.h"
#include "image/denoise.h"
#include "image/image_file.h"
#include "messages.h"
#include "pack/camera.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>

namespace eikonal {

/// Whether the image has the size that is asked for, which files other than EXR know only if they have all of it.
static bool hasSize(const FilmImage& image, const std::string& file, const SceneOptions& scene) {
    if (!scene.resolution || (!holdsChannels(file) && (scene.cropWindow || scene.pixelBounds))) return true;
    return image.width == (*scene.resolution)[0] && image.height == (*scene.resolution)[1];
}

/// The pixels that --cropwindow or --pixelbounds select, if they can be told: of an EXR, or with --resolution.
static std::optional<PixelRect> partAsked(const FilmImage& image, const std::string& file, const SceneOptions& scene) {
    if ((!scene.cropWindow && !scene.pixelBounds) || (!scene.resolution && !holdsChannels(file))) return {};
    FilmDescription film{.width = image.width, .height = image.height, .cropWindow = scene.cropWindow, .pixelBounds = scene.pixelBounds};
    if (scene.resolution) {
        film.width = (*scene.resolution)[0];
        film.height = (*scene.resolution)[1];
    }
    Diagnostics quiet(LogLevel::silent);
    return renderedPixels(film, quiet);
}

/// Whether the image has the pixels that --cropwindow or --pixelbounds select; files other than EXR know only how many.
static bool hasPart(const FilmImage& image, const std::string& file, const SceneOptions& scene) {
    const auto part = partAsked(image, file, scene);
    if (!part) return true;
    const PixelBounds& there = image.bounds;
    const bool isAtPlace = !holdsChannels(file) || (there.x0 == part->x0 && there.y0 == part->y0);
    return isAtPlace && image.columns() == part->width() && image.rows() == part->height();
}

/// Whether Intel Open Image Denoise is there. Without it, a frame that is rendered again stays noisy.
static bool canDenoise() {
    try {
        const Denoiser denoiser(1);
        return true;
    } catch (const Error&) { return false; }
}

/// Why a file is no whole image as these options ask for: it is damaged, has another size than --resolution, other pixels than --cropwindow
/// or --pixelbounds, fewer samples than --spp, lacks a layer of --aov or --denoise, or says that its render was ended early, which EXR and
/// PNG files do. Empty: it is one.
static std::string whyNotWhole(const std::string& file, const Options& options) {
    try {
        const FilmFile there = readImage(file);
        if (!there.metadata.partial.empty()) return "it is partial: " + there.metadata.partial;
        if (!hasSize(there.image, file, options.scene)) return fmt::format("it has {} x {} pixels", there.image.width, there.image.height);
        if (!hasPart(there.image, file, options.scene)) return "it shows another part of the image";
        const OutputOptions& out = options.output;
        if (const char* missing = holdsChannels(file, out.encoding) ? missingAov(there.image, out.aovs) : nullptr)
            return fmt::format("it has no layer \"{}\"", missing);
        if (out.denoise && holdsChannels(file, out.encoding) && there.image.noisy.empty() && canDenoise()) return "it is not denoised";
        const auto& samples = there.metadata.samples;
        if (samples && options.scene.spp && *samples < *options.scene.spp && !out.targetError)
            return fmt::format("it has {} of {} samples per pixel", *samples, *options.scene.spp);
        return {};
    } catch (const Error& error) { return error.what(); }
}

bool hasWholeImages(const Options& options) {
    const std::vector<std::string> files = imageFiles(options.output.files, options.output.encoding);
    bool isWhole = !files.empty();
    for (const std::string& file : files) {
        std::error_code unknown;
        if (!std::filesystem::exists(file, unknown)) return false;
    }
    for (const std::string& file : files) {
        const std::string why = whyNotWhole(file, options);
        if (why.empty()) continue;
        tellResult(fmt::format("{} is rendered again: {}", file, why), options.log);
        isWhole = false;
    }
    return isWhole;
}

}  // namespace eikonal
