#include "render/batch.h"

#include "eikonal/batch.h"

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
        const unsigned taken = std::min(left.samples, room);
        batch.blocks.push_back({left.x, left.y, left.firstSample, taken});
        left.firstSample += taken;
        left.samples -= taken;
        room -= taken;
        if (left.samples == 0) ++at_;
    }
    return batch;
}

BatchTables::BatchTables(const Context& context) : layers_(context, 0, "layers of a wave"), ranges_(context, 0, "layers of blocks") {
    bindings_.set("batch_layers", layers_);
    bindings_.set("block_layers", ranges_);
    /* One layer, no pixel */
    bindings_.set("layer_count", 1u);
    for (const char* name : {"block_log2_width", "block_log2_height", "end_x", "end_y"}) bindings_.set(name, 0u);
}

/// Into a buffer that grows as it must.
template <class T> static void replace(const Context& context, Buffer& buffer, const std::vector<T>& elements, const char* what) {
    const size_t bytes = elements.size() * sizeof(T);
    if (buffer.size() < bytes) buffer = Buffer(context, bytes, what);
    buffer.write(context, elements.data(), bytes);
}

void BatchTables::write(const Context& context, const Batch& batch, int endX, int endY) {
    std::vector<layer> layers;
    std::vector<layer_range> ranges;
    for (const Block& b : batch.blocks) {
        ranges.push_back({static_cast<uint>(layers.size()), b.samples});
        for (unsigned s = 0; s < b.samples; ++s) layers.push_back({static_cast<uint>(b.x), static_cast<uint>(b.y), b.firstSample + s});
    }
    replace(context, layers_, layers, "layers of a wave");
    replace(context, ranges_, ranges, "layers of blocks");
    bindings_.set("batch_layers", layers_);
    bindings_.set("block_layers", ranges_);
    bindings_.set("layer_count", static_cast<cl_uint>(layers.size()));
    bindings_.set("block_log2_width", static_cast<cl_uint>(batch.size.log2Width));
    bindings_.set("block_log2_height", static_cast<cl_uint>(batch.size.log2Height));
    bindings_.set("end_x", static_cast<cl_uint>(endX));
    bindings_.set("end_y", static_cast<cl_uint>(endY));
}

}  // namespace eikonal
