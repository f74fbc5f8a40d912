#pragma once
// Tabulated functions of wavelength, including those built into the program.

#include <memory>
#include <string>
#include <vector>

namespace eikonal {

/// A piecewise-linear function of wavelength, 0 beyond its ends (as pbrt-v4 reads one that a scene gives). With a single wavelength it is 0
/// everywhere.
struct SampledCurve {
    std::vector<double> wavelengths;  ///< nm, ascending
    std::vector<double> values;
    double operator()(double wavelength) const;
};

/// A built-in spectrum: pbrt-v4's named spectra ("metal-Cu-eta", "glass-BK7", "stdillum-D65", "canon_eos_100d_r"), and "cie1931-X",
/// "cie-daylight-S0", "swatch-00" and the like. Null for unknown names. Spectra are constant beyond the ends of their measurement.
/// "stdillum-..." and "illum-..." are scaled to the photopic integral of a constant 1. Thread-safe.
std::shared_ptr<const SampledCurve> namedSpectrum(const std::string& name);

/// All names of built-in spectra, sorted.
std::vector<std::string> spectrumNames();

}  // namespace eikonal
