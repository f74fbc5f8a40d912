#pragma once
// How many items there are: what stages count on the device, and what it says of the queues.

#include "render/profile.h"
#include "render/stages.h"

#include <array>
#include <span>

namespace eikonal {

/// At each next_queue: how many items go there. At count_of_batches + i: how many rays the i-th batch has.
using WaveCounts = std::array<cl_uint, wave_counts>;
/// Rays of all batches.
std::uint64_t raysOf(const WaveCounts& counts);

/// Where items lie that have a slot each in the shadow queue and the next ray queue. They share one range of slots, whichever queue holds
/// them: a segment for each next_queue before next_miss, in this order, each of whole groups.
class Segments {
public:
    /// counts: at each next_queue. group: slots of a group.
    Segments(std::span<const cl_uint> counts, unsigned group);
    SlotRange operator[](uint next_queue) const { return ranges_[next_queue]; }
    /// Up to the end of the last segment.
    unsigned slots() const { return slots_; }
    static constexpr uint first = 0, last = next_miss - 1;   ///< next_queues that have one

private:
    std::array<SlotRange, next_miss> ranges_;
    unsigned slots_ = 0;
};

/// The counts of a wave, on the device and on their way to the host.
class WaveCounter {
public:
    /// profile: where real rays and shadow rays are added up.
    WaveCounter(const Context& context, Profile& profile);
    const Bindings& bindings() const { return bindings_; }

    /// Forgets shadow rays that were counted before.
    void begin();
    /// Zeroes the counts of the last bounce. Enqueues.
    void clear();
    /// The counts travel to the host while the device goes on with what is enqueued from now on.
    void startReading();
    /// Submits what is enqueued, and waits for the counts.
    WaveCounts wait();
    /// Waits for the shadow rays of the last bounce.
    void end();

private:
    void addShadowRays();

    const Context& context_;
    Profile& profile_;
    Buffer counts_, cursors_, shadowCount_;
    Bindings bindings_;
    WaveCounts read_{};
    cl_uint shadowRead_ = 0, shadowRays_ = 0;   ///< now, and before: they wrap around
    Owned<cl_event, clReleaseEvent> arrived_;
};

}  // namespace eikonal
