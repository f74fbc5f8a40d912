#include "film/batch.h"

#include "film/sample_nodes.h"

#include <bit>
#include <cstdlib>

namespace eikonal {

BlockSize chooseBlockSize(const PixelRect& rect, unsigned pixels) {
    const int total = std::bit_width(std::max(pixels, 1u)) - 1;
    BlockSize best{total / 2, total - total / 2};
    long fewest = -1;
    int squarest = 0;
    for (int w = 0; w <= total; ++w) {
        const int h = total - w;
        const long across = (rect.width() + (1L << w) - 1) >> w, down = (rect.height() + (1L << h) - 1) >> h;
        const long blocks = across * down;
        if (fewest < 0 || blocks < fewest || (blocks == fewest && std::abs(w - h) < squarest)) {
            fewest = blocks;
            squarest = std::abs(w - h);
            best = {w, h};
        }
    }
    return best;
}

unsigned Batch::layers() const {
    unsigned sum = 0;
    for (const Block& b : blocks) sum += b.samples;
    return sum;
}

Batches::Batches(BlockSize size, std::vector<Block> blocks, unsigned mostPaths)
    : size_(size), blocks_(std::move(blocks)), mostLayers_(std::max(mostPaths / size.pixels(), 1u)) {}

Batch Batches::next() {
    Batch batch{size_, {}};
    for (unsigned room = mostLayers_; room > 0 && !empty();) {
        Block& left = blocks_[at_];
        const unsigned taken = std::min({left.samples, room, leafEnd(left.firstSample) - left.firstSample});
        batch.blocks.push_back({left.x, left.y, left.firstSample, taken});
        left.firstSample += taken;
        left.samples -= taken;
        room -= taken;
        if (left.samples == 0) ++at_;
    }
    return batch;
}

}  // namespace eikonal
