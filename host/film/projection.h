#pragma once
// Where in the image a camera sees a point, and what that says of an image's channels.

#include "image/film_image.h"
#include "pack/tables.h"

#include <glm/glm.hpp>

#include <optional>

namespace eikonal {

/// Pixel coordinates (x to the right, y down, from the upper left corner of the whole image) at which the camera of a scene sees a point of
/// camera space, in focus or not; nothing if it is behind the camera. Of a realistic camera: by the ray through the middle of its stop,
/// near the axis.
std::optional<glm::dvec2> pixelOf(const PackedScene& scene, glm::dvec3 p);

/// How far in the image, in pixels, a point of scene space moves that is at `opening` when the shutter opens and at `closing` when it
/// closes, the camera's own motion included; zero where it is not seen at both times. The shorter way around a map of longitudes.
glm::dvec2 motionInImage(const PackedScene& scene, glm::dvec3 opening, glm::dvec3 closing);

/// How much z of camera space changes from one pixel to the next, to the right and down, on the plane through p with normal n, both in
/// scene space, in the middle of the shutter's time; without its sign. Zero where the plane is seen edge on.
glm::dvec2 depthSlope(const PackedScene& scene, glm::dvec3 p, glm::dvec3 n);

/// Turns positions and normals from world space to that of the camera (x to the right, y up, looking along +z) in the middle of the
/// shutter's time.
void toCameraSpace(FilmImage& image, const PackedScene& scene);

}  // namespace eikonal
