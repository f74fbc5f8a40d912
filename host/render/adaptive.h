#pragma once
// Adaptive sampling: which blocks of pixels get more samples, by how much those that they have vary.

#include "film/film.h"

#include <span>
#include <vector>

namespace eikonal {

/// What is known about a block of pixels.
struct BlockNoise {
    unsigned samples = 0;   ///< of each pixel
    unsigned pixels = 0;
    double variance = 0;    ///< relative, of one sample: what the relative squared error of a pixel would be with a single one, on average
    double suspected = 0;   ///< the standard deviation that samples are given for: not below the root of that
};

/// The relative squared error that is to be expected of an image: the mean over its pixels.
double expectedError(std::span<const BlockNoise> blocks);

/// How many samples each block should have so that the expected error is no more than `target` (squared) at the least cost, but at most
/// `most`: the error falls fastest where samples are in proportion to the (suspected) standard deviation (Neyman 1934). A block has what it
/// has times a power of two, or `most`.
std::vector<unsigned> planSamples(std::span<const BlockNoise> blocks, double target, unsigned most);

/// Sets what is suspected of blocks in rows of `across`. A block that has not met its brightest light yet seems quiet, and would be left
/// with too few samples, and too dark. So none is taken for quieter than it and those around it are on average, nor than half the average
/// of the image. (Where most of the error is hardly changes by that: docs/adaptive.md.)
void suspectNoise(std::span<BlockNoise> blocks, int across);

/// Decides about the pixels of a film after each pass, from what the film holds alone: same samples, same decisions.
class AdaptiveSampling {
public:
    /// Every pixel has `samples` and may have `most`. targetError: the square root of the relative squared error to come down to.
    AdaptiveSampling(const PixelRect& rect, unsigned samples, unsigned most, double targetError);

    static constexpr BlockSize blockSize{4, 4};
    static constexpr unsigned firstSamples = 16;   ///< before which a pixel's variance says too little

    /// The blocks that get more samples, and which: as many again as they have. None: the error is small enough, or nothing is left to be
    /// done.
    std::vector<Block> nextPass(const Film& film);

    double error() const { return error_; }                     ///< expected, at the last call of nextPass; a square root like targetError
    double plannedSamples() const { return plannedSamples_; }   ///< of all pixels in the end, as expected at the last call of nextPass

private:
    PixelRect rect_;
    unsigned most_;
    double targetError_, error_ = 0, plannedSamples_ = 0;
    int across_;
    std::vector<Block> blocks_;         ///< samples: those that they have
};

}  // namespace eikonal
