#pragma once
// Vertices of light paths on the device, and the hash grid that finds those near a point (kernels/shade/light_vertices.clh).

#include "device/layout.h"
#include "pack/light_vertices.h"
#include "pack/merge_radius.h"
#include "render/stage_launcher.h"

namespace eikonal {

/// Bytes on the device: room for the vertices of a plan, and their grid.
size_t plannedVertexBytes(const PackedScene& scene);

class VertexGrid {
public:
    /// Empty at first. Small for scenes whose vertices do not merge. The context must outlive this object.
    VertexGrid(const Context& context, const PackedScene& scene);

    /// Whole passes that it has room for at a time; 0: the scene merges no vertices.
    unsigned mostPasses() const { return plan_.passes; }
    /// Where store_vertices appends, and what merge_vertices reads.
    const Bindings& bindings() const { return bindings_; }
    /// Forgets all vertices. Enqueues.
    void clear();
    /// Where the vertices lie that have been stored since clear(), in no order. Blocks.
    SurfacePoints stored() const;
    /// Builds the grid of the vertices that have been stored since clear(). Waits for the device.
    void build(const Stages& stages, const StageLauncher& launcher);

private:
    /// How many have been stored; throws a DeviceError if that is more than there is room for.
    uint countStored() const;

    const Context& context_;
    VertexPlan plan_;
    QueueLayout layout_;
    Buffer vertices_, count_, grid_;
    Bindings bindings_;
};

}  // namespace eikonal
