#pragma once
// Encodes OpenEXR files in memory, because not all encoders report a full disk.

#include "image/formats/image_formats.h"

namespace eikonal {

/// The content of the file: scanlines of floats of 32 or 16 bits. Values that 16 bits cannot hold are clamped.
/// Throws std::exception with OpenEXR's reason.
std::vector<unsigned char> encodeExr(const EncodedImage& image);

}  // namespace eikonal
