#pragma once
// Two ways to trace the same rays: our kernels, and Embree on as many threads.

#include "bench_scene.h"
#include "bvh/build.h"
#include "device/kernel.h"

#include <embree3/rtcore.h>

namespace eikonal {

/// Embree's tree over a mesh; rtcIntersect1 and rtcOccluded1 on `threads` threads.
class EmbreeTracer {
public:
    EmbreeTracer(const BenchMesh& mesh, int threads, bool robust, bool highQuality);
    ~EmbreeTracer();
    double buildSeconds() const { return buildSeconds_; }
    /// Closest hits of rays [first, first + count), written to hits from `first` on.
    void intersect(const std::vector<BenchRay>& rays, std::vector<BenchHit>& hits, size_t first, size_t count) const;
    /// t = -1: nothing in the way; otherwise 0.
    void occlude(const std::vector<BenchRay>& rays, std::vector<BenchHit>& hits, size_t first, size_t count) const;

private:
    int threads_;
    RTCDevice device_ = nullptr;
    RTCScene scene_ = nullptr;
    double buildSeconds_ = 0;
};

struct TracerShape { int localSize = 1, itemsPerWorkItem = 64, interleavedRays = 4; };   ///< as the renderer has it on a CPU (StageShape)

/// Our tree over a mesh, on an OpenCL device.
class DeviceTracer {
public:
    DeviceTracer(const Context& context, const BenchMesh& mesh, const TracerShape& shape);

    /// Rays as queues on the device, `batch` a queue. They stay until the next upload.
    void uploadRays(const std::vector<BenchRay>& rays, size_t batch, bool shadows);
    size_t batches() const { return batches_.size(); }
    /// Runs stage intersect_rays, or test_shadows, on all batches, enqueued together, and waits.
    void trace();
    std::vector<BenchHit> download() const;

    const BvhRoot& root() const { return root_; }
    const BvhTables& tables() const { return tables_; }
    double buildSeconds() const { return buildSeconds_; }

private:
    struct Batch { size_t count; Buffer in, out; };
    const Context& context_;
    TracerShape shape_;
    Features features_;
    BvhTables tables_;
    BvhRoot root_;
    double buildSeconds_ = 0;
    std::vector<Buffer> buffers_;
    Bindings scene_;
    Kernel intersect_, occlude_;
    bool shadows_ = false;
    std::vector<Batch> batches_;
};

}  // namespace eikonal
