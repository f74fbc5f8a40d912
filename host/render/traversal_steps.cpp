#include "render/traversal_steps.h"

namespace eikonal {

TraversalSteps::TraversalSteps(const Context& context, Compiler& compiler, const DeviceScene& tables, const PackedScene& scene,
                               const StageShape& shape, const BuildSettings& settings)
    : context_(context),
      compiler_(compiler),
      tables_(tables),
      shape_(shape),
      kernel_(compiler.build("#include \"stages/count_traversal_steps.cl\"\n", "count_traversal_steps",
                             completeSettings(settings, scene, shape))) {}

std::vector<uint> TraversalSteps::count(const TracedRays& rays, bool areShadowRays) const {
    std::vector<uint> steps(rays.ends.size());
    if (steps.empty()) return steps;
    const Buffer origins = Buffer::of<vec3>(context_, rays.origins, "origins of rays"),
                 directions = Buffer::of<vec3>(context_, rays.directions, "directions of rays"),
                 ends = Buffer::of<float>(context_, rays.ends, "ends of rays"),
                 counted(context_, steps.size() * sizeof(uint), "steps of rays");
    Bindings own;
    own.set("ray_origins", origins);
    own.set("ray_directions", directions);
    own.set("ray_ends", ends);
    own.set("are_shadow_rays", static_cast<uint>(areShadowRays));
    own.set("steps", counted);
    own.set("count", static_cast<uint>(steps.size()));
    for (const char* name : {"capacity", "path_capacity"}) own.set(name, 0u);
    const Owned<cl_event, clReleaseEvent> launched(kernel_.launch(context_, {&tables_.bindings(), &own}, steps.size(), shape_.group()));
    counted.read(context_, steps.data(), steps.size() * sizeof(uint));
    return steps;
}

}  // namespace eikonal
