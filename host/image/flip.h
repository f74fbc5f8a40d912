#pragma once
// FLIP: how different two images look when they are shown in turn (Andersson et al. 2020, "FLIP: A Difference Evaluator for Alternating
// Images"; the measure for images of a display's range).

#include "image/film_image.h"
#include "image/tone_map.h"

#include <glm/glm.hpp>

#include <vector>

namespace eikonal {

/// The paper's observer: 0.7 m from a display 0.7 m wide with 3840 pixels.
constexpr double flipPixelsPerDegree = 67.02;

struct Flip {
    double mean = 0;         ///< over the pixels; 0: equal, 0.967: black against white
    std::vector<float> map;  ///< of each pixel, in [0, 1], row by row
};

/// FLIP of two images of sRGB values in [0, 1], `width` x `height` pixels row by row. Pixels beyond an edge repeat the edge.
Flip flip(const std::vector<glm::vec3>& test, const std::vector<glm::vec3>& reference, int width, int height,
          double pixelsPerDegree = flipPixelsPerDegree);

/// FLIP of the pixels that both images have, each tone-mapped by `mapping`. Throws Error (ExitCode::scene) if the sizes differ or no pixel
/// is shared.
Flip flip(const FilmImage& test, const FilmImage& reference, const ToneMapping& mapping = {});
std::vector<float> flipMap(const FilmImage& test, const FilmImage& reference, const ToneMapping& mapping = {});
double flipMean(const FilmImage& test, const FilmImage& reference, const ToneMapping& mapping = {});

/// The magma colour, in sRGB, of a value in [0, 1]; values beyond are clamped.
glm::vec3 heatColor(float value);

}  // namespace eikonal
