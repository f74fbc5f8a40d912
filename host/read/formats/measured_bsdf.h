#pragma once
// Measured BSDFs: files of the RGL material database (Dupuy and Jakob 2018, "An Adaptive Parameterization for Efficient Material Acquisition
// and Rendering"). What the arrays mean: include/eikonal/measured.h.

#include <memory>
#include <string>
#include <vector>

namespace eikonal {

struct MeasuredBsdf {
    struct Grid { size_t width = 0, height = 0; std::vector<float> values; };  ///< one grid or several, one after the other
    std::vector<float> phi, theta;      ///< of the directions that were measured, radians, ascending
    std::vector<float> wavelengths;     ///< nm, ascending
    Grid facets, area;
    Grid visible, brightness;           ///< for each phi, for each theta
    Grid spectra;                       ///< for each phi, for each theta, for each wavelength; as wide and high as brightness
    bool isIsotropic() const { return phi.size() <= 2; }
};

/// Throws ReadProblem: no such file, or what in it is not as it should be.
std::shared_ptr<const MeasuredBsdf> readMeasuredBsdf(const std::string& path);

}  // namespace eikonal
