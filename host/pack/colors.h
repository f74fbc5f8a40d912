#pragma once
// Colours as tables hold them: what eval_color (kernels/shade/color.clh) reads.

#include "color/spectrum.h"
#include "color/uplift.h"
#include "pack/context.h"

#include <map>
#include <tuple>
#include <vector>

namespace eikonal {

/// Makes colours, and the spectra that they refer to.
class ColorPacker {
public:
    ColorPacker(const PackContext& context, ColorTables& tables) : context_(context), tables_(tables) {}

    /// Emitted light, times `factor`.
    color emission(const Spectrum& light, double factor = 1);
    /// A reflectance, transmittance or albedo: in [0, 1].
    color reflectance(const Spectrum& reflectance);
    /// A coefficient of a medium, an index of refraction, or whatever else is not negative, times `factor`.
    color coefficient(const Spectrum& coefficient, double factor = 1);
    /// The same at all wavelengths.
    color constant(double value) const;
    /// The light that texels of a light's image are relative to, times `factor`.
    color white(double factor = 1);
    /// Texels of a light's image, linear sRGB, as `environment_texels` holds them: appended to `table`.
    void appendTexels(Table<float>& table, const std::vector<glm::vec3>& texels) const;
    /// Makes sure that colours of images can be made spectra.
    void addUplift();
    /// The greatest value, at any wavelength or in any channel, of a coefficient or of the sum of two; null: none.
    float greatestSum(const color* a, const color* b) const;

    /// For spectral rendering, before everything else: the curve that is 1, then the responses of film and auxiliary channels.
    void packSensor(settings& frame);
    /// The wavelengths that the film keeps a spectrum of, if it does.
    void packFilmSpectrum(settings& frame);

private:
    uint curve(const DenseCurve& curve);
    uint response(const std::array<glm::dvec3, wavelengthCount>& response);
    color curveColor(const DenseCurve& curve, double factor);
    color smooth(glm::dvec3 rgb, ColorSpace space, double factor, uint curve);
    color unbounded(glm::dvec3 rgb, ColorSpace space, double factor, uint curve);

    const PackContext& context_;
    ColorTables& tables_;
    std::map<DenseCurve, uint> curves_;                                                   ///< -> `curves`
    std::map<std::tuple<double, double, double, ColorSpace>, SmoothReflectance> smooth_;  ///< found for colours
};

/// A number for every wavelength, to be read from `scale` only: what belongs to a texture of numbers.
color packNumber(double value);
/// Linear sRGB, of no spectrum in particular. For rendering in RGB.
color packRgb(glm::dvec3 rgb);

/// A curve whose light has luminance 1; one that is 0 stays so.
DenseCurve ofUnitLuminance(DenseCurve curve);
/// Luminance of emitted light, times `factor`, as it was rounded for the device: what light samplers go by.
double luminanceOf(const Spectrum& light, double factor = 1);

}  // namespace eikonal
