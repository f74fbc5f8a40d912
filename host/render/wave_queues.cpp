#include "render/wave_queues.h"

#include <algorithm>
#include <bit>

namespace eikonal {

WaveSize::WaveSize(const StageShape& shape, const RaySplitting& splitting) {
    paths = std::max(shape.wavePaths >> splitting.splits, 1u);
    batches = splitting.splits ? 1 : shape.batches;
    log2BatchPaths = static_cast<unsigned>(std::bit_width(shape.padded(paths) - 1));
    capacity = splitting.raysPerHit * (shape.padded(paths << splitting.splits) + next_queues * shape.group()) + shape.group();
    pathCapacity = (batches << (log2BatchPaths + splitting.splits)) + shape.group();
}

std::vector<PlannedQueue> queuesFor(const Features& features, bool hasMisses, const WaveSize& size) {
    std::vector<PlannedQueue> list;
    for (QueueLayout layout : queueLayouts(features)) {
        if (layout.name == "hit") layout.words += bsdfWords(features);
        const bool unused = (layout.name == "scatter" && !features.has(Feature::MEDIA)) || (layout.name == "emission" && !features.has(Feature::EMITTERS)) ||
                            (layout.name == "miss" && !hasMisses) || (layout.name == "walk" && !features.has(Feature::LAYERS));
        const size_t items = layout.name == "path" ? size.pathCapacity : size.capacity;
        list.push_back({layout, unused ? 0 : items, layout.name});
        if (layout.name == "ray") list.push_back({layout, items, "next_ray"});
    }
    return list;
}

size_t plannedWaveBytes(const PackedScene& scene, const StageShape& shape) {
    size_t bytes = 0;
    for (const PlannedQueue& q : queuesFor(scene.features, scene.constants.environments > 0, WaveSize(shape, RaySplitting::of(scene))))
        bytes += q.items * static_cast<size_t>(q.layout.words) * sizeof(cl_uint);
    return bytes;
}

}  // namespace eikonal
