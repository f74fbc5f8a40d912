#include "render/batch_tables.h"

namespace eikonal {

BatchTables::BatchTables(const Context& context) : layers_(context, 0, "layers of a wave"), ranges_(context, 0, "layers of blocks") {
    bindings_.set("batch_layers", layers_);
    bindings_.set("block_layers", ranges_);
    /* A single layer with no pixels */
    bindings_.set("layer_count", 1u);
    for (const char* name : {"block_log2_width", "block_log2_height", "end_x", "end_y"}) bindings_.set(name, 0u);
}

/// Enqueues writing `elements` into a buffer, enlarging it if necessary.
template <class T> static void replace(const Context& context, Buffer& buffer, const std::vector<T>& elements, const char* what) {
    const size_t bytes = elements.size() * sizeof(T);
    if (buffer.size() < bytes) buffer = Buffer(context, bytes, what);
    buffer.enqueueWrite(context, elements.data(), bytes);
}

void BatchTables::write(const Context& context, const Batch& batch, int endX, int endY) {
    hostLayers_.clear();
    hostRanges_.clear();
    for (const Block& b : batch.blocks) {
        hostRanges_.push_back({static_cast<uint>(hostLayers_.size()), b.samples});
        for (unsigned s = 0; s < b.samples; ++s)
            hostLayers_.push_back({static_cast<uint>(b.x), static_cast<uint>(b.y), b.firstSample + s});
    }
    replace(context, layers_, hostLayers_, "layers of a wave");
    replace(context, ranges_, hostRanges_, "layers of blocks");
    bindings_.set("batch_layers", layers_);
    bindings_.set("block_layers", ranges_);
    bindings_.set("layer_count", static_cast<cl_uint>(hostLayers_.size()));
    bindings_.set("block_log2_width", static_cast<cl_uint>(batch.size.log2Width));
    bindings_.set("block_log2_height", static_cast<cl_uint>(batch.size.log2Height));
    bindings_.set("end_x", static_cast<cl_uint>(endX));
    bindings_.set("end_y", static_cast<cl_uint>(endY));
}

}  // namespace eikonal
