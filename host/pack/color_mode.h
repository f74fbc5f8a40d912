#pragma once
// Whether a scene is rendered in RGB or at wavelengths.

#include "scene/scene.h"

namespace eikonal {

/// What of the scene asks for wavelengths, in words with its place, or an empty text: then RGB will do, which is faster and has less noise
/// of colour.
///   - a film that keeps a spectrum;
///   - a camera's sensor: it sees spectra, and what RGB makes of them is a fit;
///   - a light, reflectance, coefficient or index of refraction that is given as a spectrum or a temperature, by itself, in a texture or in
///   a grid (metals are not
///     counted: RGB has indices that reflect like a metal).
/// What is given in RGB is rendered in RGB, and left to --color spectral; docs/accuracy.md has the difference.
std::string needOfWavelengths(const Scene& scene);

}  // namespace eikonal
