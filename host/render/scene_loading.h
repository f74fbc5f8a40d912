#pragma once
// Loads a scene file and applies the options that override it.

#include "render/options.h"

namespace eikonal {

/// Whether a file is a Wavefront OBJ, by its name.
bool isObj(const std::string& path);

/// Reads a pbrt-v4 scene or an OBJ, chosen by the file's extension ("-": pbrt-v4 from standard input), and applies the options. Throws
/// what the readers throw, and a UsageError for options that do not apply to the kind of file.
Scene loadScene(const SceneOptions& options, Diagnostics& diagnostics);

}  // namespace eikonal
