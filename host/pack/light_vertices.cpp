#include "pack/light_vertices.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace eikonal {

/// The most vertices that are stored at a time: with their grid 100 bytes each in RGB, 800 MiB.
constexpr double mostVertices = 1 << 23;
/// Light paths at a time, if passes are so small: a few waves.
constexpr double pathsAtATime = 1 << 19;

double mostVerticesOfPath(const settings& frame) { return std::min(frame.max_depth, 12u); }
static double pixelsOf(const settings& frame) { return static_cast<double>(frame.width) * frame.height; }
double pathsThatKeep(const settings& frame, uint log2Share) { return std::ldexp(pixelsOf(frame), -static_cast<int>(log2Share)); }
static double pathsOfPass(const settings& frame) { return pathsThatKeep(frame, frame.stored_share); }

void requireMerging(const PackContext& context, settings& frame, const std::string& why) {
    context.require(Feature::MERGING, why);
    frame.stored_share = 0;
    while (pathsOfPass(frame) * mostVerticesOfPath(frame) > mostVertices) ++frame.stored_share;
    /* As if all paths ended on a disk of the scene's size: four to each radius */
    const double paths = std::max(pathsOfPass(frame), 1.0), scale = context.space.scale,
                 chosen = (context.bounds.empty() ? 1.0 : context.bounds.radius() * scale) * 2 / std::sqrt(paths),
                 radius = context.scene.integrator.mergeRadius > 0 ? context.scene.integrator.mergeRadius * scale : chosen;
    setMergeRadius(frame, radius);
}

void setMergeRadius(settings& frame, double radius) {
    frame.merge_radius = static_cast<float>(std::max(radius, 1e-7));
    frame.merge_density = static_cast<float>(std::max(pathsOfPass(frame), 1.0) * M_PI * std::pow(double{frame.merge_radius}, 2));
}

unsigned passesAtATime(const PackedScene& scene, double pathsOfPass, double mostVertices) {
    const double most = mostVertices / std::max(pathsOfPass * mostVerticesOfPath(scene.frame()), 1.0),
                 passes = std::min({pathsAtATime / pixelsOf(scene.frame()), most, static_cast<double>(scene.samples)});
    return std::bit_floor(static_cast<unsigned>(std::max(passes, 1.0)));
}

size_t roomForVertices(const settings& frame, double paths) {
    /* Fewer paths than pixels: how many store vertices, and of long ones how many vertices, varies a little */
    return static_cast<size_t>(paths * mostVerticesOfPath(frame) * 1.01) + 4096;
}

VertexPlan planVertices(const PackedScene& scene) {
    if (!scene.features.has(Feature::MERGING)) return {};
    const settings& frame = scene.frame();
    VertexPlan plan;
    plan.passes = passesAtATime(scene, pathsOfPass(frame), mostVertices);
    plan.vertices = roomForVertices(frame, plan.passes * pathsOfPass(frame));
    plan.buckets = std::bit_floor(plan.vertices);
    return plan;
}

}  // namespace eikonal
