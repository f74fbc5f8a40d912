#pragma once
// How much work each row of an image is, estimated by pilot paths, so that parts can be divided to take about the same time.

#include "render/device_scene.h"
#include "render/wave.h"

#include <cstdint>
#include <vector>

namespace eikonal {

/// Of each row of `rows`, which is counted from the top of the whole image: how many rays some paths of it have, all at the same number of
/// pixels, shadow rays not counted; at least 1. Whole numbers that depend on the scene and the kind of device alone: not on the seed, the
/// samples, the threads or the part to render.
std::vector<std::uint64_t> estimateRowCosts(const Context& context, DeviceScene& tables, const PackedScene& scene, const PixelRect& rows,
                                            Wave& wave);

}  // namespace eikonal
