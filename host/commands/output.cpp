#include "commands/output.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace eikonal {

static bool isExr(const std::filesystem::path& file) { return file.extension() == ".exr" || file.extension() == ".EXR"; }

std::vector<std::string> outputFiles(const OutputOptions& options, const Scene& scene) {
    std::vector<std::string> files = options.files;
    if (files.empty()) files.push_back(scene.film.filename.empty() ? scene.name + ".exr" : scene.film.filename);
    const Aovs& aovs = options.aovs;
    if ((aovs.albedo || aovs.normal || aovs.depth || aovs.variance || aovs.sampleCount) && std::none_of(files.begin(), files.end(), isExr))
        throw UsageError(fmt::format("--aov asks for channels that only an EXR has, and {} is none; add -o FILE.exr", fmt::join(files, ", ")));
    const std::filesystem::path first = files.front();
    if (files.size() == 1 && isExr(first))
        files.push_back(std::filesystem::path(first).replace_extension(".png").string());
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
