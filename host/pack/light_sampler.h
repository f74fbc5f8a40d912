#pragma once
// How a light is chosen to be sampled: by an alias table, or by a light tree.

#include "pack/context.h"

#include <vector>

namespace eikonal {

/// Sets the probability of each light, and the alias table or tree, unless there is nothing to sample. powers[i] is the power of light i;
/// those from firstInfinite on are infinitely far away.
void packLightSampler(const PackContext&, LightTables&, settings& frame, std::vector<double> powers, size_t firstInfinite);

}  // namespace eikonal
