#pragma once
// Surveys a scene before it is rendered, to find the parts of an environment that its surfaces see.

#include "render/device_scene.h"
#include "render/stages.h"

namespace eikonal {

/// Fills the environment guide of a scene that has one (Feature::ENVIRONMENT_GUIDE), on the device. Takes a few percent of the time for all
/// samples of the whole image; does nothing for short renders. The result depends on the scene and its samples only, not on the part of
/// the image that is rendered.
void surveyEnvironment(const Context& context, DeviceScene& scene, const PackedScene& packed, const Stages& stages,
                       const StageShape& shape);

}  // namespace eikonal
