#pragma once
// The light tree (kernels/light/tree.clh): Conty Estevez and Kulla 2018, "Importance sampling of many lights with adaptive tree splitting".

#include "eikonal/light.h"
#include "memory_pages.h"
#include "pack/space.h"

#include <vector>

namespace eikonal {

/// Up to so many lights that can be sampled they are chosen by power: a tree costs more time than it saves noise (docs/lights.md).
constexpr size_t fewLights = 3;

/// Where some lights are, and which way they shine. Scene space, angles in radians.
struct LightBounds {
    Box box;
    glm::dvec3 axis{0, 0, 1};   ///< of a cone that holds their normals
    double normals = 0;         ///< its angle, in [0, pi]
    double emission = 0;        ///< how far from its normal a light shines, in (0, pi/2]
    double intensity = 0;       ///< sum of luminous intensities along the normals
    bool twoSided = false;      ///< some shine on both sides
};

/// A light that does not fade towards its edge still needs some room there, since the tree bounds emission by cosines. Radians.
constexpr double leastEmission = 0.05, mostFallOff = 1.4;
/// Radians between two unit vectors.
double angleBetween(glm::dvec3 a, glm::dvec3 b);

/// Those of a packed light that is not infinitely far away and emits `power` in all.
LightBounds boundsOfLight(const light& l, double power);
/// Those of both. Either may be without intensity.
LightBounds unite(const LightBounds& a, const LightBounds& b);

/// A tree over lights[i], each the light of that number; those without intensity are left out. O(n log n).
struct LightTree {
    Table<light_node> nodes;   ///< empty: no light has any intensity
    std::vector<uint> leaves;        ///< of each light: node * LIGHT_TREE_WIDTH + child, or NONE
    size_t lights = 0;               ///< how many it holds
    int depth = 0;                   ///< nodes on the longest way down
};
LightTree buildLightTree(const std::vector<LightBounds>& lights);

}  // namespace eikonal
