#pragma once
// Views of a model from all sides: the camera goes round an axis, through the point that it looks at. What is chosen suits the whole turn.

#include "read/obj/view.h"

namespace eikonal {

/// The smallest distance of the camera from the target at which every vertex is in the image throughout the turn, with a margin of 5 %.
/// halfTangents: of the angles from the middle of the image to its border. size: of the model.
double turningDistance(const std::vector<ViewedTriangle>& triangles, const View& view, glm::dvec2 halfTangents, double size);

/// Whether what the model sweeps over during the turn is wider in the image than `ratio` times its height.
bool isTurnWider(const std::vector<ViewedTriangle>& triangles, const View& view, double ratio);

/// The position of the camera after so many turns, counter-clockwise as seen from above.
glm::dvec3 turnedEye(const View& view, double turns);

}  // namespace eikonal
