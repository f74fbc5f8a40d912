#pragma once
// Converts film irradiance to pixel values, by the film's sensor and exposure.

#include "film/totals.h"

namespace eikonal {

/// Applies the film's sensor, white balance, sensitivity and exposure time (color/sensor.h) to the colour of an image that was rendered in
/// RGB, and scales the variance with each pixel's luminance. (In spectral rendering the device does this.) The image stays in linear sRGB
/// whatever colour space the film names; that only decides what is white.
void expose(FilmImage& image, const FilmDescription& film);

/// The image of all samples of a film, exposed.
FilmImage developExposed(const FilmTotals& totals, const PackedScene& scene, const FilmDescription& film);

}  // namespace eikonal
