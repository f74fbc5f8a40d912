#pragma once
// Spectral upsampling: smooth spectra for colours.

#include "color/observer.h"

#include <vector>

namespace eikonal {

/// A smooth reflectance between 0 and 1: a sigmoid of a quadratic in wavelength (Jakob and Hanika, "A Low-Dimensional Function Space for
/// Efficient Spectral Upsampling", 2019, the model that pbrt-v4 tabulates).
struct SmoothReflectance {
    glm::dvec3 c{0};  ///< coefficients of c.x t^2 + c.y t + c.z, where t is 0 at 360 nm and 1 at 830 nm
    double operator()(double wavelength) const;
};

/// The smooth reflectance with colour `rgb` (components in [0, 1]) under the white light of its colour space, to about 1e-4. For saturated
/// colours that no such curve reaches, the nearest one.
SmoothReflectance upliftReflectance(glm::dvec3 rgb, ColorSpace space);

/// Fits the smooth reflectances of all sRGB colours, three coefficients each, in the order in which the device looks them up (UPLIFT_CELLS
/// in eikonal/scene.h): by which channel is the largest, its value (at uplift nodes), and the ratios of the other two to it. Takes about
/// half a second on two cores; the result is built into the program (color/uplift_table.h).
std::vector<float> fitUpliftTable();

/// The value of the largest channel at node i of UPLIFT_CELLS. Nodes are dense at both ends, where spectra change fast.
double upliftNode(int i);
/// The smooth reflectance of a grey in [0, 1], which is constant.
SmoothReflectance upliftGrey(double value);

}  // namespace eikonal
