#pragma once
// Functions of wavelength as tables, and the tables that the program carries.

#include <memory>
#include <string>
#include <vector>

namespace eikonal {

/// A piecewise-linear function of wavelength, 0 beyond its ends (as pbrt-v4 reads one that a scene gives). A single wavelength has no width: 0.
struct SampledCurve {
    std::vector<double> wavelengths;  ///< nm, ascending
    std::vector<double> values;
    double operator()(double wavelength) const;
};

/// A named spectrum: those of pbrt-v4 ("metal-Cu-eta", "glass-BK7", "stdillum-D65", "canon_eos_100d_r"), and "cie1931-X",
/// "cie-daylight-S0", "swatch-00" with their kin. Null if there is none of that name. Each is constant beyond the ends of its
/// measurement. "stdillum-..." and "illum-..." are scaled to the photopic integral of a constant 1. Thread-safe.
std::shared_ptr<const SampledCurve> namedSpectrum(const std::string& name);

/// All names that namedSpectrum knows, sorted.
std::vector<std::string> spectrumNames();

}  // namespace eikonal
