#pragma once
// Reads scenes in the language of pbrt-v4 (https://pbrt.org/fileformat-v4).

#include "diagnostics.h"
#include "scene/scene.h"

#include <string>
#include <string_view>

namespace eikonal {

/// Reads a scene file (gzip-compressed or not) and all that it includes, imports and takes meshes and spectra from; images are
/// only checked to exist. Names of files start at the scene's folder.
/// Throws SceneError: for text that is no pbrt-v4 (it says so of pbrt-v3), or with a list of all that is wrong with the scene and
/// all files that are missing. What is understood but not rendered is named by diagnostics.unsupported, once for each kind.
Scene readPbrt(const std::string& path, Diagnostics& diagnostics);

/// The same from text. `nameForMessages` stands for the file in messages, `folder` is where names of files start.
Scene readPbrtText(std::string_view text, const std::string& nameForMessages, const std::string& folder, Diagnostics& diagnostics);

}  // namespace eikonal
