#pragma once
// Batches: the samples of blocks of pixels that a wave traces together.

#include "pack/tables.h"

#include <algorithm>
#include <vector>

namespace eikonal {

/// Log2 of the width and height of a block of pixels.
struct BlockSize {
    int log2Width = 0, log2Height = 0;
    int width() const { return 1 << log2Width; }
    int height() const { return 1 << log2Height; }
    unsigned pixels() const { return 1u << (log2Width + log2Height); }
};

/// The shape of blocks of at most `pixels` pixels that covers a rectangle with the fewest blocks.
BlockSize chooseBlockSize(const PixelRect& rect, unsigned pixels);

/// A block of pixels and a range of their samples. Pixels outside the rendered rectangle get no samples.
struct Block {
    int x = 0, y = 0;                 ///< upper left pixel
    unsigned firstSample = 0, samples = 1;
    PixelRect within(const PixelRect& rect, BlockSize size) const {
        return {x, y, std::min(x + size.width(), rect.x1), std::min(y + size.height(), rect.y1)};
    }
};

/// Blocks of one size that are traced together. Each sample of a block is a layer of paths.
struct Batch {
    BlockSize size;
    std::vector<Block> blocks;
    unsigned layers() const;
    unsigned paths() const { return layers() << (size.log2Width + size.log2Height); }
    unsigned pixels() const { return static_cast<unsigned>(blocks.size()) << (size.log2Width + size.log2Height); }
};

/// Groups blocks into batches with as many paths as possible, at most `mostPaths`. The samples of a block are split into leaves
/// (sample_nodes.h), which may be split over consecutive batches, in order.
class Batches {
public:
    /// mostPaths must be at least the number of pixels of a block.
    Batches(BlockSize size, std::vector<Block> blocks, unsigned mostPaths);
    bool empty() const { return at_ == blocks_.size(); }
    Batch next();

private:
    BlockSize size_;
    std::vector<Block> blocks_;
    unsigned mostLayers_;
    size_t at_ = 0;
};

}  // namespace eikonal
