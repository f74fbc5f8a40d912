#pragma once
// A packed scene in the memory of a device.

#include "device/kernel.h"
#include "pack/tables.h"

#include <map>
#include <string>
#include <vector>

namespace eikonal {

/// Every table as a buffer, bound under the table's name. On a CPU large tables are where the scene has them (Buffer::sharing): it must
/// outlive this, unchanged.
class DeviceScene {
public:
    DeviceScene(const Context& context, const PackedScene& scene);
    const Bindings& bindings() const { return bindings_; }
    /// Gives a table other elements.
    template <class Elements> void replace(const Context& context, const char* table, const Elements& elements) {
        Buffer& buffer = buffers_[table];
        buffer = Buffer::of<typename Elements::value_type>(context, elements, std::string("table ") + table);
        bindings_.set(table, buffer);
    }
    size_t bytes() const { return bytes_; }
    /// From now on kernels see `frame` in place of the scene's settings. Waits until it is there.
    void setFrame(const Context& context, const settings& frame);

private:
    std::map<std::string, Buffer> buffers_;   ///< by table
    Bindings bindings_;
    size_t bytes_ = 0;
};

}  // namespace eikonal
