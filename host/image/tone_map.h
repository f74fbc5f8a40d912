#pragma once
// Tone mapping from linear light to display values.

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace eikonal {

enum class ToneCurve {
    clamp,     ///< values above 1 become 1, as image viewers do
    reinhard,  ///< x / (1 + x) of the luminance, hue kept: Reinhard et al. 2002, equation 3
    filmic     ///< a film-like shoulder and toe: the fit of ACES by Narkowicz 2016
};

/// Tone mapping of 8-bit images: multiply by 2^exposure, apply the curve, clamp to [0, 1], encode as sRGB.
struct ToneMapping {
    ToneCurve curve = ToneCurve::clamp;
    double exposure = 0;  ///< stops: 1 is twice as bright
};

/// The stored value in [0, 1] of each channel. NaN becomes 0.
glm::vec3 toneMap(glm::vec3 linear, const ToneMapping& mapping);

/// The curve called `name`. Throws UsageError that lists the names.
ToneCurve toneCurve(const std::string& name);
std::vector<std::string> toneCurveNames();

}  // namespace eikonal
