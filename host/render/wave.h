#pragma once
// A wave: the paths that are in flight at once, and the queues that they travel through.

#include "device/layout.h"
#include "render/device_scene.h"
#include "render/profile.h"
#include "render/stages.h"

#include <array>
#include <list>

namespace eikonal {

/// The samples of a tile of pixels that one wave takes. Tiles are powers of two wide and high; what reaches beyond the
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

/// Queues for a number of paths, and the stages that run over them.
class Wave {
public:
    Wave(const Context& context, const DeviceScene& scene, Stages& stages, const StageShape& shape, const Features& features, Profile& profile);

    /// Runs every kernel once over nothing, so that an implementation that compiles at the first launch does it now.
    void warmUp();

    /// Follows every path of a tile from the camera to its end. Enqueues; waits only for one small read a bounce.
    void trace(const Tile& tile, int endX, int endY);

    /// Adds the traced paths to the tile of the film in `film`.
    void resolve(const Tile& tile, const Buffer& film);

    size_t bytes() const { return bytes_; }
    /// What bytes() will be, before anything is allocated.
    static size_t plannedBytes(const PackedScene& scene, const StageShape& shape);

private:
    using Counts = std::array<cl_uint, hops>;
    void addQueue(const QueueLayout& layout, size_t items, const std::string& name);
    void run(const Stage* stage, unsigned items, const Bindings& extra);
    Counts countAndRoute(unsigned rays);
    unsigned shade(const Counts& counts);

    const Context& context_;
    const Bindings& scene_;
    Stages& stages_;
    StageShape shape_;
    Profile& profile_;
    unsigned capacity_;
    unsigned mostHops_;   ///< after so many a path ends, wherever it is
    std::list<Buffer> buffers_;
    Buffer counts_, cursors_, tally_;
    Bindings bindings_;
    std::array<const Buffer*, 2> rays_{};
    size_t bytes_ = 0;
};

}  // namespace eikonal
