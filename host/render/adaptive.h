#pragma once
// Adaptive sampling: chooses the blocks of pixels that get more samples, by the variance of the samples so far.

#include "film/film.h"

#include <span>
#include <vector>

namespace eikonal {

/// Statistics of a block of pixels.
struct BlockNoise {
    unsigned samples = 0;   ///< per pixel
    unsigned pixels = 0;
    double variance = 0;    ///< mean squared error of the block's pixels, as the metric weights it, times `samples`
    double suspected = 0;   ///< standard deviation that sample counts are proportional to; at least sqrt(variance)
};

/// The expected relative squared error of the image: the mean over its pixels.
double expectedError(std::span<const BlockNoise> blocks);

/// Samples per pixel of each block that bring the expected squared error down to `target` at the least cost. The best counts are
/// proportional to the suspected standard deviation (Neyman 1934). Each is the block's samples times a power of two, or `most`. The squared
/// error of a block falls as samples^-decay.
std::vector<unsigned> planSamples(std::span<const BlockNoise> blocks, double target, unsigned most, double decay = 1);

/// Sets `suspected` of all blocks; a row has `across` blocks. A block that has missed rare bright paths has a low variance so far, and
/// would get too few samples and stay too dark. So a block's estimate is at least the mean of it and its neighbours, and at least half
/// the image's mean. This hardly changes where most of the error is (docs/adaptive.md).
void suspectNoise(std::span<BlockNoise> blocks, int across);

/// Plans the next pass from the film's contents alone, so decisions are deterministic.
class AdaptiveSampling {
public:
    /// samples: that the pixels of each block already have, block by block in rows; or, if it has one element, every pixel. most: per
    /// pixel.
    AdaptiveSampling(const PixelRect& rect, std::span<const unsigned> samples, unsigned most, double targetError, ErrorMetric metric);

    static constexpr BlockSize blockSize{4, 4};
    static constexpr unsigned firstSamples = 32;   ///< samples per pixel before the first decision

    /// The blocks that get more samples, and their sample ranges, which double their samples. Empty: the target is met, or all blocks have
    /// `most` samples.
    std::vector<Block> nextPass(const Film& film);

    /// Samples per pixel that each block has, or is getting in the pass that nextPass returned last.
    std::vector<unsigned> samples() const;
    double error() const { return error_; }                     ///< expected, at the last call of nextPass
    double plannedSamples() const { return plannedSamples_; }   ///< expected total over all pixels, at the last call of nextPass

private:
    PixelRect rect_;
    unsigned most_;
    ErrorMetric metric_;
    double targetError_, error_ = 0, plannedSamples_ = 0;
    int across_;
    std::vector<Block> blocks_;         ///< with the samples taken so far
};

}  // namespace eikonal
