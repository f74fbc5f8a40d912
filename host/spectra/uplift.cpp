#include "spectra/uplift.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace eikonal {
namespace {

double sigmoid(double x) { return 0.5 + x / (2 * std::sqrt(1 + x * x)); }
double sigmoidInverse(double s) { return (s - 0.5) / std::sqrt(s * (1 - s)); }

/// Components are kept this far from 0 and 1, where the sigmoid never arrives; and coefficients below this.
constexpr double margin = 1e-4, largestCoefficient = 200;

/// What each part of a reflectance adds to its colour under the white light of the space. Each part is as wide as its number says.
struct ColorWeights {
    std::vector<glm::dvec3> weights;
    std::vector<double> t;   ///< where it is: 0 at 360 nm, 1 at 830 nm
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

/// The colour of a curve, and how it changes with the curve's coefficients (columns).
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

/// Levenberg-Marquardt steps from c towards the colour `target`.
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

/// Where the table has values of the largest channel: close together at both ends, where spectra change fast.
double node(int i, int cells) {
    const auto smooth = [](double x) { return x * x * (3 - 2 * x); };
    return smooth(smooth(static_cast<double>(i) / (cells - 1)));
}

}  // namespace

double SmoothReflectance::operator()(double wavelength) const {
    const double t = (wavelength - shortestWavelength) / (wavelengthCount - 1);
    return sigmoid((c.x * t + c.y) * t + c.z);
}

SmoothReflectance upliftReflectance(glm::dvec3 rgb, ColorSpace space) {
    const glm::dvec3 target = keptInside(rgb);
    const double grey = (target.x + target.y + target.z) / 3;
    glm::dvec3 c(0, 0, sigmoidInverse(grey));
    if (target == glm::dvec3(grey)) return {c};

    // Walk from grey to the colour, so that each solution starts near the next.
    const ColorWeights parts = colorWeights(space, 1);
    constexpr int steps = 8;
    for (int step = 1; step <= steps; ++step) c = approach(parts, glm::mix(glm::dvec3(grey), target, double(step) / steps), c, 1e-8);
    return {c};
}

UpliftTable::UpliftTable(int cells) : cells_(cells), coefficients_(static_cast<size_t>(3 * 3) * cells * cells * cells) {
    const ColorWeights parts = colorWeights(ColorSpace::srgb, 5);
    tbb::parallel_for(0, 3 * cells * cells, [&](int line) {
        /* One line of the table: from the middle, where spectra are easily found, to both ends */
        const int channel = line / (cells * cells), y = line / cells % cells, x = line % cells;
        const auto fit = [&](int z, glm::dvec3 c) {
            glm::dvec3 rgb;
            rgb[channel] = node(z, cells);
            rgb[(channel + 1) % 3] = rgb[channel] * x / (cells - 1);
            rgb[(channel + 2) % 3] = rgb[channel] * y / (cells - 1);
            c = approach(parts, keptInside(rgb), c, 1e-6);
            for (int k = 0; k < 3; ++k)
                coefficients_[static_cast<size_t>((((channel * cells + z) * cells + y) * cells + x) * 3 + k)] = static_cast<float>(c[k]);
            return c;
        };
        const glm::dvec3 middle = fit(cells / 2, glm::dvec3(0));
        glm::dvec3 c = middle;
        for (int z = cells / 2 + 1; z < cells; ++z) c = fit(z, c);
        c = middle;
        for (int z = cells / 2 - 1; z >= 0; --z) c = fit(z, c);
    });
}

SmoothReflectance UpliftTable::operator()(glm::dvec3 rgb) const {
    if (rgb.x == rgb.y && rgb.y == rgb.z) return {{0, 0, sigmoidInverse(std::clamp(rgb.x, margin, 1 - margin))}};
    const int channel = rgb.x >= rgb.y && rgb.x >= rgb.z ? 0 : rgb.y >= rgb.z ? 1 : 2;
    const double largest = rgb[channel], x = rgb[(channel + 1) % 3] / largest * (cells_ - 1), y = rgb[(channel + 2) % 3] / largest * (cells_ - 1);
    int z = 0;
    while (z + 2 < cells_ && node(z + 1, cells_) <= largest) ++z;
    const int ix = std::min(static_cast<int>(x), cells_ - 2), iy = std::min(static_cast<int>(y), cells_ - 2);
    const double fx = x - ix, fy = y - iy, fz = (largest - node(z, cells_)) / (node(z + 1, cells_) - node(z, cells_));
    SmoothReflectance result;
    for (int corner = 0; corner < 8; ++corner) {
        const int dx = corner & 1, dy = corner >> 1 & 1, dz = corner >> 2;
        const double weight = (dx ? fx : 1 - fx) * (dy ? fy : 1 - fy) * (dz ? fz : 1 - fz);
        const size_t at = static_cast<size_t>((((channel * cells_ + z + dz) * cells_ + iy + dy) * cells_ + ix + dx) * 3);
        result.c += weight * glm::dvec3(coefficients_[at], coefficients_[at + 1], coefficients_[at + 2]);
    }
    return result;
}

}  // namespace eikonal
