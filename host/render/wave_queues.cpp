#include "render/wave_queues.h"

#include <bit>

namespace eikonal {

WaveSize::WaveSize(const StageShape& shape, const RaySplitting& splitting) {
    paths = splitting.pathsIn(shape.wavePaths);
    batches = splitting.batches(shape.batches);
    log2BatchStates = static_cast<unsigned>(std::bit_width(shape.padded(paths) - 1)) + splitting.splits;
    slots = shape.padded(paths);
    leastRoom = splitting.leastRoom(slots);
    capacity = splitting.raysPerHit * (shape.padded(splitting.statesOf(paths)) + next_queues * shape.group()) + shape.group();
    pathCapacity = (batches << log2BatchStates) + shape.group();
}

unsigned WaveSize::room(unsigned taken) const {
    const unsigned left = slots - std::min(taken, slots);
    return left < leastRoom ? 0 : left;
}

QueueLayout itemLayout(Queue queue, const Features& features, const SceneConstants& constants) {
    QueueLayout layout = queueLayouts(features)[static_cast<size_t>(queue == Queue::next_ray ? Queue::ray : queue)];
    if (queue == Queue::hit) layout.words += bsdfWords(features);
    if (queue == Queue::path) layout.words += constants.lightGroups * layout.field("L").words;
    return layout;
}

std::vector<PlannedQueue> planQueues(const Features& features, const SceneConstants& constants, const WaveSize& size) {
    std::vector<PlannedQueue> queues;
    for (const QueueRow& row : queueTable) {
        const bool required = row.requirement.isMet(features, constants);
        queues.push_back({row.id, itemLayout(row.id, features, constants), required ? size.items(row.placement) : 0});
    }
    return queues;
}

size_t plannedWaveBytes(const PackedScene& scene, const StageShape& shape) {
    size_t bytes = 0;
    const WaveSize size(shape, RaySplitting::of(scene));
    for (const PlannedQueue& queue : planQueues(scene.features, scene.constants, size)) bytes += queue.bytes() * queue.copies();
    return bytes;
}

WaveQueues::WaveQueues(const Context& context, const Features& features, const SceneConstants& constants, const WaveSize& size,
                       PageSize pages)
    : size_(size), plan_(planQueues(features, constants, size)) {
    for (const PlannedQueue& queue : plan_) {
        for (size_t copy = 0; copy < queue.copies(); ++copy) {
            Buffer& words = words_[static_cast<size_t>(queue.id)][copy];
            words = Buffer(context, queue.bytes(), "queue " + queue.layout.name, pages);
            bytes_ += words.size();
        }
        bind(queue);
    }
    bindings_.set("capacity", size.capacity);
    bindings_.set("path_capacity", size.pathCapacity);
    bindings_.set("log2_batch_paths", size.log2BatchStates);
}

void WaveQueues::bind(const PlannedQueue& queue) {
    const auto& [words, next] = words_[static_cast<size_t>(queue.id)];
    bindings_.set(queue.layout.name, words);
    if (queue.copies() > 1) bindings_.set("next_" + queue.layout.name, next);
}

void WaveQueues::swapRays() {
    auto& [rays, next] = words_[static_cast<size_t>(Queue::ray)];
    std::swap(rays, next);
    bind(plan_[static_cast<size_t>(Queue::ray)]);
}

QueueItems WaveQueues::tracedRays(unsigned count) const {
    QueueItems rays = items(Queue::ray, 0, count);
    return {words_[static_cast<size_t>(Queue::ray)][1], rays.layout, rays.capacity, 0, count};
}

QueueItems WaveQueues::items(Queue queue, unsigned first, unsigned count) const {
    const auto index = static_cast<size_t>(queue);
    return {words_[index][0], plan_[index].layout, static_cast<unsigned>(plan_[index].items), first, count};
}

}  // namespace eikonal
