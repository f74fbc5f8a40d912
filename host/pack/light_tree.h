#pragma once
// The light tree (kernels/light/tree.clh): Conty Estevez and Kulla 2018, "Importance sampling of many lights with adaptive tree splitting".

#include "eikonal/light.h"
#include "memory_pages.h"
#include "pack/space.h"

#include <vector>

namespace eikonal {

/// Up to so many lights are chosen by power: a tree would cost more time than it saves noise (docs/lights.md).
constexpr size_t fewLights = 3;

/// Bounds of the positions and the emission directions of some lights. Scene space, angles in radians.
struct LightBounds {
    Box box;
    glm::dvec3 axis{0, 0, 1};   ///< of a cone that bounds their normals
    double normals = 0;         ///< half angle of the cone, in [0, pi]
    double emission = 0;        ///< largest angle of emission from a normal, in (0, pi/2]
    double intensity = 0;       ///< sum of luminous intensities along the normals
    bool twoSided = false;      ///< some emit on both sides
};

/// The tree bounds emission by cosines, which fall off gradually, so lights with sharp edges get at least `leastEmission`. Radians.
constexpr double leastEmission = 0.05, mostFallOff = 1.4;
/// The angle between two unit vectors.
double angleBetween(glm::dvec3 a, glm::dvec3 b);

/// The bounds of a packed finite light with total `power`.
LightBounds boundsOfLight(const light& l, double power);
/// The union of two bounds. Either may have no intensity.
LightBounds unite(const LightBounds& a, const LightBounds& b);

/// A tree over lights[i], where i is the index of the light; lights without intensity are left out. O(n log n).
struct LightTree {
    Table<light_node> nodes;   ///< empty: no light has any intensity
    std::vector<uint> leaves;        ///< of each light: node * LIGHT_TREE_WIDTH + child, or NONE
    size_t lights = 0;               ///< number of lights in the tree
    int depth = 0;                   ///< nodes on the longest path from the root
};
LightTree buildLightTree(const std::vector<LightBounds>& lights);

}  // namespace eikonal
