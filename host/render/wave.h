#pragma once
// A wave: the paths in flight, and their queues. When paths end, new ones take their slots at the next bounce, so that the queues stay
// full while there is work.

#include "render/batches_in_flight.h"
#include "render/device_scene.h"
#include "render/hit_cache.h"
#include "render/stage_launcher.h"
#include "render/tracer.h"
#include "render/vertex_grid.h"
#include "render/wave_counts.h"
#include "render/wave_queues.h"

namespace eikonal {

/// Queues for a number of paths, and the stages that run over them.
class Wave : public Tracer {
public:
    /// scene: the source of `tables` and `stages`. queuePages: small pages if far fewer paths will be traced than fit, so that unused
    /// slots take no memory. All arguments except scene and shape must outlive the wave.
    Wave(const Context& context, const DeviceScene& tables, const PackedScene& scene, Stages& stages, const StageShape& shape,
         Profile& profile, PageSize queuePages = PageSize::large);

    /// Runs every kernel once over no slots, so that implementations that compile at the first launch do it now. isShared: another device
    /// may run the same kernels at the same time.
    void warmUp(bool isShared = false);

    unsigned mostPaths() const override { return size_.paths; }
    const StopFlag& stopFlag() const override { return stopFlag_; }
    /// Waits for the device only once per bounce, for the counts.
    void trace(const BatchStream& stream) override;
    unsigned mostStoredPasses() const override;
    void traceLights(const BatchStream& stream, const Buffer& splat, const PixelRect& part) override;
    void resolve(const Batch& batch, const Buffer& film) override;
    /// Where the light paths that traceLights() followed last have left vertices. Blocks.
    SurfacePoints storedVertices() const { return vertices_.stored(); }

    size_t bytes() const { return queues_.bytes(); }

private:
    unsigned generate(uint over, unsigned slots, const BatchStream& stream);
    WaveCounts intersect(unsigned slots, uint routed, const BatchStream& stream);
    unsigned shade(const WaveCounts& counts);
    void connect(const Segments& segments);
    unsigned shadeLights(const WaveCounts& counts, const Bindings& splat);
    bool isInterrupted();
    bool goesOn(const WaveCounts& counts, unsigned rays, const BatchStream& stream) const;

    const Context& context_;
    const StopFlag& stopFlag_;
    Stages& stages_;
    StageShape shape_;
    RaySplitting splitting_;
    WaveSize size_;
    WaveQueues queues_;
    HitCache cache_;
    VertexGrid vertices_;
    WaveCounter counter_;
    BatchesInFlight batches_;
    StageLauncher launcher_;
    unsigned traced_ = 0;   ///< slots that the last intersect() had
};

}  // namespace eikonal
