#pragma once
// The queues of a wave: which there are, how large they are, and their memory.

#include "device/layout.h"
#include "render/ray_splitting.h"
#include "render/stages.h"
#include "render/tracer.h"

#include <array>
#include <string>
#include <vector>

namespace eikonal {

/// For how much there is room in a wave.
struct WaveSize {
    unsigned paths;            ///< of the camera that begin at once, and most paths of a batch
    unsigned batches;          ///< in flight at once
    unsigned log2BatchStates;  ///< from the first path state of a batch to that of the next
    unsigned slots;            ///< of the ray queue in which paths may begin
    unsigned leastRoom;        ///< so many of them must be free, or it is not worth a launch
    unsigned capacity;         ///< of queues: every ray, with segments that begin at multiples of a group, as often as rays may leave a hit
    unsigned pathCapacity;     ///< path states of all batches, and a group that belongs to no path
    WaveSize(const StageShape& shape, const RaySplitting& splitting);

    /// For how many more rays there is room behind `taken` slots; 0 where it is less than leastRoom.
    unsigned room(unsigned taken) const;
    /// Items of a queue.
    size_t items(Placement placement) const { return placement == Placement::by_path ? pathCapacity : capacity; }
};

/// The layout of a queue, and in `hit` room for the parameters of any BSDF behind the fields.
QueueLayout itemLayout(Queue queue, const Features& features);

/// A queue of a wave. One that the scene does not require holds no items.
struct PlannedQueue {
    Queue id;
    QueueLayout layout;
    size_t items;
    size_t bytes() const { return items * static_cast<size_t>(layout.words) * sizeof(cl_uint); }
    /// The ray queue is there twice: while stages drain `ray`, others fill `next_ray` for the next bounce.
    size_t copies() const { return id == Queue::ray ? 2 : 1; }
};
std::vector<PlannedQueue> planQueues(const Features& features, const SceneConstants& constants, const WaveSize& size);

/// What WaveQueues::bytes() will be, before anything is allocated.
size_t plannedWaveBytes(const PackedScene& scene, const StageShape& shape);

/// The queues of planQueues on a device.
class WaveQueues {
public:
    WaveQueues(const Context& context, const Features& features, const SceneConstants& constants, const WaveSize& size, PageSize pages);

    /// Every queue by its name, and the capacities.
    const Bindings& bindings() const { return bindings_; }
    /// What was filled for the next bounce is now the ray queue.
    void swapRays();
    const Buffer& rays() const { return words_[static_cast<size_t>(Queue::ray)][0]; }
    Buffer& paths() { return words_[static_cast<size_t>(Queue::path)][0]; }
    QueueItems items(Queue queue, unsigned first, unsigned count) const;
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
