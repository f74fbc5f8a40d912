#pragma once
// A packed scene in the memory of a device.

#include "device/kernel.h"
#include "pack/tables.h"

#include <list>

namespace eikonal {

/// Every table as a buffer, bound under the table's name.
class DeviceScene {
public:
    DeviceScene(const Context& context, const PackedScene& scene);
    const Bindings& bindings() const { return bindings_; }
    size_t bytes() const { return bytes_; }
    /// Most scattering events on a path.
    unsigned maxDepth() const { return maxDepth_; }

private:
    std::list<Buffer> buffers_;
    Bindings bindings_;
    size_t bytes_ = 0;
    unsigned maxDepth_;
};

}  // namespace eikonal
