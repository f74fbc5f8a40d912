#pragma once
// Which scenes light paths are traced in (docs/integrators.md).

#include "pack/context.h"

#include <string>

namespace eikonal {

/// Why no light paths are traced in this scene, as a clause: "its film keeps spectra". Empty: they are.
std::string lightPathObstacle(const PackContext& context);

/// Has light paths traced, because of `why`. Before the lights are packed.
void requireLightPaths(const PackContext& context, const std::string& why);
/// The same for an integrator that leaves it to the scene, once its surfaces and area lights are packed: if paths from the camera miss
/// light, and nothing stands in the way. The same for merging their vertices.
void chooseLightPaths(const PackContext& context, PackedScene& packed);

}  // namespace eikonal
