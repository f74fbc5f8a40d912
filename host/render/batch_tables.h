#pragma once
// The tables that describe a batch to kernels.

#include "device/kernel.h"
#include "eikonal/batch.h"
#include "film/batch.h"

namespace eikonal {

/// The tables of one batch on the device.
class BatchTables {
public:
    /// An empty batch.
    explicit BatchTables(const Context& context);
    /// Enqueues replacing the batch, whose paths must have ended: its tables are written then.
    /// endX, endY: pixels from there on are outside the image.
    void write(const Context& context, const Batch& batch, int endX, int endY);
    const Bindings& bindings() const { return bindings_; }

private:
    std::vector<layer> hostLayers_;          ///< these two are written in queue order, so they stay
    std::vector<layer_range> hostRanges_;
    Buffer layers_, ranges_;
    Bindings bindings_;
};

}  // namespace eikonal
