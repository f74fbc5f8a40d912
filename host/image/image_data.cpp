#include "image/image_data.h"

#include "color/transfer.h"

namespace eikonal {

float ImageData::at(int x, int y, int channel) const {
    const std::size_t i = (static_cast<std::size_t>(y) * width + x) * channels + channel;
    if (format == format_float) return floats[i];
    return format == format_srgb8 ? linearFromSrgbByte()[bytes[i]] : bytes[i] / 255.f;
}

}  // namespace eikonal
