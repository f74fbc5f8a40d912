#pragma once
// How the light is chosen that a point is lit by: an alias table, or a tree.

#include "pack/context.h"

#include <vector>

namespace eikonal {

/// The probability of each light of `lights`, of which powers[i] is what light i emits in all, and those from firstInfinite on are
/// infinitely far away; and the table or tree to choose them by, unless there is nothing to sample.
void packLightSampler(const PackContext&, LightTables&, settings& frame, std::vector<double> powers, size_t firstInfinite);

}  // namespace eikonal
