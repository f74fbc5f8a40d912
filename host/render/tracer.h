#pragma once
// What can trace the samples of a tile and add them to the film: the wavefront (wave.h), or a loop for each path (path_loop.h).

#include "device/kernel.h"
#include "render/device_scene.h"

namespace eikonal {

/// The samples of a tile of pixels that are traced together. Tiles are powers of two wide and high; what reaches beyond the
/// pixels that are wanted stays empty.
struct Tile {
    int x = 0, y = 0;                 ///< upper left pixel
    int log2Width = 0, log2Height = 0;
    unsigned firstSample = 0, samples = 1;
    int width() const { return 1 << log2Width; }
    int height() const { return 1 << log2Height; }
    unsigned pixels() const { return 1u << (log2Width + log2Height); }
    unsigned paths() const { return pixels() * samples; }
};

/// Gives kernels the numbers of a tile.
void bindTile(Bindings& bindings, const Tile& tile, int endX, int endY);

/// How often a path goes from one surface to the next at most. Interfaces between media do not count as depth: a path that has passed a
/// thousand more than it may scatter is lost between two that touch. Nor do events inside of a body that light wanders in; there it may be sixteen thousand.
unsigned mostHops(const DeviceScene& scene);

class Tracer {
public:
    virtual ~Tracer() = default;
    /// The most paths of a tile that it takes.
    virtual unsigned mostPaths() const = 0;
    /// Follows every path of a tile from the camera to its end. endX, endY: no pixel from there on. Enqueues.
    virtual void trace(const Tile& tile, int endX, int endY) = 0;
    /// Adds the traced paths to the tile of the film in `film`. Enqueues.
    virtual void resolve(const Tile& tile, const Buffer& film) = 0;
};

}  // namespace eikonal
