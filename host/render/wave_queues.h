#pragma once
// The queues of a wave, their sizes and their memory.

#include "device/layout.h"
#include "render/ray_splitting.h"
#include "render/stages.h"
#include "render/tracer.h"

#include <array>
#include <string>
#include <vector>

namespace eikonal {

/// The capacity of a wave.
struct WaveSize {
    unsigned paths;            ///< the most camera paths that begin at once, and that a batch has
    unsigned batches;          ///< batches in flight
    unsigned log2BatchStates;  ///< log2 of the path states reserved for a batch
    unsigned slots;            ///< slots of the ray queue in which camera paths may begin
    unsigned leastRoom;        ///< fewer free slots than this are not worth a launch
    unsigned capacity;         ///< slots of other queues: all rays that may leave hits, with segments padded to whole groups
    unsigned pathCapacity;     ///< path states of all batches, plus a group that belongs to no path
    WaveSize(const StageShape& shape, const RaySplitting& splitting);

    /// The room for more rays behind `taken` slots; 0 if less than leastRoom.
    unsigned room(unsigned taken) const;
    /// Capacity of a queue, in items.
    size_t items(Placement placement) const { return placement == Placement::by_path ? pathCapacity : capacity; }
};

/// The layout of a queue; that of next_ray is that of ray. In `hit`, the parameters of any BSDF fit behind the fields; in `path`, the light
/// of light groups.
QueueLayout itemLayout(Queue queue, const Features& features, const SceneConstants& constants = {});

/// A planned queue of a wave. Queues that the scene does not require have no items.
struct PlannedQueue {
    Queue id;
    QueueLayout layout;
    size_t items;
    size_t bytes() const { return items * static_cast<size_t>(layout.words) * sizeof(cl_uint); }
    /// The ray queue is double-buffered: stages read `ray` and fill `next_ray` for the next bounce.
    size_t copies() const { return id == Queue::ray ? 2 : 1; }
};
std::vector<PlannedQueue> planQueues(const Features& features, const SceneConstants& constants, const WaveSize& size);

/// The value of WaveQueues::bytes(), before anything is allocated.
size_t plannedWaveBytes(const PackedScene& scene, const StageShape& shape);

/// The queues of planQueues(), allocated on a device.
class WaveQueues {
public:
    WaveQueues(const Context& context, const Features& features, const SceneConstants& constants, const WaveSize& size, PageSize pages);

    /// Every queue by name, and the capacities.
    const Bindings& bindings() const { return bindings_; }
    /// Swaps `ray` and `next_ray`.
    void swapRays();
    const Buffer& rays() const { return words_[static_cast<size_t>(Queue::ray)][0]; }
    Buffer& paths() { return words_[static_cast<size_t>(Queue::path)][0]; }
    QueueItems items(Queue queue, unsigned first, unsigned count) const;
    /// The rays that were swapped away: those that the intersections belong to.
    QueueItems tracedRays(unsigned count) const;
    size_t bytes() const { return bytes_; }

private:
    void bind(const PlannedQueue& queue);

    WaveSize size_;
    std::vector<PlannedQueue> plan_;
    std::array<std::array<Buffer, 2>, queueCount> words_;   ///< by Queue
    Bindings bindings_;
    size_t bytes_ = 0;
};

}  // namespace eikonal
