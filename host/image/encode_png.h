#pragma once
// Encodes PNG files in memory.

#include "image/formats/image_formats.h"

namespace eikonal {

/// The content of the file: 8-bit R, G and B, marked as sRGB; text attributes become "tEXt" chunks. Throws std::runtime_error with libpng's
/// reason.
std::vector<unsigned char> encodePng(const EncodedImage& image);

}  // namespace eikonal
