#pragma once
// The CIE 1931 observer: integrals of spectra against the matching functions, and the colour spaces built on them.

#include "color/curve.h"

#include <glm/glm.hpp>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace eikonal {

/// Spectra are integrated over this range with one sample per nm, as in pbrt-v4.
constexpr int shortestWavelength = 360, longestWavelength = 830;
constexpr int wavelengthCount = longestWavelength - shortestWavelength + 1;

/// Values at 360, 361, ... 830 nm.
using DenseCurve = std::array<double, wavelengthCount>;
DenseCurve densify(const SampledCurve& curve);

/// The 2-degree matching functions x, y, z at 360, 361, ... 830 nm.
const std::array<glm::dvec3, wavelengthCount>& matchingFunctions();

/// XYZ of a spectrum: the sums over the range of spectrum times matching functions.
glm::dvec3 integrateXyz(const DenseCurve& curve);

enum class ColorSpace { srgb, dciP3, rec2020, aces2065 };

/// The colour space that pbrt-v4 calls "srgb", "dci-p3" (with a D65 white), "rec2020" or "aces2065-1", case-insensitive.
std::optional<ColorSpace> colorSpaceNamed(const std::string& name);
std::vector<std::string> colorSpaceNames();

/// The white of a colour space: its spectrum, and its chromaticity.
const DenseCurve& whiteSpectrum(ColorSpace space);
glm::dvec2 whitePoint(ColorSpace space);

/// XYZ from linear RGB of a colour space, whose white (1, 1, 1) has Y = 1. Derived from its primaries and its white spectrum.
const glm::dmat3& xyzFromRgb(ColorSpace space);
const glm::dmat3& rgbFromXyz(ColorSpace space);

}  // namespace eikonal
