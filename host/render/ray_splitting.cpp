#include "render/ray_splitting.h"

namespace eikonal {

RaySplitting RaySplitting::of(const PackedScene& scene) {
    if (!scene.features.has(Feature::RAY_SPLITTING)) return {};
    const settings& frame = scene.frame();
    const unsigned raysPerHit = std::max(2u, frame.rough_splits == NONE ? 0 : 1u << std::min(frame.rough_splits, frame.tree_splits));
    return {frame.tree_splits, raysPerHit, std::max(raysPerHit, frame.tree_lights)};
}

void RaySplitting::clearStates(const Context& context, Buffer& paths) const {
    if (splits) paths.clear(context, 0, paths.size());
}

std::vector<Bindings> RaySplitting::passes(unsigned hits, const Buffer& rays) const {
    std::vector<Bindings> passes(shadingPasses);
    for (unsigned pass = 0; pass < shadingPasses; ++pass) {
        passes[pass].set("shading_pass", pass);
        passes[pass].set("pass_slots", pass < raysPerHit ? hits : 0);
        /* Passes beyond the last ray produce only shadow rays; the rays that they write go to a queue that is no longer read */
        if (pass >= raysPerHit) passes[pass].set("next_ray", rays);
    }
    return passes;
}

}  // namespace eikonal
