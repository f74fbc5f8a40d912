#pragma once
// How a scene's colours are rendered.

#include <string>

namespace eikonal {

struct ColorChoice {
    bool spectral = false;   ///< at wavelengths, not in RGB
    std::string why;         ///< what decides, with its location if it has one
};

/// As for --color.
inline const char* nameOf(const ColorChoice& color) { return color.spectral ? "spectral" : "rgb"; }

}  // namespace eikonal
