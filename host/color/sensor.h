#pragma once
// Film and camera sensors: from the light that reaches a pixel to the pixel's value.

#include "color/observer.h"

#include <array>
#include <string>
#include <vector>

namespace eikonal {

/// How a film turns light into numbers, in the terms of pbrt-v4's Film directive.
struct SensorDescription {
    std::string name = "cie1931";             ///< or a camera of sensorNames()
    double whiteBalance = 0;                  ///< K, of the light that is to become white: daylight, a black body below 4000 K; 0: none for cie1931, 6500 for cameras
    double imagingRatio = 1;                  ///< exposure time (s) * ISO / 100
    ColorSpace output = ColorSpace::srgb;     ///< of the image
};

/// The matrix from linear sRGB light to the pixel's value; the identity for the defaults.
/// cie1931: exact (von Kries adaptation with Bradford's cones). A camera sees spectra, not colours: its response to a colour is
/// that which fits best the swatches of a colour chart under daylight and incandescent light, then pbrt-v4's matrix from the
/// camera's response to XYZ. The name must be known.
glm::dmat3 pixelFromLinearSrgb(const SensorDescription& sensor);

/// What light of each wavelength adds to the image, in linear sRGB, at 360, 361, ... 830 nm: pbrt-v4's sensors exactly. The name must be known.
std::array<glm::dvec3, wavelengthCount> linearSrgbResponse(const SensorDescription& sensor);

/// "cie1931" and the cameras, sorted.
std::vector<std::string> sensorNames();

}  // namespace eikonal
