#pragma once
// Pilot paths: a few of a render's, traced before it begins, by which its rule of Russian roulette is chosen.

#include "render/device_scene.h"
#include "render/tracer.h"
#include "scene/integrator.h"

namespace eikonal {

/// Has kernels end paths by the rule that pays best in this scene (render/roulette.h) where the scene leaves that open, and returns it; otherwise, or where the
/// render is too short (less than 2^20 paths), returns the scene's. Depends on the scene, its resolution and its samples only, neither on its seed
/// nor on which part of the image is rendered: estimates stay unbiased. `wave` renders `scene`.
Roulette pilotRoulette(const Context& context, DeviceScene& scene, const PackedScene& packed, Tracer& wave);

}  // namespace eikonal
