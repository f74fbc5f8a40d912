// Fits three complex indices of refraction to a measured metal.

#include "color/spectrum.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>

namespace eikonal {
namespace {

constexpr int angleCount = 48;
double cosineOf(int angle) { return (angle + 0.5) / angleCount; }

/// Unpolarised Fresnel reflectance from outside at a metal of index eta + i k.
double fresnel(double cosine, double eta, double k) {
    const std::complex<double> index(eta, k);
    const std::complex<double> refracted = std::sqrt(1.0 - (1 - cosine * cosine) / (index * index));
    const std::complex<double> parallel = (index * cosine - refracted) / (index * cosine + refracted);
    const std::complex<double> perpendicular = (cosine - index * refracted) / (cosine + index * refracted);
    return (std::norm(parallel) + std::norm(perpendicular)) / 2;
}

/// Linear sRGB of daylight reflected by the metal at each angle; (1, 1, 1) for a perfect mirror.
std::array<glm::dvec3, angleCount> colorsOfMetal(const DenseCurve& eta, const DenseCurve& k) {
    const DenseCurve& white = whiteSpectrum(ColorSpace::srgb);
    const double normalization = integrateXyz(white).y;
    std::array<glm::dvec3, angleCount> colors;
    for (int angle = 0; angle < angleCount; ++angle) {
        DenseCurve reflected;
        for (int i = 0; i < wavelengthCount; ++i) reflected[i] = white[i] * fresnel(cosineOf(angle), eta[i], k[i]);
        colors[angle] = rgbFromXyz(ColorSpace::srgb) * integrateXyz(reflected) / normalization;
    }
    return colors;
}

using Reflectances = std::array<double, angleCount>;

double sumOfSquares(const Reflectances& target, glm::dvec2 index) {
    double sum = 0;
    for (int angle = 0; angle < angleCount; ++angle) {
        const double difference = fresnel(cosineOf(angle), index.x, index.y) - target[angle];
        sum += difference * difference;
    }
    return sum;
}

/// Levenberg-Marquardt steps in log eta and log k, which keeps both positive.
glm::dvec2 refine(const Reflectances& target, glm::dvec2 index) {
    double damping = 1e-3, error = sumOfSquares(target, index);
    for (int iteration = 0; iteration < 60 && damping < 1e8; ++iteration) {
        glm::dmat2 normal(0);
        glm::dvec2 gradient(0);
        for (int angle = 0; angle < angleCount; ++angle) {
            const double cosine = cosineOf(angle), value = fresnel(cosine, index.x, index.y), step = 1e-5;
            const glm::dvec2 slope((fresnel(cosine, index.x * (1 + step), index.y) - value) / step,
                                   (fresnel(cosine, index.x, index.y * (1 + step)) - value) / step);
            normal += glm::outerProduct(slope, slope);
            gradient += slope * (target[angle] - value);
        }
        for (int i = 0; i < 2; ++i) normal[i][i] += damping * normal[i][i] + 1e-15;
        const glm::dvec2 change = glm::clamp(glm::inverse(normal) * gradient, -1.0, 1.0);
        const glm::dvec2 candidate = glm::clamp(index * glm::exp(change), 1e-4, 1e3);
        const double candidateError = sumOfSquares(target, candidate);
        if (candidateError < error) {
            index = candidate;
            error = candidateError;
            damping /= 10;
        } else {
            damping *= 10;
        }
    }
    return index;
}

/// The best point of a coarse grid, refined.
glm::dvec2 fit(const Reflectances& target) {
    glm::dvec2 best(1, 1);
    for (double eta = 0.02; eta < 20; eta *= 1.6)
        for (double k = 0.02; k < 20; k *= 1.6)
            if (sumOfSquares(target, {eta, k}) < sumOfSquares(target, best)) best = {eta, k};
    return refine(target, best);
}

/// The value of a spectrum that is the same at all wavelengths.
std::optional<double> flatValue(const Spectrum& spectrum) {
    if (spectrum.isFlat()) return spectrum.value();
    const DenseCurve curve = spectrum.dense();
    const auto [least, most] = std::minmax_element(curve.begin(), curve.end());
    return *most - *least <= 1e-12 * *most ? std::optional(*least) : std::nullopt;
}

}  // namespace

ConductorIndices conductorIndices(const Spectrum& eta, const Spectrum& k) {
    /* The fit is accurate to an absolute error, which is not enough for a metal that hardly reflects */
    if (const auto flatEta = flatValue(eta), flatK = flatValue(k); flatEta && flatK) return {glm::dvec3(*flatEta), glm::dvec3(*flatK)};
    const auto colors = colorsOfMetal(eta.dense(), k.dense());
    ConductorIndices result;
    for (int channel = 0; channel < 3; ++channel) {
        Reflectances target;  // a channel of a saturated metal may exceed 1 (gold's red: 1.02), which no surface can reflect
        for (int angle = 0; angle < angleCount; ++angle) target[angle] = std::clamp(colors[angle][channel], 0.0, 1.0);
        const glm::dvec2 index = fit(target);
        result.eta[channel] = index.x;
        result.k[channel] = index.y;
    }
    return result;
}

}  // namespace eikonal
