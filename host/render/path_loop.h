#pragma once
// A megakernel that follows each path in a loop (kernels/stages/loop.cl), made of the same functions as the stages. The wavefront is
// tested and benchmarked against it.

#include "render/batch_tables.h"
#include "render/device_scene.h"
#include "render/profile.h"
#include "render/ray_splitting.h"
#include "render/stages.h"
#include "render/tracer.h"

namespace eikonal {

class PathLoop : public Tracer {
public:
    PathLoop(const Context& context, Compiler& compiler, const DeviceScene& deviceScene, const PackedScene& scene, const StageShape& shape,
             const BuildSettings& settings, Profile& profile);
    unsigned mostPaths() const override { return mostPaths_; }
    const StopFlag& stopFlag() const override { return scene_.stopFlag(); }
    void trace(const BatchStream& stream) override;
    void traceLights(const BatchStream&, const Buffer&, const PixelRect&) override {
        throw std::logic_error("the loop traces no light paths");
    }
    void resolve(const Batch& batch, const Buffer& film) override;

private:
    const Context& context_;
    const DeviceScene& scene_;
    RaySplitting splitting_;
    StageShape shape_;
    unsigned mostPaths_;
    Profile& profile_;
    Kernel loop_, resolve_;
    Buffer hit_, path_;
    BatchTables tables_;
    Bindings bindings_;
};

}  // namespace eikonal
