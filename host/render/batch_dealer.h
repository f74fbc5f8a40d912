#pragma once
// Who traces what: deals the batches of passes out to devices, and takes those back that a device has lost.

#include "render/passes.h"
#include "render/tracer.h"

#include <deque>
#include <functional>
#include <map>
#include <optional>

namespace eikonal {

/// Devices take batches as fast as they trace them, so a batch may be done before an earlier one of the same pixels. It then waits, since
/// a pixel gets its samples in order. A batch is lost where its device fails or is interrupted; it is dealt again, to whoever asks next.
/// Not thread-safe.
class BatchDealer {
public:
    /// film: where batches end; must outlive this object. nextPass: none when there are no more. mostPaths: of a batch.
    BatchDealer(const Film& film, std::function<std::optional<Pass>()> nextPass, unsigned mostPaths)
        : film_(film), nextPass_(std::move(nextPass)), mostPaths_(mostPaths) {}

    /// The next batch for a device, a lost one first. None: there are no more.
    std::optional<Batch> deal(const Tracer* device);

    /// How it stands with the oldest batch that a device holds.
    enum class State {
        ready,     ///< its pixels have all earlier samples
        waiting,   ///< another device may bring them
        stuck      ///< they are lost as well, or dealt again after it: it can only be lost, too
    };
    State stateOf(const Tracer* device) const;
    /// The oldest batch that a device holds is in the film. Returns by how many samples every pixel has more, now that all passes up to
    /// some one are done.
    unsigned keep(const Tracer* device);
    /// The oldest batch of a device is lost; or all of them.
    void lose(const Tracer* device);
    void loseAll(const Tracer* device);
    bool hasLost() const { return !lost_.empty(); }

private:
    struct Dealt {
        Batch batch;
        size_t pass;
        size_t place;    ///< in the order in which it was dealt first
        size_t number;   ///< in the order in which it was dealt now
    };
    struct Traced { unsigned samples; unsigned long layers; };   ///< of a pass: the samples that it adds, and the layers still to trace

    const Film& film_;
    std::function<std::optional<Pass>()> nextPass_;
    unsigned mostPaths_;
    std::optional<Batches> batches_;                    ///< of the newest pass
    std::deque<Traced> traced_;                         ///< passes that are not done
    size_t donePasses_ = 0, dealtBatches_ = 0, deals_ = 0;
    std::map<const Tracer*, std::deque<Dealt>> held_;     ///< by device, oldest first
    std::map<size_t, Dealt> lost_;                      ///< by place
};

}  // namespace eikonal
