#pragma once
// Pilot paths: a few of a render's, traced before it begins, by which its rule of Russian roulette is chosen.

#include "render/wave.h"
#include "scene/integrator.h"

#include <optional>

namespace eikonal {

/// Has kernels end paths by the rule that pays best in this scene (render/roulette.h), and returns it. None where the scene says by which
/// rule, where paths are too short for one, and where the render is too short to be worth a pilot (less than 2^20 paths, or pilot paths for
/// less than 64 pixels). Depends on the scene, its resolution and its samples, neither on its seed nor on which part of the image is
/// rendered: estimates stay unbiased. Another device may choose another rule where two are nearly as good. `wave` renders `scene`.
std::optional<Roulette> pilotRoulette(const Context& context, DeviceScene& scene, const PackedScene& packed, Wave& wave);

}  // namespace eikonal
