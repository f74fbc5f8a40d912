#pragma once
// How much of an image, roughly, each part of the scene may fill.

#include "pack/space.h"
#include "scene/scene.h"

#include <map>
#include <vector>

namespace eikonal {

/// What is known of shapes from their bounding boxes alone.
struct Extent {
    double area = 0;     ///< of surface, world space
    double sight = 0;    ///< solid angle that is seen from the camera, as a part of the sphere; at most 1 for each shape
    double chord = 0;    ///< the mean length of a line through the largest
    Extent& operator+=(const Extent& b);
    Extent operator*(double count) const;   ///< of so many shapes
};

/// The solid angle of a box that is seen from a point, as a part of the sphere; 1 inside.
double sightOf(const Box& box, glm::dvec3 eye);

struct SceneExtents {
    std::map<int, Extent> materials, areaLights, media;   ///< by index in the scene; of media: the shapes that they are in
    double radius = 1;                                    ///< of the scene without distant shapes
};

/// near: of the scene's bounds (pack/scene_bounds.h). Of an object that would be placed as more than a million shapes, only every so many
/// places are looked at, and count for the others.
SceneExtents extentsOf(const Scene& scene, const Box& near);

}  // namespace eikonal
