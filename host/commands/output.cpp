#include "commands/output.h"

#include <filesystem>

namespace eikonal {

std::vector<std::string> outputFiles(const OutputOptions& options, const Scene& scene) {
    std::vector<std::string> files = options.files;
    if (files.empty()) files.push_back(scene.film.filename.empty() ? scene.name + ".exr" : scene.film.filename);
    const std::filesystem::path first = files.front();
    if (files.size() == 1 && (first.extension() == ".exr" || first.extension() == ".EXR"))
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
