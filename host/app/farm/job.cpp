#include "app/farm/job.h"

#include "app/frame_numbers.h"
#include "error.h"
#include "json_text.h"
#include "shell_word.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string_view>

namespace eikonal {
namespace {

namespace fs = std::filesystem;

/// The files of farm/, by their paths there.
constexpr struct {
    const char *name, *text;
} templates[] = {
#include "farm_files.inc"
};

/// "-o FILE" for each file.
std::vector<std::string> outputWords(const std::vector<std::string>& files) {
    std::vector<std::string> words;
    for (const std::string& file : files) words.insert(words.end(), {"-o", file});
    return words;
}

/// What the scripts of Slurm and Kubernetes read.
JobFile environmentOf(const FarmJob& job) {
    std::vector<std::string> image = outputWords(job.images);
    image.insert(image.end(), job.imageOptions.begin(), job.imageOptions.end());
    return {"job.env", fmt::format("# The job, for the scripts beside this file; in the quoting of bash.\n"
                                   "EIKONAL={}\nSCENE={}\nRENDER_OPTIONS=({})\nIMAGE_OPTIONS=({})\n"
                                   "TILES={}\nRANGES={}\nFRAMES=({})\n",
                                   shellWord(job.program), shellWord(job.scene), shellWords(job.renderOptions), shellWords(image),
                                   job.tiles, job.sampleRanges, shellWords(frameTasks(job)))};
}

std::vector<JobFile> slurmSettings(const FarmJob& job) { return {environmentOf(job)}; }

/// The frames as Open Job Description writes them, "1-3,7".
std::string frameExpression(const std::vector<int>& frames) {
    std::string text = frameRanges(frames);
    std::erase(text, ' ');
    return text;
}

/// The parameters of farm/openjd/frames.yaml.
std::vector<JobFile> openjdAnimation(const FarmJob& job) {
    constexpr size_t longest = 1024;   // of a parameter
    const std::string frames = frameExpression(job.frames);
    if (frames.size() > longest)
        throw Error(ExitCode::scene,
                    fmt::format("error: openjd takes lists of frames of {} characters, and this one has {}; submit some of them at a time",
                                longest, frames.size()));
    std::vector<std::string> options = job.renderOptions, image = outputWords(job.images);
    options.insert(options.end(), image.begin(), image.end());
    options.insert(options.end(), job.imageOptions.begin(), job.imageOptions.end());
    const nlohmann::ordered_json parameters{{"Name", job.name},
                                            {"Scene", job.scene},
                                            {"Options", shellWords(options)},
                                            {"Frames", frames},
                                            {"FramesPerTask", job.framesPerTask},
                                            {"Parts", (fs::path(job.folder) / "parts").string()},
                                            {"Eikonal", job.program}};
    return {{"animation.json", jsonText(parameters, 2) + "\n"}};
}

/// The parameters of farm/openjd/eikonal.yaml.
std::vector<JobFile> openjdSettings(const FarmJob& job) {
    if (!job.frames.empty()) return openjdAnimation(job);
    std::vector<std::string> image = outputWords({std::next(job.images.begin()), job.images.end()});
    image.insert(image.end(), job.imageOptions.begin(), job.imageOptions.end());
    const nlohmann::ordered_json parameters{{"Name", job.name},
                                            {"Scene", job.scene},
                                            {"Image", job.images.front()},
                                            {"Parts", (fs::path(job.folder) / "parts").string()},
                                            {"RenderOptions", shellWords(job.renderOptions)},
                                            {"ImageOptions", shellWords(image)},
                                            {"Tiles", job.tiles},
                                            {"SampleRanges", job.sampleRanges},
                                            {"Eikonal", job.program}};
    return {{"parameters.json", jsonText(parameters, 2) + "\n"}};
}

/// The deepest folder that all files lie in.
fs::path commonFolder(const std::vector<std::string>& files) {
    fs::path common = fs::path(files.front()).parent_path();
    for (const std::string& file : files) {
        const fs::path folder = fs::path(file).parent_path();
        const auto [end, other] = std::mismatch(common.begin(), common.end(), folder.begin(), folder.end());
        fs::path shared;
        for (auto part = common.begin(); part != end; ++part) shared /= *part;
        common = shared;
    }
    return common;
}

/// A name that Kubernetes takes: small letters, digits and dashes.
std::string asLabel(const std::string& name) {
    std::string label;
    for (const char c : name.substr(0, 40)) {
        const auto letter = static_cast<unsigned char>(c);
        if (std::isalnum(letter)) label += static_cast<char>(std::tolower(letter));
        else if (!label.empty() && label.back() != '-') label += '-';
    }
    while (!label.empty() && label.back() == '-') label.pop_back();
    return label.empty() ? "eikonal" : label;
}

/// What kustomize fills into farm/kubernetes/job.yaml.
std::vector<JobFile> kubernetesSettings(const FarmJob& job) {
    std::vector<std::string> files{job.scene, (fs::path(job.folder) / "job.env").string()};
    files.insert(files.end(), job.images.begin(), job.images.end());
    const std::string shared = commonFolder(files).string();
    if (shared == "/")
        throw Error(ExitCode::scene, fmt::format("the pods see one shared folder, and {} have none in common but /; keep them in one, with "
                                                 "--folder and -o",
                                                 fmt::join(files, ", ")));
    const auto replace = [](const char* path, const std::string& value) {
        return fmt::format("      - {{op: replace, path: {}, value: {}}}\n", path, value);
    };
    const std::string parts = std::to_string(taskCount(job));
    const auto text = [](const std::string& value) { return jsonText(nlohmann::json(value)); };
    return {
        environmentOf(job),
        {"kustomization.yaml",
         fmt::format("apiVersion: kustomize.config.k8s.io/v1beta1\nkind: Kustomization\nresources: [job.yaml]\nnamePrefix: {}-\n"
                     "images:\n  - {{name: eikonal, newName: eikonal, newTag: \"{}\"}}\npatches:\n  - target: {{kind: Job, name: parts}}\n"
                     "    patch: |\n{}{}  - target: {{kind: Job}}\n    patch: |\n{}{}",
                     asLabel(job.name), EIKONAL_VERSION, replace("/spec/completions", parts), replace("/spec/parallelism", parts),
                     replace("/spec/template/spec/containers/0/env/0/value", text(job.folder)),
                     replace("/spec/template/spec/containers/0/volumeMounts/0/mountPath", text(shared)))}};
}

}  // namespace

std::vector<std::string> frameTasks(const FarmJob& job) {
    std::vector<std::string> tasks;
    const auto perTask = static_cast<size_t>(job.framesPerTask);
    for (size_t first = 0; first < job.frames.size(); first += perTask) {
        const auto begin = job.frames.begin() + static_cast<std::ptrdiff_t>(first);
        tasks.push_back(frameExpression({begin, begin + static_cast<std::ptrdiff_t>(std::min(perTask, job.frames.size() - first))}));
    }
    return tasks;
}

long taskCount(const FarmJob& job) {
    return job.frames.empty() ? static_cast<long>(job.tiles) * job.sampleRanges : static_cast<long>(frameTasks(job).size());
}

const std::vector<FarmEngine>& farmEngines() {
    static const std::vector<FarmEngine> engines{
        {"slurm", "sbatch", "Debian's package slurm-client", nullptr, slurmSettings},
        {"openjd", "openjd", "the Python package openjd-cli, with `pipx install openjd-cli`", nullptr, openjdSettings},
        {"kubernetes", "kubectl", "kubectl of kubernetes.io", "eikonal", kubernetesSettings}};
    return engines;
}

std::vector<JobFile> filesOf(const FarmJob& job, const FarmEngine& engine) {
    std::vector<JobFile> files = engine.settings(job);
    const std::string folder = std::string(engine.name) + "/";
    for (const auto& [name, text] : templates)
        if (std::string_view(name).starts_with(folder)) files.push_back({name + folder.size(), text});
    return files;
}

}  // namespace eikonal
