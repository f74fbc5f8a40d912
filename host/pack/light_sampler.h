#pragma once
// How a light is chosen to be sampled: by an alias table, or by a light tree.

#include "pack/context.h"

#include <span>
#include <vector>

namespace eikonal {

/// The share of all power that no light falls short of when one is chosen by power: power does not tell which lights are hidden.
double leastPower(std::span<const double> powers);
/// Gives it to those that have less, but for those that have none.
void raiseToLeastPower(std::span<double> powers);

/// Sets the probability of each light, and the alias table or tree, unless there is nothing to sample. powers[i] is the power of light i;
/// those from firstInfinite on are infinitely far away.
void packLightSampler(const PackContext&, LightTables&, settings& frame, std::vector<double> powers, size_t firstInfinite);

}  // namespace eikonal
