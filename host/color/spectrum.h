#pragma once
// A spectrum as a scene gives it, and its colour.

#include "color/observer.h"

#include <glm/glm.hpp>

#include <memory>
#include <string>
#include <vector>

namespace eikonal {

/// A spectrum, kept in the form in which it was given, so that spectral rendering can use more than its colour.
class Spectrum {
public:
    enum class Kind { rgb, sampled, blackbody };

    Spectrum() = default;                                                    ///< zero
    static Spectrum constant(double value);                                  ///< the same at all wavelengths, and in all channels
    static Spectrum rgb(glm::dvec3 color, ColorSpace space = ColorSpace::srgb);
    static Spectrum sampled(SampledCurve curve);
    static Spectrum sampled(std::shared_ptr<const SampledCurve> curve);
    static Spectrum sampled(const DenseCurve& curve);
    static Spectrum blackbody(double kelvin);                                ///< Planck's law, scaled to a maximum of 1

    Kind kind() const { return kind_; }
    bool isConstant() const { return constant_; }                            ///< whether made by constant()
    bool isFlat() const;                                                     ///< whether a constant, or grey
    const SampledCurve& curve() const { return *curve_; }                    ///< sampled
    double kelvin() const { return kelvin_; }                                ///< blackbody
    glm::dvec3 color() const { return rgb_; }                                ///< rgb: in its colour space
    ColorSpace space() const { return space_; }                              ///< rgb
    double factor() const { return factor_; }                                ///< sampled, blackbody: a factor

    /// Linear sRGB of a reflectance, transmittance or coefficient, as a factor of white light (1, 1, 1). Not negative.
    glm::dvec3 albedo() const;
    /// Linear sRGB of emitted light; components outside [0, inf) occur for colours outside the gamut. An rgb colour is converted to sRGB; a
    /// curve or blackbody is scaled to luminance 1 (0 stays 0), because pbrt-v4's lights divide by their photometric integral.
    glm::dvec3 illuminant() const;
    /// The number for a float parameter; of a curve or a colour, its mean over daylight weighted by luminous efficiency.
    double value() const;
    /// The values at 360, 361, ... 830 nm. A colour becomes a smooth spectrum of that colour (pbrt-v4's unbounded RGB spectrum).
    DenseCurve dense() const;

    /// Whether all values are in [0, 1], at all wavelengths and as a colour in sRGB.
    bool isReflectance() const;
    /// The nearest reflectance: each value clamped to [0, 1]. Of a colour with a component above 1, the spectrum of that colour clamped.
    Spectrum clampedToUnit() const;
    Spectrum operator*(double factor) const;                                 ///< scaled; the factor applies after normalisation

private:
    Kind kind_ = Kind::rgb;
    bool constant_ = true;
    glm::dvec3 rgb_{0};
    ColorSpace space_ = ColorSpace::srgb;
    std::shared_ptr<const SampledCurve> curve_;
    double kelvin_ = 0;
    double factor_ = 1;  ///< sampled and blackbody
};

/// f of spectra at each wavelength; of colours, per channel.
template <class F, class... Spectra> Spectrum combineSpectra(const F& f, const Spectra&... spectra) {
    const auto valuesOf = [&](auto result, size_t count, const auto&... operands) {
        for (size_t i = 0; i < count; ++i) result[i] = f(operands[i]...);
        return result;
    };
    if (((spectra.kind() == Spectrum::Kind::rgb) && ...)) return Spectrum::rgb(valuesOf(glm::dvec3(0), 3, spectra.albedo()...));
    return Spectrum::sampled(valuesOf(DenseCurve{}, wavelengthCount, spectra.dense()...));
}

/// Complex indices of refraction, one per channel, whose Fresnel reflectance best matches that of the spectra under daylight at all angles.
/// Used to render measured metals in RGB.
struct ConductorIndices { glm::dvec3 eta, k; };
ConductorIndices conductorIndices(const Spectrum& eta, const Spectrum& k);

}  // namespace eikonal
