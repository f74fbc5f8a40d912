#include "pack/medium_colors.h"

#include "color/diffuse_albedo.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace eikonal {
namespace {

/// Of the values above 0; 1 if there is none.
double meanDensity(std::span<const float> values) {
    double sum = 0, count = 0;
    for (const float value : values)
        if (value > 0) {
            sum += value;
            ++count;
        }
    return count > 0 ? sum / count : 1;
}

double densityOf(const Medium& m) {
    if (m.sparseDensity) return meanDensity(m.sparseDensity->values);
    return meanDensity(m.density.values);
}

/// Up to 32 voxels, spread over the grid, that are not empty.
std::vector<MediumColor> colorsOfGrid(const Medium& m, const DualColor& scaleA, const DualColor& scaleS) {
    const ColorGrid& grid = m.colors;
    const auto colorAt = [&](const std::vector<glm::vec3>& colors, size_t i) {
        return colors.empty() ? DualColor::constant(1) : DualColor::coefficient(Spectrum::rgb(glm::dvec3(colors[i]), grid.space));
    };
    std::vector<size_t> filled;
    for (size_t i = 0; i < std::max(grid.sigmaA.size(), grid.sigmaS.size()); ++i)
        if ((!grid.sigmaA.empty() && grid.sigmaA[i] != glm::vec3(0)) || (!grid.sigmaS.empty() && grid.sigmaS[i] != glm::vec3(0)))
            filled.push_back(i);
    std::vector<MediumColor> parts;
    constexpr size_t most = 32;
    const size_t count = std::min(filled.size(), most);
    for (size_t k = 0; k < count; ++k) {
        const size_t i = filled[k * filled.size() / count];
        parts.push_back({scaleA * colorAt(grid.sigmaA, i), scaleS * colorAt(grid.sigmaS, i), m.g});
    }
    return parts;
}

}  // namespace

DualColor MediumColor::seen(const DualColor& background, double length) const {
    const DualColor sigmaT = sigmaA + sigmaS;
    const DualColor transmittance = sigmaT.map([=](double sigma) { return std::exp(-std::max(sigma, 0.0) * length); });
    const DualColor albedo = DualColor::combine(sigmaS, sigmaT, [](double s, double t) { return t > 0 ? s / t : 0; });
    const DualColor scattered =
        DualColor::combine(albedo, transmittance, [&](double rho, double T) { return halfSpaceAlbedo(rho, g) * (1 - T); });
    return background * transmittance + scattered;
}

std::vector<MediumColor> colorsOf(const Medium& m) {
    const DualColor sigmaA = DualColor::coefficient(m.sigmaA), sigmaS = DualColor::coefficient(m.sigmaS);
    if (!m.colors.sigmaA.empty() || !m.colors.sigmaS.empty()) return colorsOfGrid(m, sigmaA, sigmaS);
    const double density = densityOf(m);
    return {{sigmaA * density, sigmaS * density, m.g}};
}

}  // namespace eikonal
