#pragma once
// What can trace samples of blocks of pixels and add them to the film: the wavefront (wave.h), or a loop for each path (path_loop.h).

#include "render/batch.h"
#include "render/device_scene.h"

namespace eikonal {

/// How often a path goes from one surface to the next at most. Interfaces between media do not count as depth: a path that has passed a
/// thousand more than it may scatter is lost between two that touch. Nor do events inside of a body that light wanders in; there it may be sixteen thousand.
unsigned mostHops(const DeviceScene& scene);

class Tracer {
public:
    virtual ~Tracer() = default;
    /// The most paths of a batch that it takes.
    virtual unsigned mostPaths() const = 0;
    /// Follows every path of a batch from the camera to its end. endX, endY: no pixel from there on. Enqueues.
    virtual void trace(const Batch& batch, int endX, int endY) = 0;
    /// Adds the paths that were traced last to their pixels: `film` holds those of the batch, block after block. Enqueues.
    virtual void resolve(const Batch& batch, const Buffer& film) = 0;
};

}  // namespace eikonal
