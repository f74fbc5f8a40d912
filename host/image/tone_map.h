#pragma once
// From linear light to what a screen shows.

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace eikonal {

enum class ToneCurve {
    clamp,     ///< values above 1 become 1, as image viewers do
    reinhard,  ///< x / (1 + x) of the luminance, hue kept: Reinhard et al. 2002, equation 3
    filmic     ///< a film-like shoulder and toe: the fit of ACES by Narkowicz 2016
};

/// How 8-bit images are made: multiplied by 2^exposure, bent by the curve, clamped to [0, 1], encoded as sRGB.
struct ToneMapping {
    ToneCurve curve = ToneCurve::clamp;
    double exposure = 0;  ///< stops: 1 is twice as bright
};

/// The stored value in [0, 1] of each channel. Values that are not numbers become 0.
glm::vec3 toneMap(glm::vec3 linear, const ToneMapping& mapping);

/// The curve of that name, for --tonemap. Throws UsageError with the names there are.
ToneCurve toneCurve(const std::string& name);
std::vector<std::string> toneCurveNames();

}  // namespace eikonal
