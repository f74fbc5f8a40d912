#include "color/uplift.h"

#include "eikonal/scene.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace eikonal {
namespace {

double sigmoid(double x) { return 0.5 + x / (2 * std::sqrt(1 + x * x)); }
double sigmoidInverse(double s) { return (s - 0.5) / std::sqrt(s * (1 - s)); }

/// Components are kept this far from 0 and 1, which the sigmoid never reaches, and coefficients below this limit.
constexpr double margin = 1e-4, largestCoefficient = 200;

/// The colour that each wavelength interval of a reflectance contributes under the white light of the colour space; weighted by the
/// interval's width.
struct ColorWeights {
    std::vector<glm::dvec3> weights;
    std::vector<double> t;   ///< centre of the interval: 0 at 360 nm, 1 at 830 nm
};

ColorWeights colorWeights(ColorSpace space, int nanometers) {
    const DenseCurve& white = whiteSpectrum(space);
    const double normalization = integrateXyz(white).y;
    ColorWeights result;
    for (int first = 0; first < wavelengthCount; first += nanometers) {
        const int last = std::min(first + nanometers, wavelengthCount);
        glm::dvec3 sum(0);
        for (int i = first; i < last; ++i) sum += rgbFromXyz(space) * matchingFunctions()[i] * white[i] / normalization;
        result.weights.push_back(sum);
        result.t.push_back((first + last - 1) / 2.0 / (wavelengthCount - 1));
    }
    return result;
}

/// The colour of a curve, and its derivatives by the curve's coefficients (columns).
struct Linearization { glm::dvec3 color{0}; glm::dmat3 slope{0}; };

Linearization linearize(const ColorWeights& parts, glm::dvec3 c) {
    Linearization result;
    for (size_t i = 0; i < parts.weights.size(); ++i) {
        const double t = parts.t[i], x = (c.x * t + c.y) * t + c.z, squared = 1 + x * x, root = std::sqrt(squared);
        result.color += parts.weights[i] * (0.5 + 0.5 * x / root);
        const glm::dvec3 change = parts.weights[i] * (0.5 / (squared * root));
        result.slope += glm::dmat3(change * (t * t), change * t, change);
    }
    return result;
}

/// Levenberg-Marquardt steps from c towards coefficients of the colour `target`.
glm::dvec3 approach(const ColorWeights& parts, glm::dvec3 target, glm::dvec3 c, double tolerance) {
    double damping = 1e-6;
    Linearization now = linearize(parts, c);
    for (int iteration = 0; iteration < 30; ++iteration) {
        const glm::dvec3 residual = target - now.color;
        if (glm::dot(residual, residual) < tolerance * tolerance) break;
        const glm::dmat3 transposed = glm::transpose(now.slope);
        glm::dmat3 normal = transposed * now.slope;
        for (int k = 0; k < 3; ++k) normal[k][k] *= 1 + damping;
        glm::dvec3 candidate = c + glm::inverse(normal) * (transposed * residual);
        const double largest = std::max({std::abs(candidate.x), std::abs(candidate.y), std::abs(candidate.z)});
        if (!(largest < 1e30)) break;
        if (largest > largestCoefficient) candidate *= largestCoefficient / largest;
        const Linearization next = linearize(parts, candidate);
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

glm::dvec3 keptInside(glm::dvec3 rgb) { return glm::clamp(rgb, margin, 1 - margin); }

}  // namespace

double SmoothReflectance::operator()(double wavelength) const {
    const double t = (wavelength - shortestWavelength) / (wavelengthCount - 1);
    return sigmoid((c.x * t + c.y) * t + c.z);
}

SmoothReflectance upliftGrey(double value) { return {{0, 0, sigmoidInverse(std::clamp(value, margin, 1 - margin))}}; }

SmoothReflectance upliftReflectance(glm::dvec3 rgb, ColorSpace space) {
    const glm::dvec3 target = keptInside(rgb);
    const double grey = (target.x + target.y + target.z) / 3;
    glm::dvec3 c = upliftGrey(grey).c;
    if (target == glm::dvec3(grey)) return {c};

    // Move from grey to the colour in steps, so that each solution starts near the next.
    const ColorWeights parts = colorWeights(space, 1);
    constexpr int steps = 8;
    for (int step = 1; step <= steps; ++step) c = approach(parts, glm::mix(glm::dvec3(grey), target, double(step) / steps), c, 1e-8);
    return {c};
}

double upliftNode(int i) {
    const auto smooth = [](double x) { return x * x * (3 - 2 * x); };
    return smooth(smooth(static_cast<double>(i) / (UPLIFT_CELLS - 1)));
}

std::vector<float> fitUpliftTable() {
    constexpr int cells = UPLIFT_CELLS;
    const ColorWeights parts = colorWeights(ColorSpace::srgb, 5);
    std::vector<float> coefficients(static_cast<size_t>(3 * 3) * cells * cells * cells);
    tbb::parallel_for(0, 3 * cells * cells, [&](int line) {
        /* Fit a line of the table from the middle, where spectra are easy to fit, to both ends */
        const int channel = line / (cells * cells), y = line / cells % cells, x = line % cells;
        const auto fit = [&](int z, glm::dvec3 c) {
            glm::dvec3 rgb;
            rgb[channel] = upliftNode(z);
            rgb[(channel + 1) % 3] = rgb[channel] * x / (cells - 1);
            rgb[(channel + 2) % 3] = rgb[channel] * y / (cells - 1);
            c = approach(parts, keptInside(rgb), c, 1e-6);
            for (int k = 0; k < 3; ++k)
                coefficients[static_cast<size_t>((((channel * cells + z) * cells + y) * cells + x) * 3 + k)] = static_cast<float>(c[k]);
            return c;
        };
        const glm::dvec3 middle = fit(cells / 2, glm::dvec3(0));
        glm::dvec3 c = middle;
        for (int z = cells / 2 + 1; z < cells; ++z) c = fit(z, c);
        c = middle;
        for (int z = cells / 2 - 1; z >= 0; --z) c = fit(z, c);
    });
    return coefficients;
}

}  // namespace eikonal
