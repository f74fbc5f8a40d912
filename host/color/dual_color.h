#pragma once
// A colour in both ways of rendering at once, to predict how far RGB is off.

#include "color/spectrum.h"

#include <glm/glm.hpp>

#include <array>

namespace eikonal {

/// A factor of light along a path, or light itself: as a spectrum, the mean of each band of 5 nm, and as the three numbers that RGB
/// rendering uses in its place. Products and sums act on both.
struct DualColor {
    static constexpr int bandWidth = 5, bands = (wavelengthCount - 1) / bandWidth;   ///< from 360 nm
    std::array<double, bands> spectrum{};
    glm::dvec3 rgb{0};

    static DualColor constant(double value);
    /// Emitted light, as lights are packed (pack/colors.h).
    static DualColor emission(const Spectrum& light);
    /// A reflectance, transmittance or albedo.
    static DualColor reflectance(const Spectrum& reflectance);
    /// A coefficient of a medium, or an index of refraction.
    static DualColor coefficient(const Spectrum& coefficient);
    /// A texel of linear sRGB. isReflectance: it is one if it is in [0, 1].
    static DualColor texel(glm::dvec3 rgb, bool isReflectance);
    /// White light of luminance 1.
    static const DualColor& white();

    /// f of each band and of each channel.
    template <class F> DualColor map(const F& f) const {
        DualColor result;
        for (int i = 0; i < bands; ++i) result.spectrum[i] = f(spectrum[i]);
        for (int c = 0; c < 3; ++c) result.rgb[c] = f(rgb[c]);
        return result;
    }
    /// f of each band, or channel, of two colours.
    template <class F> static DualColor combine(const DualColor& a, const DualColor& b, const F& f) {
        DualColor result;
        for (int i = 0; i < bands; ++i) result.spectrum[i] = f(a.spectrum[i], b.spectrum[i]);
        for (int c = 0; c < 3; ++c) result.rgb[c] = f(a.rgb[c], b.rgb[c]);
        return result;
    }
    DualColor operator*(const DualColor& b) const;
    DualColor operator+(const DualColor& b) const;
    DualColor operator*(double factor) const;

    /// Linear sRGB of the spectrum of light. `rgb` is what RGB rendering has for it.
    glm::dvec3 seen() const;
};

}  // namespace eikonal
