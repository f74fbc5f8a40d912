#include "image/tone_map.h"

#include "error.h"
#include "color/luminance.h"
#include "color/transfer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace eikonal {
namespace {

constexpr std::array<std::pair<const char*, ToneCurve>, 3> curves{
    {{"clamp", ToneCurve::clamp}, {"reinhard", ToneCurve::reinhard}, {"filmic", ToneCurve::filmic}}};

glm::dvec3 bend(glm::dvec3 x, ToneCurve curve) {
    switch (curve) {
        case ToneCurve::clamp: return x;
        case ToneCurve::reinhard: return x / (1 + std::max(0., luminance(x)));
        case ToneCurve::filmic: return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
    }
    return x;
}

}  // namespace

glm::vec3 toneMap(glm::vec3 linear, const ToneMapping& mapping) {
    // Larger values change nothing, and the squares in the filmic curve stay finite.
    glm::dvec3 x(0);
    for (int c = 0; c < 3; ++c)
        if (!std::isnan(linear[c])) x[c] = std::clamp(linear[c] * std::exp2(mapping.exposure), 0., 1e18);
    x = bend(x, mapping.curve);
    glm::vec3 stored;
    for (int c = 0; c < 3; ++c) stored[c] = static_cast<float>(srgbFromLinear(std::clamp(x[c], 0., 1.)));
    return stored;
}

std::vector<std::string> toneCurveNames() {
    std::vector<std::string> names;
    for (const auto& [name, curve] : curves) names.push_back(name);
    return names;
}

ToneCurve toneCurve(const std::string& name) {
    for (const auto& [known, curve] : curves)
        if (name == known) return curve;
    throw UsageError(fmt::format("unknown tone curve \"{}\"; known: {}", name, fmt::join(toneCurveNames(), " ")));
}

}  // namespace eikonal
