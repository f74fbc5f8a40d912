#pragma once
// Pictures of a report, as PNG in data: URLs.

#include "image/film_image.h"
#include "image/tone_map.h"

#include <string>

namespace eikonal {

/// The exposure in stops at which an image of this mean is well lit; 0 if it is as it stands.
double exposureFor(double mean);
/// The image as `render` writes it into a PNG.
std::string picture(const FilmImage& image, const ToneMapping& mapping);
/// An image whose colours are stored values in [0, 1] already.
std::string storedPicture(const FilmImage& image);
/// image - reference, of luminance and relative to the reference's local value: grey where both agree, red where the image is brighter,
/// blue where it is darker. Full colour at a difference of `range`.
std::string differencePicture(const FilmImage& image, const FilmImage& reference, double range);

}  // namespace eikonal
