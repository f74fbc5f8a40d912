#pragma once
// What a wave traces: samples of blocks of pixels.

#include "pack/tables.h"

#include <algorithm>
#include <vector>

namespace eikonal {

/// Of a block of pixels, as powers of two.
struct BlockSize {
    int log2Width = 0, log2Height = 0;
    int width() const { return 1 << log2Width; }
    int height() const { return 1 << log2Height; }
    unsigned pixels() const { return 1u << (log2Width + log2Height); }
};

/// How large blocks of at most `pixels` pixels should be to cover a rectangle with the fewest of them.
BlockSize chooseBlockSize(const PixelRect& rect, unsigned pixels);

/// Samples of the pixels of a block. What of it reaches beyond the pixels that are wanted stays empty.
struct Block {
    int x = 0, y = 0;                 ///< upper left pixel
    unsigned firstSample = 0, samples = 1;
    PixelRect within(const PixelRect& rect, BlockSize size) const {
        return {x, y, std::min(x + size.width(), rect.x1), std::min(y + size.height(), rect.y1)};
    }
};

/// Blocks of one size whose samples are traced together: a layer of the wave for each sample of a block.
struct Batch {
    BlockSize size;
    std::vector<Block> blocks;
    unsigned layers() const;
    unsigned paths() const { return layers() << (size.log2Width + size.log2Height); }
    unsigned pixels() const { return static_cast<unsigned>(blocks.size()) << (size.log2Width + size.log2Height); }
};

/// Deals blocks out in batches of at most so many paths, and no fewer while enough are left: the samples of a block may be parted, in their
/// order.
class Batches {
public:
    /// mostPaths: at least the pixels of a block.
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
