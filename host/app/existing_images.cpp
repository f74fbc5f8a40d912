#include "app/existing_images.h"

#include "app/output.h"
#include "error.h"
#include "image/image_file.h"
#include "messages.h"

#include <fmt/format.h>

#include <filesystem>

namespace eikonal {

/// Whether the image has the size that is asked for, which files other than EXR know only if they have all of it.
static bool hasSize(const FilmImage& image, const std::string& file, const SceneOptions& scene) {
    if (!scene.resolution || (!holdsChannels(file) && (scene.cropWindow || scene.pixelBounds))) return true;
    return image.width == (*scene.resolution)[0] && image.height == (*scene.resolution)[1];
}

/// Why a file is no whole image as these options ask for: it is damaged, has another size than --resolution, fewer samples than --spp, or
/// says that its render was ended early, which EXR and PNG files do. Empty: it is one.
static std::string whyNotWhole(const std::string& file, const Options& options) {
    try {
        const FilmFile there = readImage(file);
        if (!there.metadata.partial.empty()) return "it is partial: " + there.metadata.partial;
        if (!hasSize(there.image, file, options.scene)) return fmt::format("it has {} x {} pixels", there.image.width, there.image.height);
        const auto& samples = there.metadata.samples;
        if (samples && options.scene.spp && *samples < *options.scene.spp && !options.output.targetError)
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
