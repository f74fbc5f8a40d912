#include "color/dual_color.h"

#include "color/uplift.h"
#include "color/uplift_table.h"

#include <algorithm>
#include <functional>

namespace eikonal {
namespace {

std::array<double, DualColor::bands> inBands(const DenseCurve& curve) {
    std::array<double, DualColor::bands> means{};
    for (size_t i = 0; i < means.size(); ++i) {
        for (size_t k = 0; k < DualColor::bandWidth; ++k) means[i] += curve[i * DualColor::bandWidth + k];
        means[i] /= DualColor::bandWidth;
    }
    return means;
}

std::array<double, DualColor::bands> inBands(const SmoothReflectance& smooth, double scale) {
    std::array<double, DualColor::bands> values{};
    for (size_t i = 0; i < values.size(); ++i)
        values[i] = scale * smooth(shortestWavelength + (static_cast<double>(i) + 0.5) * DualColor::bandWidth - 0.5);
    return values;
}

double largestOf(glm::dvec3 rgb) { return std::max({rgb.x, rgb.y, rgb.z}); }

/// The spectrum of light of luminance 1; zero stays zero.
std::array<double, DualColor::bands> lightInBands(const DenseCurve& curve) {
    const double luminance = integrateXyz(curve).y;
    std::array<double, DualColor::bands> means = inBands(curve);
    for (double& value : means) value /= luminance > 0 ? luminance : 1;
    return means;
}

/// XYZ of light of 1 in each band alone.
const std::array<glm::dvec3, DualColor::bands>& xyzOfBands() {
    static const auto sums = [] {
        std::array<glm::dvec3, DualColor::bands> xyz{};
        for (size_t i = 0; i < xyz.size(); ++i)
            for (size_t k = 0; k < DualColor::bandWidth; ++k) xyz[i] += matchingFunctions()[i * DualColor::bandWidth + k];
        return xyz;
    }();
    return sums;
}

}  // namespace

DualColor DualColor::constant(double value) {
    DualColor result;
    result.spectrum.fill(value);
    result.rgb = glm::dvec3(value);
    return result;
}

DualColor DualColor::emission(const Spectrum& light) {
    DualColor result;
    DenseCurve curve = light.dense();
    if (light.kind() == Spectrum::Kind::rgb) {
        const DenseCurve& white = whiteSpectrum(light.space());
        for (size_t i = 0; i < curve.size(); ++i) curve[i] *= white[i];
        result.spectrum = inBands(curve);
        for (double& value : result.spectrum) value /= integrateXyz(white).y;
    } else {
        result.spectrum = lightInBands(curve);
        for (double& value : result.spectrum) value *= light.factor();
    }
    result.rgb = light.illuminant();
    return result;
}

DualColor DualColor::reflectance(const Spectrum& reflectance) {
    const glm::dvec3 rgb = glm::max(reflectance.color(), 0.0);
    if (reflectance.kind() != Spectrum::Kind::rgb || reflectance.isFlat() || largestOf(rgb) > 1) return coefficient(reflectance);
    DualColor result;
    result.spectrum = inBands(upliftReflectance(rgb, reflectance.space()), 1);
    result.rgb = reflectance.albedo();
    return result;
}

DualColor DualColor::coefficient(const Spectrum& coefficient) {
    DualColor result;
    result.spectrum = inBands(coefficient.dense());
    result.rgb = coefficient.albedo();
    return result;
}

DualColor DualColor::texel(glm::dvec3 rgb, bool isReflectance) {
    rgb = glm::max(rgb, 0.0);
    if (largestOf(rgb) <= 0) return {};
    const double scale = isReflectance && largestOf(rgb) <= 1 ? 1 : 2 * largestOf(rgb);
    DualColor result;
    result.spectrum = inBands(tabulatedReflectance(rgb / scale), scale);
    result.rgb = rgb;
    return result;
}

const DualColor& DualColor::white() {
    static const DualColor color = emission(Spectrum::rgb(glm::dvec3(1)));
    return color;
}

DualColor DualColor::operator*(const DualColor& b) const { return combine(*this, b, std::multiplies<>()); }
DualColor DualColor::operator+(const DualColor& b) const { return combine(*this, b, std::plus<>()); }
DualColor DualColor::operator*(double factor) const {
    return map([=](double value) { return value * factor; });
}

glm::dvec3 DualColor::seen() const {
    glm::dvec3 xyz{0};
    for (size_t i = 0; i < spectrum.size(); ++i) xyz += spectrum[i] * xyzOfBands()[i];
    return rgbFromXyz(ColorSpace::srgb) * xyz;
}

}  // namespace eikonal
