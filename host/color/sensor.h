#pragma once
// Film and camera sensors: pixel values from the light that reaches a pixel.

#include "color/observer.h"

#include <array>
#include <string>
#include <vector>

namespace eikonal {

/// The sensor settings of pbrt-v4's Film directive.
struct SensorDescription {
    std::string name = "cie1931";             ///< or a camera of sensorNames()
    double whiteBalance = 0;                  ///< K of the light to balance to white; 0: no balance, or 6500 for cameras
    double imagingRatio = 1;                  ///< exposure time (s) * ISO / 100
    ColorSpace output = ColorSpace::srgb;     ///< its white is what white light becomes; the image is in linear sRGB nevertheless
};

/// The matrix from linear sRGB light to the image's linear sRGB; exactly a multiple of the identity for cie1931 without white balance,
/// otherwise von Kries adaptation with Bradford's cones. A camera responds to spectra, not colours: its response to a colour is the best
/// fit over the swatches of a colour chart under daylight and incandescent light, followed by pbrt-v4's matrix from the camera's response
/// to XYZ. The name must be known.
glm::dmat3 imageFromLight(const SensorDescription& sensor);

/// The image value in linear sRGB of unit light at 360, 361, ... 830 nm: pbrt-v4's sensors exactly. The name must be known.
std::array<glm::dvec3, wavelengthCount> linearSrgbResponse(const SensorDescription& sensor);

/// "cie1931" and the cameras, sorted.
std::vector<std::string> sensorNames();

}  // namespace eikonal
