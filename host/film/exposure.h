#pragma once
// From the light that reaches the film to the pixels' values, which its sensor and its exposure make of it.

#include "image/film_image.h"

namespace eikonal {

/// Of an image that was rendered in RGB; at wavelengths, the device has done it. Applies the film's sensor, white balance, sensitivity and exposure time (spectra/sensor.h) to the color of an image of light, and to
/// its variance with the pixel's luminance. The image stays in linear sRGB whatever colour space the film names, which only decides
/// what is white.
void expose(FilmImage& image, const FilmDescription& film);

}  // namespace eikonal
