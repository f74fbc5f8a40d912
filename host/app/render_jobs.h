#pragma once
// The renders of one call: each has a scene, or a frame of one, and files of its own.

#include "app/options.h"

#include <optional>
#include <string>
#include <vector>

namespace eikonal {

/// Whether a name of -o is a folder, for files that are called like their scenes: it is one, or ends in a slash.
bool isFolder(const std::string& name);

/// What one render has that others of the call do not.
struct RenderJob {
    std::string named;  ///< its scene, as the command line names it
    std::string scene;  ///< its scene's file
    std::optional<int> frame;
    std::vector<std::string> files;  ///< -o
    std::string checkpoint;          ///< empty: none
};

/// The renders of a call, in their order: each scene, and of each scene its frames. A run of # in the name of a scene, of -o or of the
/// checkpoint is the number of the frame. A name of -o that is a folder, or ends in a slash, becomes that of a file in it, called like the
/// scene, and the frame if several share a scene. Throws a UsageError that says what works: for several renders with one file, one
/// checkpoint or one standard output, for two with one name, and for scenes that do not have the frames.
std::vector<RenderJob> renderJobs(const Options& options);

/// Takes out the frames that have no file of a scene. Returns a line for each scene that lacks some, with all their numbers.
std::vector<std::string> takeMissing(std::vector<RenderJob>& jobs);

/// The options of the call, for job `index`.
Options optionsOf(const Options& options, const std::vector<RenderJob>& jobs, std::size_t index);

/// "scene.pbrt", or "frame 3 of scene.pbrt".
std::string jobName(const SceneOptions& scene);

}  // namespace eikonal
