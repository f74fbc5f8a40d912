#pragma once
// A wave: the paths that are in flight at once, and the queues that they travel through. Where paths end, new ones begin: at the next bounce, so
// that the queues stay full while there is work.

#include "device/layout.h"
#include "render/device_scene.h"
#include "render/profile.h"
#include "render/stages.h"
#include "render/tracer.h"
#include "render/wave_queues.h"

#include <array>
#include <deque>
#include <list>

namespace eikonal {

/// Queues for a number of paths, and the stages that run over them.
class Wave : public Tracer {
public:
    /// queuePages: small ones where far fewer paths are traced than there is room for, so that what stays empty takes up no memory.
    Wave(const Context& context, const DeviceScene& scene, Stages& stages, const StageShape& shape, const Features& features, Profile& profile,
         PageSize queuePages = PageSize::large);

    /// Runs every kernel once over nothing, so that an implementation that compiles at the first launch does it now.
    void warmUp();

    unsigned mostPaths() const override { return size_.paths; }
    /// Waits only for one small read a bounce.
    void trace(const BatchStream& stream) override;
    void resolve(const Batch& batch, const Buffer& film) override;

    size_t bytes() const { return bytes_; }

private:
    using Counts = std::array<cl_uint, wave_counts>;
    /// A batch that has paths in flight.
    struct Flying {
        Batch batch;
        unsigned place;       ///< of its tables, and of the states of its paths
        unsigned begun = 0;   ///< paths
        bool isBegun() const { return begun == batch.paths(); }
    };
    void addQueue(const QueueLayout& layout, size_t items, const std::string& name, PageSize pages);
    void run(const Stage* stage, unsigned items, const Bindings& extra);
    Counts countAndRoute(unsigned rays);
    unsigned shade(const Counts& counts);
    void shadingPass(const Counts& counts, unsigned pass, unsigned slots);
    Counts bounce(unsigned& slots);
    unsigned room(unsigned slots) const;
    bool admit(const BatchStream& stream);
    unsigned refill(unsigned slots, const BatchStream& stream);
    void bindRays();
    void countShadowRays(cl_uint now);
    unsigned firstPath(unsigned place) const { return place << size_.log2BatchPaths; }
    QueueItems pathsOf(const Flying& f) const { return {*paths_, pathLayout_, size_.pathCapacity, firstPath(f.place), f.batch.paths()}; }

    const Context& context_;
    const Bindings& scene_;
    Stages& stages_;
    StageShape shape_;
    Profile& profile_;
    RaySplitting splitting_;
    WaveSize size_;
    std::list<Buffer> buffers_;
    Buffer counts_, cursors_, shadowCount_;
    std::vector<BatchTables> tables_;   ///< for each place
    std::deque<Flying> flying_;         ///< the oldest first
    unsigned nextPlace_ = 0;
    cl_uint shadowRays_ = 0;            ///< as read last from the device, where they wrap around
    Bindings bindings_;
    std::array<Buffer*, 2> rays_{};
    Buffer* paths_ = nullptr;
    QueueLayout rayLayout_, pathLayout_;
    size_t bytes_ = 0;
};

}  // namespace eikonal
