#pragma once
// What each row of an image costs to render, so that it can be divided into parts that take about the same time.

#include "render/traversal_steps.h"
#include "render/wave.h"

#include <cstdint>
#include <vector>

namespace eikonal {

/// Of each row of `rows`, which is counted from the top of the whole image: the cost of some paths, of as many in each row; at least 1. In
/// steps of traversal; rays and what they meet count as such, and light paths and steps through media do not. Whole numbers that depend
/// on the scene, `frame` and the kind of device alone: not on the seed, the threads, the wave or the part to render. frame: the settings
/// that the render has, which the tables keep.
std::vector<std::uint64_t> estimateRowCosts(const Context& context, DeviceScene& tables, const PackedScene& scene, const settings& frame,
                                            const PixelRect& rows, const TraversalSteps& steps, Wave& wave);

}  // namespace eikonal
