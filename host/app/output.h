#pragma once
// The files that a render leaves.

#include "image/image_file.h"
#include "app/options.h"

namespace eikonal {

/// The files to write: those of -o, else the one that the scene names, else the scene's name with .exr. A single EXR gets a PNG beside it.
/// Throws a UsageError if channels are asked for that none of these files can hold.
std::vector<std::string> outputFiles(const OutputOptions& options, const Scene& scene);
/// The channels that are kept: those of --aov and, if some file can hold them, all if the scene's film is a "gbuffer"; a warning if none can.
Aovs aovsOf(const OutputOptions& options, const FilmDescription& film, const std::vector<std::string>& files, Diagnostics& diagnostics);
/// Whether a spectrum of each pixel is kept: if the scene's film is a "spectral" and some file can hold it; a warning if none can.
bool keepsSpectrum(const FilmDescription& film, const std::vector<std::string>& files, Diagnostics& diagnostics);
/// Drops the channels that nobody asked for.
void selectAovs(FilmImage& image, const Aovs& aovs);

}  // namespace eikonal
