#pragma once
// Colours in the form that eval_color (kernels/shade/color.clh) reads.

#include "color/spectrum.h"
#include "color/uplift.h"
#include "pack/context.h"

#include <map>
#include <optional>
#include <tuple>
#include <vector>

namespace eikonal {

/// Packs colours, and the spectra that they refer to.
class ColorPacker {
public:
    ColorPacker(const PackContext& context, ColorTables& tables) : context_(context), tables_(tables) {}

    /// Emitted light, times `factor`.
    color emission(const Spectrum& light, double factor = 1);
    /// A reflectance, transmittance or albedo. What lies outside [0, 1] is clamped, at each wavelength or in each channel.
    color reflectance(const Spectrum& reflectance);
    /// A colour within a texture of reflectances: not clamped, since what the texture does with it may bring it back into [0, 1].
    color textureColor(const Spectrum& color);
    /// A coefficient of a medium, an index of refraction, or another value that is not negative, times `factor`.
    color coefficient(const Spectrum& coefficient, double factor = 1);
    /// The same at all wavelengths.
    color constant(double value) const;
    /// The light that texels of a light's image are relative to, times `factor`.
    color white(double factor = 1);
    /// Texels of a light's image, linear sRGB, as `environment_texels` holds them: appended to `table`.
    void appendTexels(Table<float>& table, const std::vector<glm::vec3>& texels) const;
    /// Adds the table from which the device upsamples colours of images to spectra.
    void addUplift();
    /// The largest value, over wavelengths or channels, of the sum of two coefficients; null counts as 0.
    float greatestSum(const color* a, const color* b) const;
    /// Throws a SceneError if a packed colour overflowed single precision. what: whose it is, with the name of its parameter.
    void checkRange(const color& packed, const SourceLocation& where, const std::string& what) const;

    /// For spectral rendering, before all other colours: the constant 1, then the responses of the film and the auxiliary channels.
    void packSensor(settings& frame);
    /// The range and buckets of a film that stores spectra.
    void packFilmSpectrum(settings& frame);
    /// The wavelengths of a render whose paths merge: the same ones for all paths of a pass. Once the sampler is packed.
    void packPassWavelengths(const settings& frame);

private:
    uint curve(const DenseCurve& curve);
    /// The curve that is the product of a smooth spectrum and another curve; none where there are many curves.
    std::optional<uint> smoothCurve(const SmoothReflectance& shape, uint factor);
    uint response(const std::array<glm::dvec3, wavelengthCount>& response);
    color curveColor(const DenseCurve& curve, double factor);
    color smooth(glm::dvec3 rgb, ColorSpace space, double factor, uint curve);
    color unbounded(glm::dvec3 rgb, ColorSpace space, double factor, uint curve);

    const PackContext& context_;
    ColorTables& tables_;
    std::map<DenseCurve, uint> curves_;                                                   ///< -> `curves`
    std::map<std::tuple<double, double, double, uint>, uint> smoothCurves_;               ///< by coefficients and the other curve
    std::map<std::tuple<double, double, double, ColorSpace>, SmoothReflectance> smooth_;  ///< of colours seen before
};

/// A number, for textures of numbers: only `scale` is read.
color packNumber(double value);
/// Linear sRGB, for rendering in RGB.
color packRgb(glm::dvec3 rgb);

/// The curve scaled to luminance 1; zero stays zero.
DenseCurve ofUnitLuminance(DenseCurve curve);
/// Luminance of emitted light, times `factor`, rounded to single precision. Light samplers weight lights by it.
double luminanceOf(const Spectrum& light, double factor = 1);

/// How the film turns light into values of the image: for rendering in RGB its sensor, white balance, sensitivity and exposure time
/// (color/sensor.h), which spectral rendering has in the curves of packSensor; and the limit of a sample.
void packExposure(const FilmDescription& film, settings& frame);

}  // namespace eikonal
