#pragma once
// From a colour to a spectrum of that colour.

#include "spectra/observer.h"

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
/// by which channel is the largest, its value, and the ratios of the other two to it.
class UpliftTable {
public:
    /// Takes about half a second of one core for 32 cells.
    explicit UpliftTable(int cells);
    /// Three for each colour.
    const std::vector<float>& coefficients() const { return coefficients_; }
    /// Interpolated, for components in [0, 1].
    SmoothReflectance operator()(glm::dvec3 rgb) const;

private:
    int cells_;
    std::vector<float> coefficients_;
};

}  // namespace eikonal
