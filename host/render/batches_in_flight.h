#pragma once
// The batches whose paths a wave traces at the same time. Each occupies a place, which has its own tables and path states.

#include "render/batch_tables.h"
#include "render/tracer.h"
#include "render/wave_counts.h"
#include "render/wave_queues.h"

#include <deque>
#include <optional>

namespace eikonal {

class BatchesInFlight {
public:
    /// All arguments must outlive this object.
    BatchesInFlight(const Context& context, WaveQueues& queues, const WaveSize& size, const RaySplitting& splitting);

    bool empty() const { return flying_.empty(); }

    /// Camera paths to generate.
    struct Start {
        unsigned count;
        Bindings arguments;   ///< arguments of generate_rays: which paths of which batch
    };
    /// Up to `most` more paths of the newest batch, or of the stream's next batch if all of its paths have begun. Nothing: the stream is
    /// empty, or all places are taken.
    std::optional<Start> begin(unsigned most, const BatchStream& stream);

    /// Calls stream.traced for finished batches, oldest first: all of their paths have begun, and none had a ray at this bounce.
    void finish(const WaveCounts& counts, const BatchStream& stream);

    /// Drops all batches.
    void abandon() { flying_.clear(); }

    /// Of the oldest batch: the arguments of resolve_film, and its path states.
    Bindings oldestArguments() const { return argumentsOf(flying_.front()); }
    QueueItems oldestPaths() const;

    /// Arguments of a stage that runs over no paths.
    Bindings noPaths() const;

private:
    struct InFlight {
        Batch batch;
        unsigned place;
        unsigned begun = 0;   ///< paths that have begun
        bool isBegun() const { return begun == batch.paths(); }
    };
    bool admit(const BatchStream& stream);
    Bindings argumentsOf(const InFlight& batch) const;
    unsigned firstPath(const InFlight& batch) const { return batch.place << size_.log2BatchStates; }

    const Context& context_;
    WaveQueues& queues_;
    const WaveSize& size_;
    const RaySplitting& splitting_;
    std::vector<BatchTables> tables_;   ///< by place
    std::deque<InFlight> flying_;       ///< oldest first
    unsigned nextPlace_ = 0;
};

}  // namespace eikonal
