#pragma once
// Which queues a wave has, and how large they are.

#include "device/layout.h"
#include "render/device_scene.h"
#include "render/stages.h"

#include <string>
#include <vector>

namespace eikonal {

/// For how much there is room in a wave.
struct WaveSize {
    unsigned paths;            ///< that begin at once, and of a batch: fewer where each is several rays
    unsigned batches;          ///< in flight at once: one where a path is several rays
    unsigned log2BatchPaths;   ///< from the first path of a batch to that of the next
    unsigned capacity;         ///< of queues: every ray of every path, segments that begin at multiples of a group, as often as rays may leave a surface
    unsigned pathCapacity;     ///< the states of paths of all batches, and those that nobody has
    WaveSize(const StageShape& shape, const RaySplitting& splitting);
};

struct PlannedQueue { QueueLayout layout; size_t items; std::string name; };

/// Every queue of a wave; those that nothing fills hold no items.
std::vector<PlannedQueue> queuesFor(const Features& features, bool hasMisses, const WaveSize& size);

/// What Wave::bytes() will be, before anything is allocated.
size_t plannedWaveBytes(const PackedScene& scene, const StageShape& shape);

}  // namespace eikonal
