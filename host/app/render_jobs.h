#pragma once
// The renders of one call: each has a scene and files of its own.

#include "app/options.h"

#include <vector>

namespace eikonal {

/// Whether a name of -o is a folder, for files that are called like their scenes: it is one, or ends in a slash.
bool isFolder(const std::string& name);

/// The options of each render, in the order of the scenes. A name of -o that is a folder, or ends in a slash, becomes that of a file in it,
/// called like the scene. Throws a UsageError that says what works: for several scenes with one file, one checkpoint or one standard
/// output, and for two scenes with one name in one folder.
std::vector<Options> renderJobs(const Options& options);

}  // namespace eikonal
