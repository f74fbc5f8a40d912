#pragma once
// Encodes PNG files in memory.

#include "image/formats/image_formats.h"

namespace eikonal {

/// The content of the file: R, G and B of 8 bits, or 16 for words, marked as sRGB; text attributes become "tEXt" chunks. Throws
/// std::runtime_error with libpng's reason.
std::vector<unsigned char> encodePng(const EncodedImage& image);

}  // namespace eikonal
