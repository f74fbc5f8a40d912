#include "image/image_data.h"

#include "color/transfer.h"

#include <array>

namespace eikonal {

static const std::array<float, 256>& linearFromSrgbByte() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> values{};
        for (int i = 0; i < 256; ++i) values[i] = static_cast<float>(linearFromSrgb(i / 255.));
        return values;
    }();
    return table;
}

float ImageData::at(int x, int y, int channel) const {
    const std::size_t i = (static_cast<std::size_t>(y) * width + x) * channels + channel;
    if (format == format_float) return floats[i];
    return format == format_srgb8 ? linearFromSrgbByte()[bytes[i]] : bytes[i] / 255.f;
}

}  // namespace eikonal
