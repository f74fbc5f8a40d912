#pragma once
// Choosing one of many by weight in constant time, as kernels/light/alias.clh does.

#include "eikonal/lights.h"
#include "memory_pages.h"

#include <vector>

namespace eikonal {

/// An alias table (Vose 1991) over weights, of which at least one is positive. pmf is filled in.
Table<alias_entry> makeAliasTable(const std::vector<double>& weights);

}  // namespace eikonal
