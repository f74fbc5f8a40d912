#pragma once
// The environment guide (include/eikonal/light.h): for each place in the scene, from which directions an environment that is the same
// everywhere can be seen.

#include "eikonal/light.h"
#include "pack/tables.h"

#include <functional>
#include <span>
#include <vector>

namespace eikonal {

/// What a survey may take of the time of a render of all samples of the whole image: a few hundredths.
struct GuideBudget {
    size_t paths = 0;   ///< to follow
    size_t rays = 0;    ///< shadow rays
    /// Whether anything can be learnt.
    bool isEnough() const;
    static GuideBudget of(uint width, uint height, int samples);
};

/// Points for the maps of a guide: `perMap` of them for each, map after map, and their normals (zero length: all directions), scene space.
struct GuideRepresentatives {
    std::vector<vec3> points, normals;
    size_t maps = 0, perMap = 0;
};

/// For GUIDE_SIDE^2 bins of each map, row after row: the sum over its points of how much of the bin is seen, in [0, 1], times the cosine.
using WeighMaps = std::function<std::vector<float>(const GuideRepresentatives&)>;

/// Fills the tables guide_edges, guide_maps and guide_aliases as far as they are known without a look at the scene: all of the environment
/// is seen from everywhere. Maps 0 to GUIDE_FACES - 1.
void packUnlearnedGuide(LightTables& tables);

/// How a guide is learnt.
struct GuideOptions {
    size_t rays = 0;                 ///< shadow rays, at most
    bool hasAllDirections = false;   ///< also maps for points that look in all directions
    double openShare = 1;  ///< learning ends where a look at a few maps shows that clearly more than this share of the light arrives
};

/// Fills the guide's tables with what is learnt from `points` (with normals; those of zero length are no points). Cells are cut so that
/// each axis has as many points in each interval; the faces of cells with the most points get maps of their own. Where learning ends early,
/// the guide stays unlearned. The same points give the same tables. Returns the share of the light of an environment without a scene that
/// reaches the points, in [0, 1].
double learnGuide(LightTables& tables, std::span<const vec3> points, std::span<const vec3> normals, const GuideOptions& options,
                  const WeighMaps& weigh);

}  // namespace eikonal
