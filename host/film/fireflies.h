#pragma once
// Fireflies: samples that are far brighter than all around them, since few paths find the light that they bring.

#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

namespace eikonal {

/// The bands of brightness of a film (include/eikonal/film.h).
struct BrightnessBands {
    std::size_t width, height;     ///< pixels
    const float* sums;             ///< component c of band k of pixel i: sums[((2 * k) * 3 + c) * width * height + i]
    const float* weights;          ///< of each pixel: what the sums are divided by for a mean
};

/// What re-weighting takes from the mean of each pixel (Zirr, Hanika and Dachsbacher 2018, "Re-Weighting Firefly Samples for Improved
/// Finite-Sample Monte Carlo Estimates"): the light of a band counts as far as several samples of its brightness are found in the 3 x 3
/// pixels around, or as far as a single one would not show. Consistent: with more samples, every brightness that has a share of the light
/// is found often enough.
std::vector<glm::vec3> firefliesIn(const BrightnessBands& bands);

/// The share of an image's light that `fireflies` holds, in [0, 1], by luminance. Both have one entry per pixel; color lacks that light.
double firefliesShare(const std::vector<glm::vec3>& fireflies, const std::vector<glm::vec3>& color);

}  // namespace eikonal
