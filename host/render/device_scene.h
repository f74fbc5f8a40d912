#pragma once
// A packed scene in the memory of a device.

#include "device/kernel.h"
#include "pack/tables.h"

#include <map>
#include <string>
#include <vector>

namespace eikonal {

/// How many rays a camera path may be at once, and what may leave a surface: more than one only with trees of rays (kernels/shade/ray_splitting.clh).
struct RaySplitting {
    unsigned splits = 0;         ///< a camera path may be 2^splits rays
    unsigned raysPerHit = 1;      ///< rays that may leave a surface
    unsigned shadingPasses = 1;  ///< one for each of those rays, and for each light that is looked at
    static RaySplitting of(const PackedScene& scene);
};

/// Every table as a buffer, bound under the table's name. On a CPU large tables are where the scene has them (Buffer::sharing): it must outlive this, unchanged.
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
    RaySplitting splitting() const { return splitting_; }

private:
    std::map<std::string, Buffer> buffers_;   ///< by table
    Bindings bindings_;
    size_t bytes_ = 0;
    RaySplitting splitting_;
};

}  // namespace eikonal
