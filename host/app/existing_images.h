#pragma once
// Images that an earlier call has left.

#include "app/options.h"

#include <string>
#include <vector>

namespace eikonal {

/// The image files of a render that is to leave out what is there already: those of -o, and the PNG beside an EXR.
std::vector<std::string> filesToLookFor(const OutputOptions& options);

/// Why a file is no whole image as these options ask for: it is damaged, has another size than --resolution, fewer samples than --spp, or
/// says that its render was ended early, which EXR and PNG files do. Empty: it is one.
std::string whyNotWhole(const std::string& file, const Options& options);

/// Whether all image files of the render are there and whole. Says which is not, though it is there.
bool hasWholeImages(const Options& options);

}  // namespace eikonal
