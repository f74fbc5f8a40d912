#pragma once
// The film's fields that estimate a pixel and its noise.

#include "color/luminance.h"
#include "film/totals.h"

#include <algorithm>
#include <limits>

namespace eikonal {

/// Estimates of a pixel, and their variance.
struct FilmTotals::Planes {
    size_t n;
    const float *sum, *weight, *squareWeight, *mean, *spread, *halfSquare, *quarterSquare, *eighthSquare, *lowMean;
    const uint* count;
    const glm::vec3* splats;        // null: no light paths
    const float* splatVariances;

    explicit Planes(const FilmTotals& f)
        : n(f.plane()),
          sum(f.floats("sum")),
          weight(f.floats("weight")),
          squareWeight(f.floats("square_weight")),
          mean(f.floats("mean")),
          spread(f.floats("spread")),
          halfSquare(f.floats("half_square")),
          quarterSquare(f.floats("quarter_square")),
          eighthSquare(f.floats("eighth_square")),
          lowMean(f.floats("low_mean")),
          count(f.numbers("count")),
          splats(f.splatColors_.empty() ? nullptr : f.splatColors_.data()),
          splatVariances(f.splatVariances_.data()) {}

    glm::vec3 color(size_t i) const {
        const glm::vec3 found = glm::vec3(sum[i], sum[n + i], sum[2 * n + i]) * (weight[i] != 0 ? 1 / weight[i] : 0);
        return splats ? found + splats[i] : found;
    }
    /// Luminance without the brightest quarter of the camera's samples.
    double low(size_t i) const { return splats ? lowMean[i] + luminance(splats[i]) : lowMean[i]; }
    /// Variance of what light paths add to a pixel's luminance.
    double splatVariance(size_t i) const { return splats ? splatVariances[i] : 0; }

    /// Variance of a pixel's mean luminance if its samples were independent; of the camera's, 0 if there are too few.
    /* The mean is a ratio of two sums, sum(w L) / sum(w): its variance is that of sum(w (L - mean)), over the square of sum(w). */
    float variance(size_t i, glm::vec3 color) const {
        const double samples = count[i], weights = weight[i];
        if (samples < 2 || weights == 0) return static_cast<float>(splatVariance(i));
        const double aside = luminance(color) - (splats ? luminance(splats[i]) : 0) - mean[i];
        const double spreads = std::max(spread[i], 0.0f) + squareWeight[i] * aside * aside;
        return static_cast<float>(
            std::min(spreads * samples / (samples - 1) / (weights * weights) + splatVariance(i),
                     static_cast<double>(std::numeric_limits<float>::max())));
    }
};

}  // namespace eikonal
