#pragma once
// Chooses the camera of an OBJ scene when the user gives none.

#include "scene/scene.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace eikonal {

/// A triangle in world space, and the shape that it belongs to.
struct ViewedTriangle { glm::vec3 a, b, c; std::uint32_t shape; };

/// The triangles of all triangle meshes of the scene.
std::vector<ViewedTriangle> viewedTriangles(const Scene& scene);

struct View {
    glm::dvec3 eye{0, 0, 1}, target{0}, up{0, 1, 0};
    double fov = 40;                        ///< degrees, along the shorter side of the image
    int width = 1024, height = 1024;        ///< of the image
};

/// What the user has decided.
struct ViewWishes {
    std::optional<glm::dvec3> eye, target;
    glm::dvec3 up{0, 1, 0};
    std::optional<double> fov;
    std::optional<int> width, height;
    std::optional<double> turns;  ///< how far the camera has gone round the target, about `up`; unset: it is to stay
};

/// Chooses everything that `wishes` leaves open:
///   - Direction: each candidate is rendered into a small depth buffer. The score is the mean over the shapes of the fraction of their area
///   that is visible, where area seen from behind counts half; the highest score wins. So a solid is seen from the right, front and above
///   (the first of equal candidates; the front is +z, or -y if z is up), and a box that is open in front is seen into. Views from the upper
///   corners of the interior are candidates, too; there, area seen from behind does not count. They win in closed rooms.
///   - Distance: as close as possible with every vertex in the image and a margin of 5 %. Interior views stay in their corner.
///   - Size: 1024 x 1024, or 1280 x 720 if the visible part is rather wide.
///   - With wishes.turns, distance and size suit the whole turn (turntable.h), and the camera begins outside of the model.
View chooseView(const std::vector<ViewedTriangle>& triangles, const ViewWishes& wishes);

/// pbrt's camera transform of the view: x right, y up, looking along +z.
Transform worldFromCamera(const View& view);

}  // namespace eikonal
