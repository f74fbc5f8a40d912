#include "commands/output.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace eikonal {

std::vector<std::string> outputFiles(const OutputOptions& options, const Scene& scene) {
    std::vector<std::string> files = options.files;
    if (files.empty()) files.push_back(scene.film.filename.empty() ? scene.name + ".exr" : scene.film.filename);
    if (options.aovs.any() && std::ranges::none_of(files, holdsChannels))
        throw UsageError(fmt::format("--aov asks for channels that only an EXR has, and {} is none; add -o FILE.exr", fmt::join(files, ", ")));
    if (files.size() == 1 && holdsChannels(files.front()))
        files.push_back(std::filesystem::path(files.front()).replace_extension(".png").string());
    return files;
}

void selectAovs(FilmImage& image, const Aovs& aovs) {
    if (!aovs.albedo) image.albedo.clear();
    if (!aovs.normal) image.normal.clear();
    if (!aovs.geometricNormal) image.geometricNormal.clear();
    if (!aovs.position) image.position.clear();
    if (!aovs.depth) image.depth.clear();
    if (!aovs.object) image.object.clear();
    if (!aovs.material) image.material.clear();
    if (!aovs.variance) image.variance.clear();
    if (!aovs.sampleCount) image.sampleCount.clear();
}

}  // namespace eikonal
