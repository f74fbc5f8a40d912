#pragma once
// Pilot paths: a small sample of the render's paths, traced first to choose the rule of Russian roulette.

#include "render/wave.h"
#include "scene/integrator.h"

#include <optional>

namespace eikonal {

/// Chooses the most efficient rule for this scene (render/roulette.h), sets it in the scene's settings, and returns it. Returns nothing
/// if the scene specifies a rule, if its paths are too short for roulette, or if the render is too short for a pilot (fewer than 2^20
/// paths, or fewer than 64 pilot pixels). The choice depends on the scene, its resolution and its samples, but not on the seed or on the
/// part of the image that is rendered, so estimates stay unbiased. Devices may choose differently between nearly equal rules. `wave`
/// renders `scene`.
std::optional<Roulette> pilotRoulette(const Context& context, DeviceScene& scene, const PackedScene& packed, Wave& wave);

}  // namespace eikonal
