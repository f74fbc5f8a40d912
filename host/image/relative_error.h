#pragma once
// relMSE, by which images are measured: squared errors relative to what a pixel should be, whatever the exposure.

namespace eikonal {

/// square / (reference^2 + 0.01 mean^2): the squared error of one channel of a pixel, as a share of the reference's value there. `mean` is that
/// of the reference, over its pixels and channels; it keeps what is nearly black from deciding alone (after Rousselle et al. 2011, whose images
/// have a mean of order 1). An error of 0 is 0, also where all is black.
inline double relativeSquare(double square, double reference, double mean) {
    return square == 0 ? 0 : square / (reference * reference + 0.01 * mean * mean);
}

}  // namespace eikonal
