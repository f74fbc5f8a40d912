#pragma once
// Chromaticities: CIE x and y of red, green, blue and white of an image file, in this order (EXR's "chromaticities").

#include <glm/glm.hpp>

#include <array>
#include <cmath>
#include <optional>

namespace eikonal {

using Primaries = std::array<float, 8>;

constexpr Primaries srgbPrimaries{0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f};

/// CIE XYZ from linear RGB; white has Y = 1.
inline glm::dmat3 xyzFromRgb(const Primaries& c) {
    const auto xyz = [&](int i) { return glm::dvec3(c[2 * i], c[2 * i + 1], 1 - c[2 * i] - c[2 * i + 1]) / double(c[2 * i + 1]); };
    const glm::dmat3 primaries(xyz(0), xyz(1), xyz(2));
    const glm::dvec3 scale = glm::inverse(primaries) * xyz(3);
    return {primaries[0] * scale.x, primaries[1] * scale.y, primaries[2] * scale.z};
}

/// Linear sRGB from linear RGB with these primaries; nothing if they are those of sRGB. Not finite for degenerate primaries.
inline std::optional<glm::dmat3> srgbFromPrimaries(const Primaries& primaries) {
    bool same = true;
    for (std::size_t i = 0; i < primaries.size(); ++i) same = same && std::abs(primaries[i] - srgbPrimaries[i]) < 1e-3f;
    if (same) return {};
    return glm::inverse(xyzFromRgb(srgbPrimaries)) * xyzFromRgb(primaries);
}

}  // namespace eikonal
