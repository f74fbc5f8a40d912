#pragma once
// Floats of 16 bits.

namespace eikonal {

/// The largest finite one.
inline constexpr float mostHalf = 65504;

}  // namespace eikonal
