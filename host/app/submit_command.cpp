#include "app/commands.h"
#include "app/farm/job.h"
#include "app/output.h"
#include "app/render_jobs.h"
#include "image/atomic_file.h"
#include "image/image_file.h"
#include "pack/camera.h"
#include "printable.h"
#include "render/scene_loading.h"
#include "shell_word.h"

#include <fmt/format.h>

#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace fs = std::filesystem;

namespace eikonal {
namespace {

/// Whether the shell would find a program.
bool isInstalled(const std::string& command) {
    const char* folders = std::getenv("PATH");
    std::istringstream path(folders ? folders : "");
    for (std::string folder; std::getline(path, folder, ':');)
        if (::access((fs::path(folder) / command).c_str(), X_OK) == 0) return true;
    return false;
}

std::string thisProgram() { return fs::read_symlink("/proc/self/exe").string(); }

std::string absolute(const std::string& path) { return fs::absolute(path).lexically_normal().string(); }

/// What images and animations have in common.
FarmJob jobOf(const Options& o, const std::string& name) {
    FarmJob job;
    job.name = name;
    job.program = o.submit.engine->program ? o.submit.engine->program : thisProgram();
    job.scene = absolute(o.scene.path);
    job.folder = absolute(o.submit.folder.empty() ? name + "-" + o.submit.engine->name : o.submit.folder);
    job.renderOptions = o.passedOn;
    job.imageOptions = o.passedToMerge;
    return job;
}

/// Reads the scene of the first frame, and checks that all have one, and that its images can be written.
FarmJob jobOfFrames(const Options& o, Diagnostics& diagnostics) {
    Options all = o;
    all.scenes = {o.scene.path};
    std::vector<RenderJob> frames = renderJobs(all);
    if (const std::vector<std::string> missing = takeMissing(frames); !missing.empty())
        throw Error(ExitCode::scene, missing.front());
    const Options first = optionsOf(all, frames, 0);
    for (const std::string& file : first.output.files) checkWritable(file, 0, o.output.encoding);
    FarmJob job = jobOf(o, loadScene(first.scene, diagnostics).name);
    job.renderOptions.insert(job.renderOptions.end(), o.passedToFrames.begin(), o.passedToFrames.end());
    for (const std::string& file : o.output.files) job.images.push_back(absolute(file));
    job.frames = o.frames;
    std::ranges::sort(job.frames);
    job.framesPerTask = o.submit.framesPerTask;
    return job;
}

/// Reads the scene, so that it is not a thousand nodes that find its errors, and checks that the image has as many parts.
FarmJob jobOfParts(const Options& o, Diagnostics& diagnostics) {
    const Scene scene = loadScene(o.scene, diagnostics);
    const int rows = renderedPixels(scene.film, diagnostics).height();
    const auto leaves = static_cast<int>(leavesOf(static_cast<unsigned>(scene.sampler.pixelSamples)));
    if (o.submit.tiles > rows)
        throw UsageError(fmt::format("--tiles: the image has {} rows, so it can have as many tiles, not {}", rows, o.submit.tiles));
    if (o.submit.sampleRanges > leaves)
        throw UsageError(
            fmt::format("--sample-ranges: a pixel has {} samples, {} in a range at least, so they make at most {} ranges, not {}",
                        scene.sampler.pixelSamples, leafSamples, leaves, o.submit.sampleRanges));
    FarmJob job = jobOf(o, scene.name);
    if (o.output.hasImage) job.images.push_back(absolute(outputFiles(o.output, scene).front()));
    for (size_t i = 1; i < o.output.files.size(); ++i) job.images.push_back(absolute(o.output.files[i]));
    if (!o.output.checkpoint.empty()) job.images.push_back(absolute(o.output.checkpoint));
    job.tiles = o.submit.tiles;
    job.sampleRanges = o.submit.sampleRanges;
    return job;
}

/// "6 parts, 3 tiles x 2 ranges of samples", or "48 frames, in 12 tasks".
std::string describe(const FarmJob& job) {
    const auto counted = [](long n, const char* what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); };
    if (!job.frames.empty()) return fmt::format("{}, in {}", counted(std::ssize(job.frames), "frame"), counted(taskCount(job), "task"));
    return fmt::format("{}, {} x {} of samples", counted(taskCount(job), "part"), counted(job.tiles, "tile"),
                       counted(job.sampleRanges, "range"));
}

/// Throws an Error if the folder holds another job, whose parts may wait for these files.
void checkIsFree(const fs::path& folder, const std::vector<JobFile>& files) {
    for (const JobFile& file : files) {
        std::ifstream old(folder / file.name, std::ios::binary);
        if (old && std::string(std::istreambuf_iterator<char>(old), {}) != file.text)
            throw Error(ExitCode::scene, fmt::format("{}: is of another job, which may still need it; --folder names another folder",
                                                     (folder / file.name).string()));
    }
}

void writeFiles(const fs::path& folder, const std::vector<JobFile>& files) {
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure) throw Error(ExitCode::scene, fmt::format("cannot make the folder \"{}\": {}", folder.string(), failure.message()));
    for (const JobFile& file : files) {
        writeTextAtomically((folder / file.name).string(), file.text);
        if (file.name == submitScript) fs::permissions(folder / file.name, fs::perms::owner_exec, fs::perm_options::add, failure);
    }
}

/// Becomes the script that hands a job over.
[[noreturn]] void handOver(const std::string& script) {
    std::fflush(stdout);
    for (const int number : {SIGPIPE, SIGXFSZ}) std::signal(number, SIG_DFL);
    ::execlp("bash", "bash", script.c_str(), nullptr);
    throw Error(ExitCode::scene, fmt::format("cannot run bash: {}", std::strerror(errno)));
}

}  // namespace

int submitCommand(const Options& o) {
    Diagnostics diagnostics(o.log, o.scene.strict);
    const FarmEngine& engine = *o.submit.engine;
    if (!o.submit.isDryRun && !isInstalled(engine.command))
        throw Error(ExitCode::scene,
                    fmt::format("error: {} is not installed here, which hands jobs over to {}. It is in {}; or add --dry-run, "
                                "which writes the job's folder for a machine that has it",
                                engine.command, engine.name, engine.install));
    const FarmJob job = o.frames.empty() ? jobOfParts(o, diagnostics) : jobOfFrames(o, diagnostics);
    const std::vector<JobFile> files = filesOf(job, engine);
    checkIsFree(job.folder, files);
    writeFiles(job.folder, files);
    const std::string script = (fs::path(job.folder) / submitScript).string();
    std::string names;
    for (const JobFile& file : files) names += (names.empty() ? "" : ", ") + file.name;
    std::fputs(printable(fmt::format("{}: {}\n  {}\n", describe(job), job.folder, names)).c_str(), stdout);
    if (!o.submit.isDryRun) handOver(script);
    std::fputs(printable(fmt::format("nothing is handed over (--dry-run). This does it:\n  {}\n", shellWord(script))).c_str(), stdout);
    return static_cast<int>(ExitCode::success);
}

}  // namespace eikonal
