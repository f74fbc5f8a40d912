#pragma once
// Hits of light paths on the device, and the table of their paths (kernels/shade/cached_hits.clh).

#include "device/kernel.h"
#include "pack/cached_hits.h"

namespace eikonal {

/// Bytes on the device: room for the hits of a plan, and the table of their paths.
size_t plannedHitCacheBytes(const PackedScene& scene);

class HitCache {
public:
    /// Empty at first. Small for scenes that keep no hits. The context must outlive this object.
    HitCache(const Context& context, const PackedScene& scene);

    /// Whole passes that it has room for at a time; 0: the scene keeps no hits.
    unsigned mostPasses() const { return plan_.passes; }
    /// Where cache_hits appends, and what connect_hits and shade_connections read.
    const Bindings& bindings() const { return bindings_; }
    /// Forgets all hits. Enqueues.
    void clear();
    /// Waits for the device. Throws DeviceError if there were more hits than it has room for.
    void check() const;

private:
    const Context& context_;
    HitCachePlan plan_;
    Buffer records_, hits_, count_, last_;
    Bindings bindings_;
};

}  // namespace eikonal
