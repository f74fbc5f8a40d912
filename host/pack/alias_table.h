#pragma once
// Choosing one of many by weight in constant time, as kernels/light/alias.clh does.

#include "eikonal/light.h"
#include "memory_pages.h"

#include <span>
#include <vector>

namespace eikonal {

/// An alias table (Vose 1991) over weights, of which at least one is positive. pmf is filled in.
Table<alias_entry> makeAliasTable(const std::vector<double>& weights);

/// The alias tables of a square of side x side weights, row after row: one entry a row, then the entries of each row
/// (kernels/light/alias_square.clh).
Table<alias_entry> makeAliasSquare(std::span<const double> weights, size_t side);

}  // namespace eikonal
