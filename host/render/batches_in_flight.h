#pragma once
// The batches whose paths a wave traces at the same time. Each has a place: tables of its own, and path states that no other has.

#include "render/tracer.h"
#include "render/wave_counts.h"
#include "render/wave_queues.h"

#include <deque>
#include <optional>

namespace eikonal {

class BatchesInFlight {
public:
    /// All of these outlive it.
    BatchesInFlight(const Context& context, WaveQueues& queues, const WaveSize& size, const RaySplitting& splitting);

    bool empty() const { return flying_.empty(); }

    /// Paths that begin.
    struct Start {
        unsigned count;
        Bindings arguments;   ///< of generate_rays: which paths of which batch
    };
    /// At most `most` paths of the batch that came last, or of the next one of the stream. Nothing: the stream has no more, or all
    /// places are taken.
    std::optional<Start> begin(unsigned most, const BatchStream& stream);

    /// Hands batches back in their order: those whose paths have all begun and had no ray at this bounce.
    void finish(const WaveCounts& counts, const BatchStream& stream);

    /// Of the oldest: what resolve_film takes, and its path states.
    Bindings oldestArguments() const { return argumentsOf(flying_.front()); }
    QueueItems oldestPaths() const;

    /// Arguments of a stage that runs over no paths.
    Bindings noPaths() const;

private:
    struct InFlight {
        Batch batch;
        unsigned place;
        unsigned begun = 0;   ///< paths
        bool isBegun() const { return begun == batch.paths(); }
    };
    bool admit(const BatchStream& stream);
    Bindings argumentsOf(const InFlight& batch) const;
    unsigned firstPath(const InFlight& batch) const { return batch.place << size_.log2BatchStates; }

    const Context& context_;
    WaveQueues& queues_;
    const WaveSize& size_;
    const RaySplitting& splitting_;
    std::vector<BatchTables> tables_;   ///< for each place
    std::deque<InFlight> flying_;       ///< the oldest first
    unsigned nextPlace_ = 0;
};

}  // namespace eikonal
