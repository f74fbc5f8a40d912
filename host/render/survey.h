#pragma once
// Surveys a scene before it is rendered: from which parts of an environment light reaches its surfaces, and how large they appear.

#include "pack/merge_radius.h"
#include "render/device_scene.h"
#include "render/stages.h"

namespace eikonal {

/// Fills the environment guide of a scene that has one (Feature::ENVIRONMENT_GUIDE), on the device. Takes a few percent of the time for all
/// samples of the whole image; does nothing for short renders. The result depends on the scene and its samples only, not on the part of
/// the image that is rendered.
void surveyEnvironment(const Context& context, DeviceScene& scene, const PackedScene& packed, const Stages& stages,
                       const StageShape& shape);

/// What `paths` paths from the camera see first: of each that gets there, a point on the first surface, straight or through clear glass.
/// Of a scene with Feature::MERGING or ENVIRONMENT_GUIDE. Depends on the scene and its resolution only, as above.
SurfacePoints surveyView(const Context& context, const DeviceScene& scene, const Stages& stages, const StageShape& shape, size_t paths);

}  // namespace eikonal
