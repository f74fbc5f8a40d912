#pragma once
// The noise of a render, from several renders that differ in their seed alone: no reference, hence no error of a reference.

#include "image/film_image.h"

#include <array>
#include <vector>

namespace eikonal {

/// An estimate and the standard deviation of its own error.
struct Estimate { double value = 0, standardError = 0; };

/// Central moments of each channel of each pixel over the seeds, added up in double precision and in one pass (Pébay 2008): memory does not grow
/// with the number of seeds.
class SeedVariance {
public:
    static constexpr int leastSeeds = 4;   ///< that relativeVariance takes: a fourth moment says how sure it is

    /// Adds a render with another seed. Throws an Error (ExitCode::scene) if its size is not that of the first.
    void add(const FilmImage& image);
    int seeds() const { return count_; }

    /// relMSE of one render of these (film/relative_error.h) against what renders converge to: the mean over pixels and channels of the variance
    /// between seeds, unbiased, relative to `converged` or else to the mean of the seeds, which hides outliers: they raise what they are relative to.
    /// The standard error takes pixels for independent and channels for fully correlated. Needs leastSeeds. Throws an Error (ExitCode::scene) if `converged`
    /// has another size. `outliers`: the share of pixels, those with the most, that is left out of the sum, which is divided by all pixels still: where
    /// single bright paths decide, what is left can be compared with few seeds.
    Estimate relativeVariance(const FilmImage* converged = nullptr, double outliers = 0) const;

private:
    void checkSize(const FilmImage& image) const;
    struct MomentVariance { double value, squaredError; };   ///< both without bias, so that the squared error of a single one may be negative
    struct Moments {
        double mean = 0, m2 = 0, m3 = 0, m4 = 0;   ///< m: sums of powers of what a seed is off the mean
        void add(double value, int count);
        MomentVariance variance(int count) const;
    };
    int count_ = 0;
    std::vector<std::array<Moments, 3>> pixels_;
};

}  // namespace eikonal
