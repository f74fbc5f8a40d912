#pragma once
// The numbers of items in the queues, counted by stages on the device.

#include "render/profile.h"
#include "render/stages.h"

#include <array>
#include <functional>
#include <span>

namespace eikonal {

/// [next_queue]: items that go to that queue. [count_of_batches + i]: rays of batch i.
using WaveCounts = std::array<cl_uint, wave_counts>;
/// The total number of rays, over all batches.
std::uint64_t raysOf(const WaveCounts& counts);

/// The slots of items that may produce a next ray and a shadow ray. Each next_queue before next_miss has a segment of whole groups, in this
/// order. An item uses the same slot in its own queue, the shadow queue and the next ray queue.
class Segments {
public:
    /// counts: items, by next_queue. group: slots per work-group.
    Segments(std::span<const cl_uint> counts, unsigned group);
    SlotRange operator[](uint next_queue) const { return ranges_[next_queue]; }
    /// The end of the last segment.
    unsigned slots() const { return slots_; }
    static constexpr uint first = 0, last = next_miss - 1;   ///< next_queues that have a segment

private:
    std::array<SlotRange, next_miss> ranges_;
    unsigned slots_ = 0;
};

/// The counts of a wave, on the device and on the host.
class WaveCounter {
public:
    /// profile: accumulates the numbers of rays and shadow rays.
    WaveCounter(const Context& context, Profile& profile);
    const Bindings& bindings() const { return bindings_; }

    /// Ignores shadow rays counted before this call.
    void begin();
    /// Zeroes the counts of the last bounce. Enqueues.
    void clear();
    /// Starts copying the counts to the host. Commands enqueued later run meanwhile.
    void startReading();
    /// Submits all enqueued commands, calls `meanwhile`, and waits for the counts.
    WaveCounts wait(const std::function<void()>& meanwhile);
    /// Waits for the shadow ray count of the last bounce.
    void end();

private:
    void addShadowRays();

    const Context& context_;
    Profile& profile_;
    Buffer counts_, cursors_, shadowCount_;
    Bindings bindings_;
    WaveCounts read_{};
    cl_uint shadowRead_ = 0, shadowRays_ = 0;   ///< the device's counter (modulo 2^32) now, and at the previous read
    Owned<cl_event, clReleaseEvent> arrived_;
};

}  // namespace eikonal
