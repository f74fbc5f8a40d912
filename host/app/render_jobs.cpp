#include "app/render_jobs.h"

#include "error.h"
#include "read/scene_name.h"
#include "standard_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

namespace eikonal {
namespace {

namespace fs = std::filesystem;

/// The file for a scene that -o leads to.
std::string fileFor(const std::string& scene, const std::string& output, const ImageEncoding& encoding) {
    if (!isFolder(output)) return output;
    return (fs::path(output) / (sceneName(scene) + "." + (encoding.format.empty() ? "exr" : encoding.format))).string();
}

/// What several scenes cannot share.
void checkSeveral(const Options& o) {
    const OutputOptions& out = o.output;
    for (const std::string& file : out.files)
        if (!isFolder(file))
            throw UsageError(
                fmt::format("-o {} is one file, and there are {} scenes; name a folder, in which each image is called like its "
                            "scene: -o FOLDER/",
                            file, o.scenes.size()));
    if (out.deadline)
        throw UsageError(fmt::format("--deadline is the time of one render, and there are {} scenes; --time-limit counts for each of them",
                                     o.scenes.size()));
    if (!out.checkpoint.empty())
        throw UsageError(fmt::format("\"{}\" is one film, and there are {} scenes; render each of them in a call of its own",
                                     out.checkpoint, o.scenes.size()));
}

/// One file may be the image of one scene only.
void checkNames(const std::vector<Options>& jobs) {
    std::map<std::string, std::string> scenes;  // by file
    for (const Options& job : jobs)
        for (const std::string& file : job.output.files)
            if (const auto [before, isNew] = scenes.emplace(file, job.scene.path); !isNew)
                throw UsageError(fmt::format("{} would be the image of both {} and {}; render them in two calls, into two folders", file,
                                             before->second, job.scene.path));
}

}  // namespace

bool isFolder(const std::string& name) {
    std::error_code absent;
    return name.ends_with('/') || fs::is_directory(name, absent);
}

std::vector<Options> renderJobs(const Options& options) {
    if (options.scenes.size() > 1) checkSeveral(options);
    if (std::ranges::count_if(options.scenes, isStandardStream) > 1) throw UsageError("standard input holds one scene; name it once");
    std::vector<Options> jobs;
    for (const std::string& scene : options.scenes) {
        Options job = options;
        job.scene.path = scene;
        for (std::string& file : job.output.files) file = fileFor(scene, file, job.output.encoding);
        jobs.push_back(std::move(job));
    }
    checkNames(jobs);
    return jobs;
}

}  // namespace eikonal
