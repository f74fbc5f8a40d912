#pragma once
// Which scenes light paths are traced in (docs/integrators.md).

#include "pack/context.h"

#include <string>

namespace eikonal {

/// Why no light paths are traced in this scene, as a clause: "its camera is spherical". Empty: they are.
std::string lightPathObstacle(const PackContext& context);

}  // namespace eikonal
