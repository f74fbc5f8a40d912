#pragma once
// The transfer function of sRGB (IEC 61966-2-1), between linear light and stored values.

#include <array>
#include <cmath>
#include <cstddef>

namespace eikonal {

/// Linear light in [0, 1] from a stored value in [0, 1].
inline double linearFromSrgb(double stored) { return stored <= 0.04045 ? stored / 12.92 : std::pow((stored + 0.055) / 1.055, 2.4); }

/// The linear value of each of the 256 levels of an 8-bit channel.
inline const std::array<float, 256>& linearFromSrgbByte() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> values{};
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(linearFromSrgb(static_cast<double>(i) / 255));
        return values;
    }();
    return table;
}

/// The stored value in [0, 1] from linear light in [0, 1].
inline double srgbFromLinear(double linear) { return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055; }

}  // namespace eikonal
