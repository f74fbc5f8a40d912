#pragma once
// The environment guide (include/eikonal/light.h): by place in the scene, the openings through which a uniform environment is visible.

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

/// What a survey can ask a scene. The tables are those of the guide, as far as it is learnt.
struct SurveyRays {
    /// For `count` rays from all points, cosine distributed: the texel of the guide's box through which each leaves;
    /// GUIDE_BOX_TEXELS: it misses the box; NONE: blocked.
    std::function<std::vector<uint>(const LightTables&, size_t count)> exits;
    /// For each opening of each map, two numbers: what arrives through it, and what would if nothing were in the way (as
    /// kernels/stages/survey_environment.cl says).
    std::function<std::vector<float>(const LightTables&, const GuideRepresentatives&)> weigh;
};

/// Fills the guide's tables without knowledge of the scene: there are no openings, and every place has a map of density 0, number 0.
void packUnlearnedGuide(LightTables& tables);

/// How a guide is learned.
struct GuideOptions {
    size_t rays = 0;                 ///< the most shadow rays
    bool hasAllDirections = false;   ///< also learn maps for points that gather light from all directions
    double openShare = 1;  ///< learning stops if a few rays show that clearly more than this fraction of the light arrives
};

/// Learns the guide's tables from `points`, whose normals are not zero. Along each axis, all intervals hold the same number of points; the
/// cell faces with the most points get maps of their own, and all others share map 0, which has the openings by the rays that leave through
/// them. If learning stops early, the guide stays unlearned. Deterministic.
/// Returns the fraction of the unoccluded environment's light that reaches the points, in [0, 1]; 1 if there are none.
double learnGuide(LightTables& tables, std::span<const vec3> points, std::span<const vec3> normals, const GuideOptions& options,
                  const SurveyRays& survey);

}  // namespace eikonal
