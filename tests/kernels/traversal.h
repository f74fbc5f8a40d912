#pragma once
// Rays through scenes of random shapes: the nearest hits, and whether anything blocks them.

#include "eikonal/stages.h"
#include "kinds/shape_kind.h"
#include "pack/tables.h"
#include "random_inputs.h"
#include "scene/scene.h"

#include <memory>
#include <vector>

namespace eikonal {

struct Ray { vec3 o, d; float tMax = FAR_AWAY; };
struct Hit { float t; uint element, instance; float u, v; };

/// By intersect_rays.
std::vector<Hit> trace(const PackedScene& scene, const std::vector<Ray>& rays);
/// By test_shadows.
std::vector<bool> blocked(const PackedScene& scene, const std::vector<Ray>& rays);

PackedScene pack(const Scene& scene);

static inline glm::vec3 toGlm(vec3 v) { return {v.x, v.y, v.z}; }

/// A turned, stretched axis system of about `size`, within [-1, 1]^3.
glm::dmat4 randomTransform(Random& random, double size);
Shape placed(Shape s, const glm::dmat4& m);
Shape randomTriangles(Random& random, size_t count);
/// A closed surface around the origin: an octahedron, each edge in `steps` parts, on the sphere or left flat.
std::shared_ptr<Mesh> closedMesh(int steps, bool round);

Scene triangleScene();
Scene mixedScene();
Scene curveScene();
/// Two objects, of triangles and of everything, many times, turned and stretched; and some shapes of the world.
Scene instancedScene();

/// Random rays; one in eight parallel to an axis or a plane of axes, also with a negative zero.
std::vector<Ray> randomRays(size_t count, std::uint64_t seed);

}  // namespace eikonal
