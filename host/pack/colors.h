#pragma once
// Colours as tables hold them: what eval_color (kernels/shade/color.clh) reads.

#include "eikonal/portable.h"
#include "memory_pages.h"
#include "color/spectrum.h"
#include "color/uplift.h"

#include <map>
#include <tuple>
#include <vector>

namespace eikonal {

struct Packer;

/// What packing colours remembers: the curves that are in `curves`, and the smooth spectra that were found for colours.
struct ColorPacker {
    std::map<DenseCurve, uint> curves;
    std::map<std::tuple<double, double, double, ColorSpace>, SmoothReflectance> smooth;
};

/// Emitted light, times `factor`.
color packEmission(Packer&, const Spectrum& light, double factor = 1);
/// A reflectance, transmittance or albedo: in [0, 1].
color packReflectance(Packer&, const Spectrum& reflectance);
/// A coefficient of a medium, an index of refraction, or whatever else is not negative, times `factor`.
color packCoefficient(Packer&, const Spectrum& coefficient, double factor = 1);
/// The same at all wavelengths.
color packConstant(Packer&, double value);
/// The same, to be read from `scale` only: what belongs to a texture of numbers.
color packNumber(double value);
/// Linear sRGB, of no spectrum in particular. For rendering in RGB.
color packRgb(glm::dvec3 rgb);
/// The light that texels of a light's image are relative to, times `factor`.
color packWhite(Packer&, double factor = 1);
/// Texels of a light's image, linear sRGB, to the end of `environment_texels`.
void packTexels(Packer&, const std::vector<glm::vec3>& texels);
/// Linear light of each of the 256 values of an 8-bit sRGB channel: `srgb_levels`.
Table<float> srgbLevels();
/// Makes sure that colours of images can be made spectra.
void packUplift(Packer&);
/// The greatest value, at any wavelength or in any channel, of a coefficient or of the sum of two; null: none.
float greatestSum(const Packer&, const color* a, const color* b);
/// What film and auxiliary channels make of wavelengths, after the curve that is 1. Comes first, and only for spectral rendering.
void packSensor(Packer&);
/// The wavelengths that the film keeps a spectrum of, if it does.
void packSpectrumKept(Packer&);

/// Luminance of emitted light, times `factor`, as it was rounded for the device: what light samplers go by.
double luminanceOf(const Spectrum& light, double factor = 1);

}  // namespace eikonal
