#include "app/render_jobs.h"

#include "app/frame_numbers.h"
#include "error.h"
#include "read/scene_name.h"
#include "render/scene_loading.h"
#include "standard_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

namespace eikonal {
namespace {

namespace fs = std::filesystem;

/// Whether the frames of a call are those of scenes that are one file each.
bool shareScenes(const SceneOptions& scene) { return scene.fps || scene.turntable; }

/// The file for a render that -o leads to.
std::string fileFor(const RenderJob& job, const std::string& output, const Options& o) {
    if (!isFolder(output)) return job.frame ? withFrame(output, *job.frame) : output;
    const std::string number = job.frame && shareScenes(o.scene) ? fmt::format(".{:04}", *job.frame) : "";
    return (fs::path(output) / (sceneName(job.scene) + number + "." + chosenExtension(o.output.encoding))).string();
}

/// How many renders, of what: "2 scenes", "10 frames".
std::string countOf(const Options& o) {
    return o.scenes.size() > 1 ? fmt::format("{} scenes", o.scenes.size()) : fmt::format("{} frames", o.frames.size());
}

/// What several renders cannot share.
void checkSeveral(const Options& o) {
    const OutputOptions& out = o.output;
    const bool severalScenes = o.scenes.size() > 1, severalFrames = o.frames.size() > 1;
    for (const std::string& file : out.files) {
        if (isFolder(file)) continue;
        if (severalScenes)
            throw UsageError(
                fmt::format("-o {} is one file, and there are {} scenes; name a folder, in which each image is called like its "
                            "scene: -o FOLDER/",
                            file, o.scenes.size()));
        if (!hasFramePlace(file))
            throw UsageError(
                fmt::format("-o {} is one file, and there are {} frames; write #### where their numbers go, like -o "
                            "image.####.exr, or name a folder: -o FOLDER/",
                            file, o.frames.size()));
    }
    if (severalFrames && out.files.empty() && out.hasImage && shareScenes(o.scene))
        throw UsageError(fmt::format("{} frames of one scene need files of their own: -o image.####.exr, or -o FOLDER/", o.frames.size()));
    if (out.deadline)
        throw UsageError(
            fmt::format("--deadline is the time of one render, and there are {}; --time-limit counts for each of them", countOf(o)));
    if (o.watch.page && severalFrames)
        throw UsageError(fmt::format("--view shows one render, and there are {}; --display-server shows each of them", countOf(o)));
    if (!out.checkpoint.empty() && severalScenes)
        throw UsageError(fmt::format("\"{}\" is one film, and there are {} scenes; render each of them in a call of its own",
                                     out.checkpoint, o.scenes.size()));
    if (!out.checkpoint.empty() && !hasFramePlace(out.checkpoint))
        throw UsageError(fmt::format("\"{}\" is one film, and there are {} frames; write #### where their numbers go, like part.####.film",
                                     out.checkpoint, o.frames.size()));
}

/// Each scene has the frames that are asked for.
void checkFrames(const Options& o) {
    for (const std::string& scene : o.scenes) {
        std::error_code absent;
        const bool hasPlace = hasFramePlace(scene);
        if (o.frames.empty()) {
            if (hasPlace && !fs::exists(scene, absent))
                throw UsageError(fmt::format("there is no file \"{}\"; with --frames, # is the number of a frame: --frames 1-10", scene));
            continue;
        }
        if (o.scene.turntable && !isObj(scene))
            throw UsageError(
                fmt::format("--turntable is for OBJ files; write the camera of \"{}\" itself, or let it move: --fps 24", scene));
        if (o.scene.fps && isObj(scene))
            throw UsageError(fmt::format("--fps is for pbrt scenes, which move; \"{}\" can turn: --turntable 36", scene));
        if (isStandardStream(scene)) throw UsageError("standard input holds one scene and can be read once; frames need files");
        if (hasPlace && shareScenes(o.scene))
            throw UsageError(fmt::format("\"{}\" has a file for each frame, and {} makes frames of a single one; give one of both", scene,
                                         o.scene.fps ? "--fps" : "--turntable"));
        if (!hasPlace && !shareScenes(o.scene))
            throw UsageError(
                fmt::format("--frames: \"{}\" is one file. Write #### where the number of a frame goes, like scene.####.pbrt; "
                            "or, if the scene moves, say how many frames are a unit of its time, like --fps 24; or let "
                            "the camera turn about an OBJ: --turntable 36",
                            scene));
    }
}

/// One file may be the image of one render only.
void checkNames(const std::vector<RenderJob>& jobs) {
    std::map<std::string, const RenderJob*> owners;
    const auto name = [&](const RenderJob& job) { return job.frame ? fmt::format("frame {} of {}", *job.frame, job.named) : job.scene; };
    for (const RenderJob& job : jobs)
        for (const std::string& file : job.files)
            if (const auto [before, isNew] = owners.emplace(fs::path(file).lexically_normal().string(), &job); !isNew)
                throw UsageError(before->second == &job ? fmt::format("{} is named twice; one -o is enough for a file", file)
                                                        : fmt::format("{} would be the image of both {} and {}; render them in two calls, "
                                                                      "into two folders",
                                                                      file, name(*before->second), name(job)));
}

}  // namespace

bool isFolder(const std::string& name) {
    std::error_code absent;
    return name.ends_with('/') || fs::is_directory(name, absent);
}

std::vector<RenderJob> renderJobs(const Options& o) {
    checkFrames(o);
    if (o.scenes.size() > 1 || o.frames.size() > 1) checkSeveral(o);
    if (std::ranges::count_if(o.scenes, isStandardStream) > 1) throw UsageError("standard input holds one scene; name it once");
    std::vector<RenderJob> jobs;
    const auto add = [&](const std::string& scene, std::optional<int> frame) {
        RenderJob job{scene, scene, frame, {}, o.output.checkpoint};
        if (frame) {
            job.scene = withFrame(scene, *frame);
            job.checkpoint = withFrame(job.checkpoint, *frame);
        }
        for (const std::string& file : o.output.files) job.files.push_back(fileFor(job, file, o));
        jobs.push_back(std::move(job));
    };
    for (const std::string& scene : o.scenes) {
        if (o.frames.empty()) add(scene, {});
        for (const int frame : o.frames) add(scene, frame);
    }
    checkNames(jobs);
    return jobs;
}

std::vector<std::string> takeMissing(std::vector<RenderJob>& jobs) {
    struct Missing {
        std::vector<int> frames;
        std::string first;  // of the files
    };
    std::map<std::string, Missing> scenes;
    std::erase_if(jobs, [&](const RenderJob& job) {
        std::error_code absent;
        if (!job.frame || job.named == job.scene || fs::exists(job.scene, absent)) return false;
        Missing& missing = scenes[job.named];
        if (missing.frames.empty()) missing.first = job.scene;
        missing.frames.push_back(*job.frame);
        return true;
    });
    std::vector<std::string> lines;
    for (auto& [scene, missing] : scenes) {
        std::ranges::sort(missing.frames);
        lines.push_back(fmt::format("{} has no file for {} {}: there is no \"{}\"{}", scene,
                                    missing.frames.size() == 1 ? "frame" : "frames", frameRanges(missing.frames), missing.first,
                                    missing.frames.size() == 1 ? "" : fmt::format(", nor {} others", missing.frames.size() - 1)));
    }
    return lines;
}

Options optionsOf(const Options& options, const std::vector<RenderJob>& jobs, std::size_t index) {
    const RenderJob& job = jobs[index];
    Options own = options;
    own.scene.path = job.scene;
    own.scene.frame = job.frame;
    own.output.files = job.files;
    own.output.checkpoint = job.checkpoint;
    own.place = {index + 1, jobs.size(), job.frame};
    if (job.frame) own.scenes = {job.scene};
    return own;
}

std::string jobName(const SceneOptions& scene) {
    return scene.frame && shareScenes(scene) ? fmt::format("frame {} of {}", *scene.frame, scene.path) : scene.path;
}

}  // namespace eikonal
