#pragma once
// What can trace samples of blocks of pixels and add them to the film: the wavefront (wave.h), or a loop for each path (path_loop.h).

#include "device/layout.h"
#include "film/batch.h"
#include "render/stop_flag.h"

#include <functional>
#include <optional>

namespace eikonal {

/// Some items of a queue on the device: word w of item i is at [w * capacity + first + i].
struct QueueItems {
    const Buffer& words;
    const QueueLayout& layout;
    unsigned capacity = 0, first = 0, count = 0;
};

/// What a bounce leaves.
struct Bounced {
    QueueItems traced;          ///< rays that were traced
    QueueItems intersections;   ///< of these, slot by slot; dead slots (t < 0) among them
    QueueItems shadows;         ///< rays to lights that were tested; dead slots among them. Where hits split rays, those of the last pass
    QueueItems hits;            ///< slot by slot of `shadows`; those of other items hold garbage
    QueueItems rays;            ///< that leave; dead slots (t_max < 0) among them
    QueueItems paths;           ///< the states of all paths of the batch
};

/// Where a tracer's work comes from, and who is told when it is done.
struct BatchStream {
    std::function<std::optional<Batch>()> next;   ///< the next batch, of Tracer::mostPaths() paths at most; none: there are no more
    std::function<void(const Batch&)>
        traced;  ///< called for each in the order in which they came, when its paths are at their ends; may resolve it
    int endX = 0, endY = 0;                       ///< no pixel from there on
    /// If set, a wave calls it after every bounce of a stream of one batch. False: the rays are dropped.
    std::function<bool(const Bounced&)> watch = {};
    std::function<void()> meanwhile = [] {};      ///< called when the device has work: what the host can do in that time; may throw
};

class Tracer {
public:
    virtual ~Tracer() = default;
    /// The most paths of a batch that it takes.
    virtual unsigned mostPaths() const = 0;
    /// Raised, it ends trace() soon: batches in flight are abandoned.
    virtual const StopFlag& stopFlag() const = 0;
    /// Follows every path of every batch of the stream from the camera to its end. Paths of several batches may be in flight at once.
    virtual void trace(const BatchStream& stream) = 0;
    /// The most passes (samples of all pixels) whose light paths can be stored at a time, for paths from the camera to connect or merge
    /// with; 0: those of this scene do neither.
    virtual unsigned mostStoredPasses() const { return 0; }
    /// Follows the light path of every sample of every batch, to its end; batches may be of pixels that are not rendered. `splat` sums what
    /// the paths add to the pixels of `part` (include/eikonal/film.h). If light paths are stored, those that trace() follows next connect
    /// or merge with these: they are the paths of mostStoredPasses() whole passes at most.
    virtual void traceLights(const BatchStream& stream, const Buffer& splat, const PixelRect& part) = 0;
    /// Within BatchStream::traced: adds the paths of that batch to their pixels. `film` holds those of the batch, block after block.
    /// Enqueues.
    virtual void resolve(const Batch& batch, const Buffer& film) = 0;
};

}  // namespace eikonal
