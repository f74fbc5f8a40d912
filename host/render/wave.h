#pragma once
// A wave: the paths that are in flight at once, and the queues that they travel through.

#include "device/layout.h"
#include "render/device_scene.h"
#include "render/profile.h"
#include "render/stages.h"
#include "render/tracer.h"

#include <array>
#include <list>

namespace eikonal {

/// Queues for a number of paths, and the stages that run over them.
class Wave : public Tracer {
public:
    Wave(const Context& context, const DeviceScene& scene, Stages& stages, const StageShape& shape, const Features& features, Profile& profile);

    /// Runs every kernel once over nothing, so that an implementation that compiles at the first launch does it now.
    void warmUp();

    unsigned mostPaths() const override { return mostPaths_; }
    /// Waits only for one small read a bounce.
    void trace(const Batch& batch, int endX, int endY) override;
    void resolve(const Batch& batch, const Buffer& film) override;

    size_t bytes() const { return bytes_; }

private:
    using Counts = std::array<cl_uint, hops>;
    void addQueue(const QueueLayout& layout, size_t items, const std::string& name);
    void run(const Stage* stage, unsigned items, const Bindings& extra);
    Counts countAndRoute(unsigned rays);
    unsigned shade(const Counts& counts);
    void shadeTurn(const Counts& counts, unsigned turn, unsigned slots);

    const Context& context_;
    const Bindings& scene_;
    Stages& stages_;
    StageShape shape_;
    Profile& profile_;
    Branching branching_;
    unsigned mostPaths_, capacity_;
    unsigned mostHops_;   ///< after so many a path ends, wherever it is
    std::list<Buffer> buffers_;
    Buffer counts_, cursors_, tally_;
    BatchTables tables_;
    Bindings bindings_;
    std::array<Buffer*, 2> rays_{};
    Buffer* paths_ = nullptr;
    size_t bytes_ = 0;
};

}  // namespace eikonal
