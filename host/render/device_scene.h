#pragma once
// A packed scene in the memory of a device.

#include "device/kernel.h"
#include "pack/tables.h"
#include "render/implicit_doubts.h"
#include "render/stop_flag.h"

#include <map>
#include <string>
#include <vector>

namespace eikonal {

/// Every table as a buffer, bound under the table's name. On a CPU large tables are shared with the scene (Buffer::sharing), so the scene
/// must outlive this object unchanged.
class DeviceScene {
public:
    DeviceScene(const Context& context, const PackedScene& scene);
    const Bindings& bindings() const { return bindings_; }
    /// Replaces a table's elements.
    template <class Elements> void replace(const Context& context, const char* table, const Elements& elements) {
        Buffer& buffer = buffers_[table];
        buffer = Buffer::of<typename Elements::value_type>(context, elements, std::string("table ") + table);
        bindings_.set(table, buffer);
    }
    /// Read by every launch with bindings().
    const StopFlag& stopFlag() const { return stopFlag_; }
    size_t bytes() const { return bytes_; }
    /// What has been counted so far (kernels/shape/implicit.clh). Blocks.
    ImplicitDoubts implicitDoubts(const Context& context) const;
    /// Replaces the scene's settings by `frame` for later launches. Blocks.
    void setFrame(const Context& context, const settings& frame);

private:
    std::map<std::string, Buffer> buffers_;   ///< by table
    StopFlag stopFlag_;
    Bindings bindings_;
    size_t bytes_ = 0;
};

}  // namespace eikonal
