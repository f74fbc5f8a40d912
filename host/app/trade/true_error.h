#pragma once
// The true error of a render, from renders with several seeds and two independent references.

#include "image/film_image.h"

#include <span>
#include <vector>

namespace eikonal {

/// An estimate with a 95 % confidence interval.
struct Interval {
    double value = 0, low = 0, high = 0;
};

/// Two independent converged images of the same expectation. A product (a - first)(a - second) has the expectation of the squared error of
/// `a` itself: their noise cancels.
struct References {
    FilmImage first, second;
    /// The mean of both.
    FilmImage mean() const;
    /// The relative error of mean(), a root of relMSE, and that of one of them: how far they are from each other.
    double relativeError() const;
};

/// Sums over renders of one setting that differ in their seeds, for each channel of each pixel (Welford 1962).
struct SeedSums {
    int seeds = 0;
    FilmImage mean;                  ///< of the renders
    std::vector<glm::vec3> squares;  ///< sums of squared deviations from the mean
    void add(const FilmImage& image);
};

/// The error of one render of a setting. Squares are relative (image/relative_error.h, with references.mean() as the reference).
struct TrueError {
    Interval square;           ///< relMSE: biasSquare + variance
    Interval biasSquare;       ///< may be negative, by noise
    double variance = 0;       ///< between seeds
    double concentration = 0;  ///< the share of it in the thousandth of the pixels with the most, at least one pixel
    Interval energy;           ///< mean of the image over that of the reference, - 1
    double chanceOfBias = 1;   ///< of a biasSquare so large, or an energy so different, by noise alone: small if the setting is biased
};

/// (image - first)(image - second), relative, averaged over pixels and channels: an unbiased estimate of the image's relMSE.
double squaredErrorOf(const FilmImage& image, const References& references);

/// `squaredErrors`: squaredErrorOf each of the renders in `sums`, which are at least 2. `means`: the mean of each over pixels and channels.
/// Throws an Error (ExitCode::scene) if sizes differ. Intervals treat pixels as independent given the seeds.
TrueError estimateTrueError(const SeedSums& sums, std::span<const double> squaredErrors, std::span<const double> means,
                            const References& references);

/// The mean over pixels and channels.
double meanOf(const FilmImage& image);

}  // namespace eikonal
