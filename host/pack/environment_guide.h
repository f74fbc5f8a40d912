#pragma once
// The environment guide (include/eikonal/light.h): by place in the scene, the directions from which a uniform environment is visible.

#include "eikonal/portable.h"
#include "pack/tables.h"

#include <functional>
#include <span>
#include <vector>

namespace eikonal {

/// The budget of a survey: a few percent of the time to render all samples of the whole image.
struct GuideBudget {
    size_t paths = 0;   ///< to follow
    size_t rays = 0;    ///< shadow rays
    /// Whether it suffices to learn anything.
    bool isEnough() const;
    static GuideBudget of(uint width, uint height, int samples);
};

/// Points from which the maps are learned: `perMap` for each map, map after map, with normals (zero: all directions). Scene space.
struct GuideRepresentatives {
    std::vector<vec3> points, normals;
    size_t maps = 0, perMap = 0;
};

/// For the GUIDE_SIDE^2 bins of each map, row after row: the visible fraction of the bin times the cosine, summed over the points.
using WeighMaps = std::function<std::vector<float>(const GuideRepresentatives&)>;

/// Fills the tables guide_edges, guide_maps and guide_aliases without knowledge of the scene: everything is visible from
/// everywhere. These are maps 0 to GUIDE_FACES - 1.
void packUnlearnedGuide(LightTables& tables);

/// How a guide is learned.
struct GuideOptions {
    size_t rays = 0;                 ///< the most shadow rays
    bool hasAllDirections = false;   ///< also learn maps for points that gather light from all directions
    double openShare = 1;  ///< learning stops if a few maps show that clearly more than this fraction of the light arrives
};

/// Learns the guide's tables from `points` (those with zero normals are ignored). Along each axis, all intervals hold the same number of
/// points; the cell faces with the most points get maps of their own. If learning stops early, the guide stays unlearned. Deterministic.
/// Returns the fraction of the unoccluded environment's light that reaches the points, in [0, 1].
double learnGuide(LightTables& tables, std::span<const vec3> points, std::span<const vec3> normals, const GuideOptions& options,
                  const WeighMaps& weigh);

}  // namespace eikonal
