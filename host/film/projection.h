#pragma once
// Projects points to the image, and derives channels of the image from that.

#include "image/film_image.h"
#include "pack/tables.h"

#include <glm/glm.hpp>

#include <optional>

namespace eikonal {

/// Pixel coordinates (x to the right, y down, from the upper left corner of the whole image) of a point in camera space; nothing if the
/// camera does not see it. Ignores defocus. For a realistic camera, the paraxial projection through the centre of the stop.
std::optional<glm::dvec2> pixelOf(const PackedScene& scene, glm::dvec3 p);

/// The motion vector, in pixels, of a point of scene space that is at `opening` when the shutter opens and at `closing` when it closes.
/// Includes the camera's motion. Zero if the point is not seen at both times. If the image wraps around, the shorter way.
glm::dvec2 motionInImage(const PackedScene& scene, glm::dvec3 opening, glm::dvec3 closing);

/// The absolute change of camera-space z per pixel, to the right and down, on the plane through p with normal n (scene space), in the
/// middle of the shutter interval. Zero where the plane is seen edge on.
glm::dvec2 depthSlope(const PackedScene& scene, glm::dvec3 p, glm::dvec3 n);

/// The transform from world space to camera space, in the description's units, when the shutter opens.
glm::dmat4 cameraFromWorld(const PackedScene& scene);

/// Transforms positions and normals from world space to camera space (x to the right, y up, looking along +z): that of the middle of the
/// shutter interval, or, with CAMERA_SPACE, that of each sample's time.
void toCameraSpace(FilmImage& image, const PackedScene& scene);

}  // namespace eikonal
