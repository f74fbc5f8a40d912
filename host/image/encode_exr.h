#pragma once
// Images as OpenEXR files, in memory: not every encoder notices that a disk is full.

#include "image/formats/image_formats.h"

namespace eikonal {

/// The content of a file: scanlines of 32-bit floats, compressed by zip. Throws std::exception with OpenEXR's reason.
std::vector<unsigned char> encodeExr(const EncodedImage& image);

}  // namespace eikonal
