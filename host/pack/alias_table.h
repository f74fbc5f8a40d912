#pragma once
// Alias tables: sample one of many by weight in constant time (kernels/light/alias.clh).

#include "eikonal/light.h"
#include "memory_pages.h"

#include <span>

namespace eikonal {

/// An alias table (Vose 1991) over weights; at least one must be positive. Fills in pmf, too.
Table<alias_entry> makeAliasTable(std::span<const double> weights);

/// The alias tables of side x side weights, row after row: one entry per row, then the entries of each row
/// (kernels/light/alias_square.clh).
Table<alias_entry> makeAliasSquare(std::span<const double> weights, size_t side);
/// The same into `square`, of side + side * side entries.
void fillAliasSquare(std::span<alias_entry> square, std::span<const double> weights, size_t side);

}  // namespace eikonal
