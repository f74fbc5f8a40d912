#pragma once
// From a file and the options that replace parts of it to a scene.

#include "app/options.h"

namespace eikonal {

/// Reads a pbrt-v4 scene or an OBJ, told apart by the file's name, and applies the options. Throws as the readers do, and a
/// UsageError for options that do not fit the kind of file.
Scene loadScene(const SceneOptions& options, Diagnostics& diagnostics);

}  // namespace eikonal
