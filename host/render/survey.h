#pragma once
// A survey of a scene before it is rendered: which parts of an environment its surfaces see.

#include "render/device_scene.h"
#include "render/stages.h"

namespace eikonal {

/// Fills the environment guide of a scene that has one (Feature::ENVIRONMENT_GUIDE), on the device. Takes a few hundredths of the time of a
/// render of all samples of the whole image; where that is short, nothing is learnt. Depends on the scene and its samples only, not on
/// which part of the image is rendered.
void surveyEnvironment(const Context& context, DeviceScene& scene, const PackedScene& packed, const Stages& stages,
                       const StageShape& shape);

}  // namespace eikonal
