#pragma once
// Whether a scene is rendered in RGB or at wavelengths.

#include "scene/scene.h"

namespace eikonal {

/// What in the scene needs spectral rendering, with its location; empty if RGB suffices, which is faster and has less colour noise.
///   - a film that keeps a spectrum;
///   - a camera's sensor, which RGB can only approximate;
///   - a light, reflectance, coefficient or index of refraction that is given as a spectrum or a temperature, also in a texture or a grid
///     (except metals: RGB rendering has indices that reflect like the metal).
/// A scene that is given in RGB is rendered in RGB unless --color spectral is given; docs/accuracy.md shows the difference.
std::string needOfWavelengths(const Scene& scene);

}  // namespace eikonal
