#pragma once
// A daylight environment for scenes without lights.

#include "scene/scene.h"

#include <glm/glm.hpp>

namespace eikonal {

/// Adds an environment: a blue gradient above a pale horizon, grey-brown ground below, and a warm sun, 45 degrees high and 10 degrees wide
/// for soft shadows. The sun is to the left behind a viewer in direction `towardsViewer`. A white horizontal surface in the open has a
/// radiance of about 0.8.
void addSky(Scene& scene, glm::dvec3 up, glm::dvec3 towardsViewer);

/// The radiance of that sky (linear sRGB) from a unit direction in its own space: z is up, the viewer towards +x.
glm::dvec3 skyRadiance(glm::dvec3 direction);

}  // namespace eikonal
