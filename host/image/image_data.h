#pragma once
// Decoded images.

#include "eikonal/texture.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace eikonal {

/// A decoded image. Row 0 is the top; channels are interleaved: texel (x, y) begins at channels (y width + x).
struct ImageData {
    int width = 0, height = 0;
    int channels = 1;                    ///< 1: grey, 3: R G B, 4: R G B and alpha, not premultiplied
    image_format format = format_float;  ///< format of the values; alpha is stored like the colours, as in pbrt-v4
    std::vector<std::uint8_t> bytes;     ///< srgb8 and linear8
    std::vector<float> floats;           ///< float32: linear sRGB
    std::size_t replaced = 0;            ///< number of values that were not finite: NaN became 0, infinity 65504 (the largest half)

    /// The linear value of a channel; 0 <= x < width, 0 <= y < height.
    float at(int x, int y, int channel) const;
};

}  // namespace eikonal
