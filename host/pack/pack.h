#pragma once
// From a scene's description to the device's tables.

#include "diagnostics.h"
#include "pack/tables.h"
#include "scene/scene.h"

namespace eikonal {

/// Loads the scene's images, moves everything to scene space, builds the hierarchy and fills every table.
/// Throws SceneError for what the description cannot mean; warns about what is left out.
PackedScene packScene(const Scene& scene, Diagnostics& diagnostics);

}  // namespace eikonal
