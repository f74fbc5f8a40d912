#pragma once
// How far an image is from a reference: the numbers of the gallery's table and of the render tests.

#include "image/film_image.h"

#include <glm/glm.hpp>

#include <vector>

namespace eikonal {

/// The mean color of one block of pixels in both images.
struct BlockDifference {
    int x = 0, y = 0;                 ///< its upper left pixel
    glm::dvec3 image{0}, reference{0};
    glm::dvec3 standardError{0};      ///< of image - reference
    glm::dvec3 negligible{0};         ///< what no eye sees beside the rest: a ten-thousandth of the reference's mean

    /// How far the worst channel is off, in units of what is allowed: |image - reference| / (relative * |reference| + sigmas *
    /// standardError + negligible). Up to 1 it agrees; what is equal counts 0, also where nothing is allowed, what is not is infinite there.
    double distance(double relative, double sigmas) const;
};

struct Comparison {
    glm::dvec3 mean{0}, referenceMean{0};   ///< of each channel, over the pixels that both have
    double relativeMse = 0;  ///< relMSE: mean of relativeSquare (film/relative_error.h) over pixels and channels
    std::vector<BlockDifference> blocks;    ///< row by row; those at the right and the bottom may be smaller
    long long invalid = 0;                  ///< pixels that are not finite in the image or in the reference; left out of everything

    /// The largest |mean / referenceMean - 1| of the three channels; a channel that is black in both counts 0, in one only infinity.
    double worstMean() const;
    /// The block with the largest distance. There is at least one block.
    const BlockDifference& worstBlock(double relative, double sigmas) const;
};

/// Compares the pixels that both images have. Standard errors come from the variances that an image carries, a channel's share being
/// that of its brightness; a reference without variances is taken to be as noisy as the image. Where the image has none either they are
/// estimated from the scatter of the pixels' differences within the block, which a difference that varies from pixel to pixel adds to. Throws Error (ExitCode::scene) if the images differ in size or share no pixel.
Comparison compare(const FilmImage& image, const FilmImage& reference, int blockSize = 8);

}  // namespace eikonal
