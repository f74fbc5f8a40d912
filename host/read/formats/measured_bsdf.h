#pragma once
// Measured BSDFs: files of the RGL material database (Dupuy and Jakob 2018, "An Adaptive Parameterization for Efficient Material
// Acquisition and Rendering"). include/eikonal/measured.h explains the arrays.

#include <memory>
#include <string>
#include <vector>

namespace eikonal {

struct MeasuredBsdf {
    struct Grid { size_t width = 0, height = 0; std::vector<float> values; };  ///< one grid, or several in a row
    std::vector<float> phi, theta;      ///< measured directions, radians, ascending
    std::vector<float> wavelengths;     ///< nm, ascending
    Grid facets, area;
    Grid visible, brightness;           ///< for each phi, for each theta
    Grid spectra;                       ///< for each phi, theta and wavelength; same size as brightness
    bool isIsotropic() const { return phi.size() <= 2; }
};

/// Throws ReadProblem if the file cannot be opened or its contents are invalid.
std::shared_ptr<const MeasuredBsdf> readMeasuredBsdf(const std::string& path);

}  // namespace eikonal
