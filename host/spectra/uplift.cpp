#include "spectra/uplift.h"

#include <algorithm>
#include <cmath>

namespace eikonal {
namespace {

double sigmoid(double x) { return 0.5 + x / (2 * std::sqrt(1 + x * x)); }
double sigmoidInverse(double s) { return (s - 0.5) / std::sqrt(s * (1 - s)); }

/// What each nm of a reflectance adds to its colour under the white light of the space.
std::array<glm::dvec3, wavelengthCount> colorWeights(ColorSpace space) {
    const DenseCurve& white = whiteSpectrum(space);
    const double normalization = integrateXyz(white).y;
    std::array<glm::dvec3, wavelengthCount> weights;
    for (int i = 0; i < wavelengthCount; ++i) weights[i] = rgbFromXyz(space) * matchingFunctions()[i] * white[i] / normalization;
    return weights;
}

/// The colour of a curve, and how it changes with the curve's coefficients (columns).
struct Linearization { glm::dvec3 color{0}; glm::dmat3 slope{0}; };

Linearization linearize(const std::array<glm::dvec3, wavelengthCount>& weights, glm::dvec3 c) {
    Linearization result;
    for (int i = 0; i < wavelengthCount; ++i) {
        const double t = static_cast<double>(i) / (wavelengthCount - 1);
        const double x = (c.x * t + c.y) * t + c.z;
        result.color += weights[i] * sigmoid(x);
        const glm::dvec3 change = weights[i] * (0.5 / std::pow(1 + x * x, 1.5));
        result.slope += glm::dmat3(change * (t * t), change * t, change);
    }
    return result;
}

/// Levenberg-Marquardt steps from c towards the colour `target`.
glm::dvec3 approach(const std::array<glm::dvec3, wavelengthCount>& weights, glm::dvec3 target, glm::dvec3 c) {
    double damping = 1e-6;
    Linearization now = linearize(weights, c);
    for (int iteration = 0; iteration < 30; ++iteration) {
        const glm::dvec3 residual = target - now.color;
        if (glm::dot(residual, residual) < 1e-16) break;
        const glm::dmat3 transposed = glm::transpose(now.slope);
        glm::dmat3 normal = transposed * now.slope;
        for (int k = 0; k < 3; ++k) normal[k][k] *= 1 + damping;
        const glm::dvec3 candidate = c + glm::inverse(normal) * (transposed * residual);
        const Linearization next = linearize(weights, candidate);
        const glm::dvec3 nextResidual = target - next.color;
        if (glm::dot(nextResidual, nextResidual) < glm::dot(residual, residual)) {
            c = candidate;
            now = next;
            damping = std::max(damping / 10, 1e-12);
        } else if ((damping *= 10) > 1e8) {
            break;
        }
    }
    return c;
}

}  // namespace

double SmoothReflectance::operator()(double wavelength) const {
    const double t = (wavelength - shortestWavelength) / (wavelengthCount - 1);
    return sigmoid((c.x * t + c.y) * t + c.z);
}

SmoothReflectance upliftReflectance(glm::dvec3 rgb, ColorSpace space) {
    const glm::dvec3 target = glm::clamp(rgb, 1e-4, 1 - 1e-4);
    const double grey = (target.x + target.y + target.z) / 3;
    glm::dvec3 c(0, 0, sigmoidInverse(grey));
    if (target == glm::dvec3(grey)) return {c};

    // Walk from grey to the colour, so that each solution starts near the next.
    const auto weights = colorWeights(space);
    constexpr int steps = 8;
    for (int step = 1; step <= steps; ++step) c = approach(weights, glm::mix(glm::dvec3(grey), target, double(step) / steps), c);
    return {c};
}

}  // namespace eikonal
