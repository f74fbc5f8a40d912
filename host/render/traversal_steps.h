#pragma once
// How many steps rays take through the hierarchy of a scene: most of what it costs to trace them.

#include "device/program.h"
#include "render/device_scene.h"
#include "render/stages.h"

#include <vector>

namespace eikonal {

/// Rays in scene space.
struct TracedRays {
    std::vector<vec3> origins, directions;
    std::vector<float> ends;   ///< greatest distance
};

/// Counts them by a kernel of its own (kernels/stages/count_traversal_steps.cl).
class TraversalSteps {
public:
    /// Builds the kernel. All arguments but `settings` must outlive this object.
    TraversalSteps(const Context& context, Compiler& compiler, const DeviceScene& tables, const PackedScene& scene, const StageShape& shape,
                   const BuildSettings& settings);
    /// The steps of each ray to the nearest surface, or of shadow rays to any that blocks light. Blocks.
    std::vector<uint> count(const TracedRays& rays, bool areShadowRays) const;
    /// Stores the kernel in the cache. After the first ray.
    void keep() const { compiler_.keep(kernel_.program()); }

private:
    const Context& context_;
    Compiler& compiler_;
    const DeviceScene& tables_;
    const StageShape& shape_;
    Kernel kernel_;
};

}  // namespace eikonal
