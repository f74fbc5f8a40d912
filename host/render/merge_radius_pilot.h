#pragma once
// A first look at a scene whose light paths merge with those from the camera: how far they should.

#include "render/wave.h"

#include <optional>

namespace eikonal {

/// The radius of the first pass (pack/merge_radius.h), scene units; nothing if the camera sees too little to tell. Follows some thousand
/// paths from both ends. Depends on the scene and its resolution, but not on its seed, its samples, or the part that is rendered. The
/// settings on the device are those of `packed` afterwards. `wave` renders `scene` with `stages`; its vertices are lost.
std::optional<double> pilotMergeRadius(const Context& context, DeviceScene& scene, const PackedScene& packed, const Stages& stages,
                                       const StageShape& shape, Wave& wave);

}  // namespace eikonal
