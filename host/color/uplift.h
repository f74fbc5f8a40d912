#pragma once
// From a colour to a spectrum of that colour.

#include "color/observer.h"

#include <vector>

namespace eikonal {

/// A smooth reflectance between 0 and 1: a sigmoid of a quadratic in wavelength (Jakob and Hanika, "A Low-Dimensional Function
/// Space for Efficient Spectral Upsampling", 2019, the model that pbrt-v4 tabulates).
struct SmoothReflectance {
    glm::dvec3 c{0};  ///< of the quadratic, of t = 0 at 360 nm to 1 at 830 nm: c.x t^2 + c.y t + c.z
    double operator()(double wavelength) const;
};

/// The smooth reflectance that looks like `rgb` (components in [0, 1]) under the white light of its space, to about 1e-4;
/// the nearest there is for colours that no such curve reaches (saturated ones).
SmoothReflectance upliftReflectance(glm::dvec3 rgb, ColorSpace space);

/// The coefficients of the smooth reflectances of all colours of sRGB, tabulated as the device looks them up (UPLIFT_CELLS in eikonal/scene.h):
/// by which channel is the largest, its value (at uplift nodes), and the ratios of the other two to it. Three for each colour.
/// Takes about half a second of two cores: the program carries the result (spectra/uplift_table.h).
std::vector<float> fitUpliftTable();

/// Where the table has values of the largest channel, i of UPLIFT_CELLS: close together at both ends, where spectra change fast.
double upliftNode(int i);
/// The smooth reflectance of a grey in [0, 1]: a constant.
SmoothReflectance upliftGrey(double value);

}  // namespace eikonal
