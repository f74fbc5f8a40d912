#pragma once
// The noise of a render, estimated from renders with different seeds, without a reference and its error.

#include "image/film_image.h"

#include <array>
#include <vector>

namespace eikonal {

/// An estimate and its standard error.
struct Estimate { double value = 0, standardError = 0; };

/// Central moments over seeds, for each channel of each pixel, accumulated in one pass in double precision (Pébay 2008): memory does not
/// grow with the number of seeds.
class SeedVariance {
public:
    static constexpr int leastSeeds = 4;   ///< for relativeVariance, which needs fourth moments for its standard error

    /// Adds a render with another seed. Throws an Error (ExitCode::scene) if its size differs from the first.
    void add(const FilmImage& image);
    int seeds() const { return count_; }

    /// relMSE (image/relative_error.h) of one of these renders against what they converge to: the unbiased variance between seeds, relative
    /// to `converged` or else to the mean of the seeds, averaged over pixels and channels. The mean of the seeds hides outliers, because
    /// they raise the value that they are relative to. The standard error treats pixels as independent and channels as fully correlated.
    /// Needs leastSeeds renders. `outliers`: the share of pixels with the largest terms that is dropped from the sum (the divisor stays the
    /// number of all pixels); it makes results comparable with few seeds if single bright paths dominate. Throws an Error (ExitCode::scene)
    /// if `converged` has another size.
    Estimate relativeVariance(const FilmImage* converged = nullptr, double outliers = 0) const;

private:
    void checkSize(const FilmImage& image) const;
    struct MomentVariance { double value, squaredError; };   ///< both unbiased, so the squared error of one value may be negative
    struct Moments {
        double mean = 0, m2 = 0, m3 = 0, m4 = 0;   ///< m2 to m4: sums of powers of the deviations from the mean
        void add(double value, int count);
        MomentVariance variance(int count) const;
    };
    int count_ = 0;
    std::vector<std::array<Moments, 3>> pixels_;
};

}  // namespace eikonal
