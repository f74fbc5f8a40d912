#pragma once
// A batch as kernels see it.

#include "device/kernel.h"
#include "film/batch.h"

namespace eikonal {

/// A batch as kernels see it.
class BatchTables {
public:
    /// Of nothing.
    explicit BatchTables(const Context& context);
    /// Replaces what kernels saw before, and waits for those that are to see it. endX, endY: no pixel from there on.
    void write(const Context& context, const Batch& batch, int endX, int endY);
    const Bindings& bindings() const { return bindings_; }

private:
    Buffer layers_, ranges_;
    Bindings bindings_;
};

}  // namespace eikonal
