#pragma once
// An image that a render farm makes in parts, or an animation, as the files that the farm's engine takes.

#include <string>
#include <vector>

namespace eikonal {

/// What to render and where: an image in parts, or the frames of an animation. Paths are absolute, and the same on all nodes.
struct FarmJob {
    std::string name;                        ///< of the scene
    std::string program;                     ///< eikonal, on the nodes
    std::string scene, folder;               ///< folder: of the job's files and of its parts
    std::vector<std::string> images;         ///< at least one
    std::vector<std::string> renderOptions;  ///< of each part, "--name=value"
    std::vector<std::string> imageOptions;   ///< of the merge, but for its files
    int tiles = 1, sampleRanges = 1;
    std::vector<int> frames;                 ///< ascending; empty: one image, in parts
    int framesPerTask = 1;
};

/// What runs at the same time, each as a task: the parts of an image, or some frames each ("1-4", "5,8,9", "12").
std::vector<std::string> frameTasks(const FarmJob& job);
long taskCount(const FarmJob& job);

struct JobFile {
    std::string name, text;
};

/// What runs jobs on many machines. A job's files are the engine's files of farm/, word for word, and its settings, which they read.
struct FarmEngine {
    const char* name;     ///< of --engine, and of its folder in farm/
    const char* command;  ///< that takes a job
    const char* install;  ///< how to get that
    const char* program;  ///< eikonal on its nodes; null: this program
    std::vector<JobFile> (*settings)(const FarmJob& job);
};

/// All engines.
const std::vector<FarmEngine>& farmEngines();

/// The files of a job's folder; one of them is submit.sh, which hands it over. Throws an Error if the engine cannot run it.
std::vector<JobFile> filesOf(const FarmJob& job, const FarmEngine& engine);
inline constexpr const char* submitScript = "submit.sh";

}  // namespace eikonal
