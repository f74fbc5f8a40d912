#pragma once
// The path guide (include/eikonal/light.h): by place in the scene, the directions that light comes from, learned from recorded paths.

#include "eikonal/portable.h"
#include "pack/tables.h"

#include <algorithm>
#include <span>

namespace eikonal {

/// A vertex of a path, and what its scattered ray brought. Scene space.
struct GuideRecord {
    vec3 p, n;       ///< n: shading normal on the side of the path
    vec3 d;          ///< direction of the scattered ray, unit length
    float light;     ///< radiance estimate along d, >= 0: weighted as in the path, so without what light samples find
    float pdf;       ///< with which d was sampled, per solid angle, > 0
};

/// The guide knows no place: no direction is sampled by it.
void packUnlearnedPathGuide(LightTables& tables);

/// How many of the render's paths are pilot paths: this share, of which each round takes twice as many as the one before.
constexpr double guidePilotShare = 0.04;
constexpr double mostGuidePilotPaths = 1 << 18, fewestGuidePilotPaths = 1 << 13;
/// The pilot paths of a render of so many paths; 0: too few to learn from.
constexpr size_t guidePilotPaths(double paths) {
    const double wanted = std::min(paths * guidePilotShare, mostGuidePilotPaths);
    return wanted < fewestGuidePilotPaths ? 0 : static_cast<size_t>(wanted);
}

/// Learns the guide's tables from `records`. Trees are cut at medians until a leaf has too few records with light; a map is proportional to
/// the light from each direction times the cosine at the surface. hasAllDirections: some surfaces are lit from both sides. Deterministic.
/// Returns the number of maps.
size_t learnPathGuide(LightTables& tables, std::span<const GuideRecord> records, bool hasAllDirections);

/// Density over solid angle with which map `map` of the guide samples d (kernels/light/path_guide.clh). map > 0.
double pdfOfGuide(const LightTables& tables, uint map, const vec3& d);

}  // namespace eikonal
