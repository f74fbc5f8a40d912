#pragma once
// What the traversal benchmark traces: meshes of a chosen size, and rays of three kinds.

#include "eikonal/portable.h"

#include <string>
#include <vector>

namespace eikonal {

struct BenchMesh {
    std::string name;
    std::vector<vec3> positions;
    std::vector<uint> indices;   ///< three a triangle
    vec3 eye, target;            ///< where to look from and to
    vec3 lightLow, lightHigh;    ///< box of random light points
    size_t triangles() const { return indices.size() / 3; }
};

/// A box with two blocks and a lamp in it: 36 triangles.
BenchMesh makeBox();
/// About `triangles` triangles: half a rugged terrain, half clutter of bumpy stones in all sizes above and in it.
BenchMesh makeTerrain(size_t triangles);
/// About `triangles` triangles: a sphere with bumps down to the size of its triangles, seen from near by, in front of a wall.
BenchMesh makeBall(size_t triangles);

/// The triangles of a scene file that are in no object, seen by its camera. Lights: anywhere in the scene's box. Throws as the readers do.
BenchMesh loadMesh(const std::string& path);

struct BenchRay { vec3 o, d; float tMax; };
/// Where a ray ended: t < 0 if nowhere.
struct BenchHit { float t; uint element; };

/// width * height rays through the pixels, row after row.
std::vector<BenchRay> primaryRays(const BenchMesh& mesh, int width, int height);
/// From each hit into a random direction, cosine-distributed around the normal. Misses have none.
std::vector<BenchRay> bouncedRays(const BenchMesh& mesh, const std::vector<BenchRay>& rays, const std::vector<BenchHit>& hits);
/// From each hit to a random point of the light box.
std::vector<BenchRay> shadowRays(const BenchMesh& mesh, const std::vector<BenchRay>& rays, const std::vector<BenchHit>& hits);

}  // namespace eikonal
