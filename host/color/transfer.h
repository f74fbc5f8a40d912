#pragma once
// The transfer function of sRGB (IEC 61966-2-1), between linear light and stored values.

#include <cmath>

namespace eikonal {

/// Linear light in [0, 1] from a stored value in [0, 1].
inline double linearFromSrgb(double stored) { return stored <= 0.04045 ? stored / 12.92 : std::pow((stored + 0.055) / 1.055, 2.4); }

/// The stored value in [0, 1] from linear light in [0, 1].
inline double srgbFromLinear(double linear) { return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055; }

}  // namespace eikonal
