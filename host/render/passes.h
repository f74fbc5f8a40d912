#pragma once
// Passes: blocks of the image and the samples that they get next.

#include "film/film.h"

#include <span>
#include <vector>

namespace eikonal {

struct Pass {
    BlockSize size;
    std::vector<Block> blocks;
    unsigned samples = 0;       ///< samples that it adds to every pixel
};

/// The next pass over all pixels, which have the samples `done`, up to `end`: first as few samples as fill a wave, then about as many as
/// are already done, so that a complete image exists early and later waves are coherent. Powers of two, so that leaves are seldom begun
/// (film/sample_nodes.h).
Pass uniformPass(const PixelRect& rect, SampleRange done, unsigned end, unsigned mostPaths);

/// A pass with the blocks split until each fits a wave of mostPaths paths.
Pass cutBlocks(const std::vector<Block>& blocks, BlockSize size, const PixelRect& rect, unsigned mostPaths);

/// What brings the pixels of a film that was stored in the middle of a pass to the end of that pass: each pixel of block i (of `size`, in
/// rows from the upper left corner of the film) to samples[i] samples; if `samples` has one element, all pixels to that.
std::vector<Pass> missingPasses(const Film& film, std::span<const unsigned> samples, BlockSize size, unsigned mostPaths);

}  // namespace eikonal
