#pragma once
// A packed scene in the memory of a device.

#include "device/kernel.h"
#include "pack/tables.h"

#include <list>

namespace eikonal {

/// How many rays a camera path may be at once, and what may leave a surface: more than one only with trees of rays (kernels/tree.clh).
struct Branching {
    unsigned forks = 0;      ///< it may be 2^forks rays
    unsigned branches = 1;   ///< rays that may leave a surface
    unsigned turns = 1;     ///< of shading: one for each of those rays, and for each light that is looked at
    static Branching of(const PackedScene& scene);
};

/// Every table as a buffer, bound under the table's name. On a CPU large tables are where the scene has them (Buffer::sharing): it must outlive this, unchanged.
class DeviceScene {
public:
    DeviceScene(const Context& context, const PackedScene& scene);
    const Bindings& bindings() const { return bindings_; }
    size_t bytes() const { return bytes_; }
    Branching branching() const { return branching_; }

private:
    std::list<Buffer> buffers_;
    Bindings bindings_;
    size_t bytes_ = 0;
    Branching branching_;
};

}  // namespace eikonal
