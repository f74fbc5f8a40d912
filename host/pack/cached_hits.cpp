#include "pack/cached_hits.h"

#include "pack/light_vertices.h"

#include <algorithm>
#include <cmath>

namespace eikonal {

/// The most hits that are kept at a time: some 200 bytes each in RGB, 400 MiB.
constexpr double mostHits = 1 << 21;

static double pathsOfPass(const settings& frame) {
    return std::max(std::floor(pathsThatKeep(frame, frame.cached_share)), 1.0);   // of full groups of pixels, as cached_paths
}

void requireConnections(const PackContext& context, settings& frame, const std::string& why) {
    if (frame.max_depth < 2) return;
    context.require(Feature::CONNECTIONS, why);
    frame.cached_share = 0;
    while (pathsOfPass(frame) * mostVerticesOfPath(frame) > mostHits) ++frame.cached_share;
}

HitCachePlan planHitCache(const PackedScene& scene) {
    if (!scene.features.has(Feature::CONNECTIONS)) return {};
    const settings& frame = scene.frame();
    HitCachePlan plan;
    plan.passes = passesAtATime(scene, pathsOfPass(frame), mostHits);
    plan.paths = plan.passes * static_cast<size_t>(pathsOfPass(frame));
    plan.hits = roomForVertices(frame, static_cast<double>(plan.paths));
    return plan;
}

bool sharesWavelengths(const Features& features) { return features.has(Feature::MERGING) || features.has(Feature::CONNECTIONS); }

}  // namespace eikonal
