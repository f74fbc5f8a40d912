#pragma once
// Whether a scene is rendered in RGB or at wavelengths.

#include "image/image_data.h"
#include "pack/color_choice.h"
#include "pack/space.h"
#include "scene/scene.h"

#include <memory>
#include <string>
#include <vector>

namespace eikonal {

/// How far RGB may be off, as predicted (pack/rgb_error.h), before a scene is rendered at wavelengths. The comparison with pbrt-v4 accepts
/// 1 % of the mean and 5 % of a block of 8 x 8 pixels (docs/accuracy.md); less is asked for here, since noise comes on top and the
/// prediction is rough.
struct RgbTolerance { double inMean, inPart; };
constexpr RgbTolerance mostRgbError{0.005, 0.035};

/// What in the scene needs wavelengths whatever its colours, with its location; empty if nothing does:
///   - a film that keeps a spectrum;
///   - a camera's sensor, which RGB can only approximate;
///   - a light, reflectance, coefficient or index of refraction that is given as a spectrum or a temperature, also in a texture or a grid
///     (except metals: RGB rendering has indices that reflect like the metal).
std::string needOfWavelengths(const Scene& scene);

/// Renders at wavelengths what --color asks for or, with auto, what needs them and what RGB would miss by mostRgbError or more. Everything
/// else is rendered in RGB, which is faster and has less colour noise. Depends on the scene alone, not on its resolution, its samples, or
/// the part that is rendered. images: those of the scene. near: of its bounds (pack/scene_bounds.h). Throws a SceneError if --color rgb
/// contradicts the film.
ColorChoice chooseColor(const Scene& scene, const std::vector<std::shared_ptr<const ImageData>>& images, const Box& near);

}  // namespace eikonal
