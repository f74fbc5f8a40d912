#pragma once
// Images as PNG files, in memory.

#include "image/formats/image_formats.h"

namespace eikonal {

/// The content of a file: 8 bits of R, G and B, said to be sRGB; attributes that are texts become "tEXt". Throws std::runtime_error with libpng's reason.
std::vector<unsigned char> encodePng(const EncodedImage& image);

}  // namespace eikonal
