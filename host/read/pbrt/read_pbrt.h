#pragma once
// Reads scenes in the pbrt-v4 format (https://pbrt.org/fileformat-v4).

#include "diagnostics.h"
#include "read/formats/loose_files.h"
#include "scene/scene.h"

#include <string>
#include <string_view>

namespace eikonal {

/// Reads a scene file, possibly gzip-compressed, and all files that it includes or imports, with their meshes and spectra; images are only
/// checked to exist. File names are relative to the scene's folder. Throws SceneError for text that is not pbrt-v4 (the message recognises
/// pbrt-v3), or with a list of all problems and missing files. Features that are read but not rendered are reported by
/// diagnostics.unsupported, once per kind.
Scene readPbrt(const std::string& path, Diagnostics& diagnostics, MissingFiles missing = MissingFiles::error);

/// The same for standard input, which is called <stdin> in messages; file names are relative to the current folder. The scene's name is
/// "stdin". Throws an Error if it is a terminal, which would wait without a word.
Scene readPbrtInput(Diagnostics& diagnostics, MissingFiles missing = MissingFiles::error);

/// The same for a text. `nameForMessages` is the file name in messages; file names are relative to `folder`.
Scene readPbrtText(std::string_view text, const std::string& nameForMessages, const std::string& folder, Diagnostics& diagnostics,
                   MissingFiles missing = MissingFiles::error);

}  // namespace eikonal
