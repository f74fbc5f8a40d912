#pragma once
// What the space of a scene is chosen for: floats are precise near its origin, and a few distant shapes must not move it away from what
// the image shows.

#include "pack/space.h"
#include "scene/scene.h"

#include <functional>
#include <span>
#include <vector>

namespace eikonal {

struct SceneBounds {
    Box all;    ///< everything placed in the scene, world space
    Box near;   ///< the same without distant shapes that would cost the others their precision; mostly equal to `all`
};

/// A shape or an instance.
struct PlacedBox {
    Box box;            ///< world space
    double sight = 0;   ///< solid angle that is seen from the camera
};

/// Of the boxes nearest to the eye, as many as can share an origin: all, unless rounding at the centre of all is more than a few times
/// what it could be for the sizes of the boxes, weighted by sight.
Box nearBox(std::span<const PlacedBox> boxes, glm::dvec3 eye);

SceneBounds boundsOf(const Scene& scene);

/// The bounds of the shapes that `counts` in world space, at each place of their object.
std::vector<Box> boxesOf(const Scene& scene, const std::function<bool(const Shape&)>& counts);

/// The space of a scene: that of `near`, but with all coordinates below 2^40.
SceneSpace spaceOf(const SceneBounds& bounds);

}  // namespace eikonal
