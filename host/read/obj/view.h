#pragma once
// Where to look at a scene from, when nobody said.

#include "scene/scene.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace eikonal {

/// Triangles in world space, by the shape that they belong to.
struct ViewedTriangle { glm::vec3 a, b, c; std::uint32_t shape; };

/// The triangles of all triangle meshes of the scene.
std::vector<ViewedTriangle> viewedTriangles(const Scene& scene);

struct View {
    glm::dvec3 eye{0, 0, 1}, target{0}, up{0, 1, 0};
    double fov = 40;                        ///< degrees, along the shorter side of the image
    int width = 1024, height = 1024;        ///< of the image
};

/// What is already decided.
struct ViewWishes {
    std::optional<glm::dvec3> eye, target;
    glm::dvec3 up{0, 1, 0};
    std::optional<double> fov;
    std::optional<int> width, height;
};

/// Chooses what the wishes leave open:
/// - The direction: each of several is tried with a small depth buffer, and the one wins that sees most of the surfaces: the mean over the
///   shapes of the fraction of their area that is visible; area seen from behind counts half. So a solid is seen from its right, front and
///   above (the first among equals; the front is +z, or -y if z is up), and a box that is open in front is looked into. Also tried are the
///   inside's upper corners, where area seen from behind counts nothing: they win in closed rooms.
/// - The distance: as near as shows every vertex, with a margin of 5 %. Inside, the eye stays in its corner.
/// - The size: 1024 x 1024, or 1280 x 720 if what is seen is rather wide.
View chooseView(const std::vector<ViewedTriangle>& triangles, const ViewWishes& wishes);

/// pbrt's camera of that view: x right, y up, looking along +z.
Transform worldFromCamera(const View& view);

}  // namespace eikonal
