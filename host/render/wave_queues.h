#pragma once
// Which queues a wave has, and how large they are.

#include "device/layout.h"
#include "render/device_scene.h"
#include "render/stages.h"

#include <string>
#include <vector>

namespace eikonal {

/// How many paths a wave may have: fewer where each is several rays.
unsigned mostPathsFor(const StageShape& shape, const Branching& branching);

/// Room for every ray of every path, for the segments of the hit queue to begin at multiples of a group, as often as rays may leave a
/// surface; and for paths that nobody has.
unsigned capacityFor(const StageShape& shape, const Branching& branching);

struct PlannedQueue { QueueLayout layout; size_t items; std::string name; };

/// Every queue of a wave; those that nothing fills hold no items.
std::vector<PlannedQueue> queuesFor(const Features& features, bool hasMisses, size_t capacity);

/// What Wave::bytes() will be, before anything is allocated.
size_t plannedWaveBytes(const PackedScene& scene, const StageShape& shape);

}  // namespace eikonal
