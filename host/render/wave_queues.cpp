#include "render/wave_queues.h"

#include <algorithm>

namespace eikonal {

unsigned mostPathsFor(const StageShape& shape, const Branching& branching) { return std::max(shape.wavePaths >> branching.forks, 1u); }

unsigned capacityFor(const StageShape& shape, const Branching& branching) {
    const unsigned rays = mostPathsFor(shape, branching) << branching.forks;
    return branching.branches * (shape.padded(rays) + hops * shape.group()) + shape.group();
}

std::vector<PlannedQueue> queuesFor(const Features& features, bool hasMisses, size_t capacity) {
    std::vector<PlannedQueue> list;
    for (QueueLayout layout : queueLayouts(features)) {
        if (layout.name == "hit") layout.words += bsdfWords(features);
        const bool unused = (layout.name == "scatter" && !features.has(Feature::MEDIA)) || (layout.name == "emission" && !features.has(Feature::EMITTERS)) ||
                            (layout.name == "miss" && !hasMisses);
        list.push_back({layout, unused ? 0 : capacity, layout.name});
        if (layout.name == "ray") list.push_back({layout, capacity, "next_ray"});
    }
    return list;
}

size_t plannedWaveBytes(const PackedScene& scene, const StageShape& shape) {
    size_t bytes = 0;
    for (const PlannedQueue& q : queuesFor(scene.features, scene.environments > 0, capacityFor(shape, Branching::of(scene))))
        bytes += q.items * static_cast<size_t>(q.layout.words) * sizeof(cl_uint);
    return bytes;
}

}  // namespace eikonal
