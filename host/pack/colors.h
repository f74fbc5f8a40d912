#pragma once
// Colours as tables hold them: what eval_color (kernels/color.clh) reads.

#include "eikonal/portable.h"
#include "spectra/spectrum.h"

namespace eikonal {

struct Packer;

/// Emitted light, times `factor`.
color packEmission(Packer&, const Spectrum& light, double factor = 1);
/// A reflectance, transmittance or albedo: in [0, 1].
color packReflectance(Packer&, const Spectrum& reflectance);
/// A coefficient of a medium, an index of refraction, or whatever else is not negative, times `factor`.
color packCoefficient(Packer&, const Spectrum& coefficient, double factor = 1);
/// The same in all channels.
color packNumber(double value);
/// Linear sRGB, of no spectrum in particular.
color packRgb(glm::dvec3 rgb);

/// Luminance of emitted light, times `factor`, as it was rounded for the device: what light samplers go by.
double luminanceOf(const Spectrum& light, double factor = 1);

}  // namespace eikonal
