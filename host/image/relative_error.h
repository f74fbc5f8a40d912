#pragma once
// The error measure relMSE: squared error relative to the reference, independent of exposure.

namespace eikonal {

/// square / (reference^2 + 0.01 mean^2): the relative squared error of one channel of a pixel. `mean` is the mean of the reference over
/// pixels and channels; it keeps nearly black pixels from dominating (after Rousselle et al. 2011, whose images have a mean of order 1). A
/// square of 0 gives 0, also in a black image.
inline double relativeSquare(double square, double reference, double mean) {
    return square == 0 ? 0 : square / (reference * reference + 0.01 * mean * mean);
}

}  // namespace eikonal
