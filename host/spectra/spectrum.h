#pragma once
// A distribution over wavelengths as a scene gives it, and its colour.

#include <glm/glm.hpp>

#include <memory>
#include <string>
#include <vector>

namespace eikonal {

/// A piecewise-linear function of wavelength, constant beyond its ends.
struct SampledCurve {
    std::vector<double> wavelengths;  ///< nm, ascending
    std::vector<double> values;
    double operator()(double wavelength) const;
};

enum class ColorSpace { srgb, dciP3, rec2020, aces2065 };

/// A spectrum, remembered as it was given so that spectral rendering can use more of it than its colour.
class Spectrum {
public:
    enum class Kind { rgb, sampled, blackbody };

    Spectrum() = default;                                                    ///< zero
    static Spectrum constant(double value);                                  ///< the same at all wavelengths, and in all channels
    static Spectrum rgb(glm::dvec3 color, ColorSpace space = ColorSpace::srgb);
    static Spectrum sampled(SampledCurve curve);
    static Spectrum blackbody(double kelvin);                                ///< normalised to a maximum of 1

    Kind kind() const { return kind_; }
    bool isConstant() const { return constant_; }                            ///< made by constant()
    const SampledCurve& curve() const { return *curve_; }                    ///< sampled
    double kelvin() const { return kelvin_; }                                ///< blackbody

    /// Linear sRGB of a reflectance, transmittance or coefficient: white is (1, 1, 1) whatever the light.
    glm::dvec3 albedo() const;
    /// Linear sRGB of emitted light. An rgb colour is itself; a curve or blackbody has luminance 1, as pbrt-v4 scales it
    /// (its lights divide by the photometric integral of their spectrum).
    glm::dvec3 illuminant() const;
    /// The value of a float: the first channel.
    double value() const { return rgb_.x; }

    Spectrum operator*(double factor) const;                                 ///< scaled; the factor is applied after any normalisation

private:
    Kind kind_ = Kind::rgb;
    bool constant_ = true;
    glm::dvec3 rgb_{0};
    ColorSpace space_ = ColorSpace::srgb;
    std::shared_ptr<const SampledCurve> curve_;
    double kelvin_ = 0;
    double factor_ = 1;
};

/// A named spectrum of pbrt-v4 ("metal-Cu-eta", "glass-BK7", "stdillum-D65"); null if there is none of that name.
std::shared_ptr<const SampledCurve> namedSpectrum(const std::string& name);
/// All names that namedSpectrum knows, sorted.
std::vector<std::string> spectrumNames();

/// Complex indices of refraction, one for each channel, whose Fresnel reflectance is nearest to that of the spectra under
/// daylight at all angles: what lets a measured metal be rendered in RGB.
struct ConductorIndices { glm::dvec3 eta, k; };
ConductorIndices conductorIndices(const Spectrum& eta, const Spectrum& k);

}  // namespace eikonal
