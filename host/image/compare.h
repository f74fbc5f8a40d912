#pragma once
// Differences between an image and a reference: the measures of the gallery's table and of the render tests.

#include "image/film_image.h"

#include <glm/glm.hpp>

#include <vector>

namespace eikonal {

/// The mean color of one block of pixels in both images.
struct BlockDifference {
    int x = 0, y = 0;                 ///< upper left pixel
    glm::dvec3 image{0}, reference{0};
    glm::dvec3 standardError{0};      ///< of image - reference
    glm::dvec3 negligible{0};         ///< invisible differences: a ten-thousandth of the reference's mean

    /// The difference of the worst channel, in units of the tolerance: |image - reference| / (relative * |reference| + sigmas *
    /// standardError + negligible). At most 1: they agree. With a tolerance of 0, equal values count 0 and others infinity.
    double distance(double relative, double sigmas) const;
};

struct Comparison {
    glm::dvec3 mean{0}, referenceMean{0};   ///< of each channel, over the pixels that both images have
    double relativeMse = 0;  ///< relMSE: mean of relativeSquare (image/relative_error.h) over pixels and channels
    double trimmedRelativeMse = 0;   ///< the same without the worst thousandth of the pixels (at least one, if there are several)
    std::vector<BlockDifference> blocks;    ///< row by row; those at the right and the bottom may be smaller
    long long invalid = 0;                  ///< pixels that are not finite in the image or the reference; skipped everywhere

    /// The largest |mean / referenceMean - 1| of the three channels; 0 for a channel that is black in both, infinity if only in the
    /// reference.
    double worstMean() const;
    /// The block with the largest distance. There is at least one block.
    const BlockDifference& worstBlock(double relative, double sigmas) const;
};

/// The pixels that both images have. Throws Error (ExitCode::scene) if the sizes differ or no pixel is shared.
PixelBounds sharedPixels(const FilmImage& image, const FilmImage& reference);

/// Compares the pixels that both images have. Standard errors come from the images' variances; a channel's share is proportional to its
/// brightness. A reference without variances is taken to be as noisy as the image. If the image has none, standard errors are estimated
/// from the spread of the pixel differences within the block, which also contains real differences that vary between pixels. Throws Error
/// (ExitCode::scene) if the sizes differ or no pixel is shared.
Comparison compare(const FilmImage& image, const FilmImage& reference, int blockSize = 8);

}  // namespace eikonal
