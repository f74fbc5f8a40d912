#pragma once
// What is sent to a program that shows images: tev's protocol, as pbrt-v4 speaks it. A packet begins with its length in bytes, itself
// included; numbers are little-endian, texts end with a zero byte.

#include "scene/film.h"

#include <span>
#include <string>
#include <vector>

namespace eikonal {

using DisplayPacket = std::vector<unsigned char>;

/// Asks for a black image, in front of others. An image of that name is replaced.
DisplayPacket createImagePacket(const std::string& name, int width, int height, std::span<const std::string> channels);
/// Replaces a channel of the pixels in `tile`, whose values are given row by row.
DisplayPacket updateImagePacket(const std::string& name, const std::string& channel, const PixelBounds& tile,
                                std::span<const float> values);

}  // namespace eikonal
