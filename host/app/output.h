#pragma once
// Which files and channels a render writes.

#include "error.h"
#include "image/film_image.h"
#include "scene/scene.h"
#include "app/options.h"

namespace eikonal {

/// The files to write: those of -o, else the file that the scene names, else the scene's name with .exr. A single EXR is accompanied by a
/// PNG, unless a format is asked for. None for a part of an image. Throws a UsageError if --aov asks for channels that none of these files
/// can hold, or if they cannot be encoded so (checkEncoding).
std::vector<std::string> outputFiles(const OutputOptions& options, const Scene& scene);
/// A single EXR is accompanied by a PNG, unless a format is asked for.
std::vector<std::string> imageFiles(std::vector<std::string> files, const ImageEncoding& encoding);
/// The channels to keep: those of --aov, and all of them for a film "gbuffer" if some file can hold them. Warns if none can.
Aovs aovsOf(const OutputOptions& options, const FilmDescription& film, const std::vector<std::string>& files, Diagnostics& diagnostics);
/// Whether to keep a spectrum of each pixel: for a film "spectral", if some file can hold it. Warns if none can.
bool keepsSpectrum(const OutputOptions& options, const FilmDescription& film, const std::vector<std::string>& files,
                   Diagnostics& diagnostics);
/// Throws an Error if a scene was read from this file, once it is packed: `scenes`, or a file that is part of the last one read.
void checkIsNoInput(const std::string& output, const std::vector<std::string>& scenes);
/// Throws a UsageError if an image would overwrite the checkpoint or the messages of the same run.
void checkIsApart(const std::string& output, const Options& options);
/// Drops the channels that are not in `aovs`.
void selectAovs(FilmImage& image, const Aovs& aovs);
/// The name of a channel that is in `aovs` and not in the image; null: none.
const char* missingAov(const FilmImage& image, const Aovs& aovs);

}  // namespace eikonal
