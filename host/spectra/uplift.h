#pragma once
// From a colour to a spectrum of that colour.

#include "spectra/observer.h"

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

}  // namespace eikonal
