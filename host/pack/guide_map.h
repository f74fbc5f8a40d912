#pragma once
// The maps of the environment guide: a probability for each opening (kernels/light/guide_map.clh).

#include "eikonal/portable.h"

#include <span>

namespace eikonal {

/// Writes a map of GUIDE_OPENINGS weights, whose sum is positive. What weighs anything gets at least one unit.
void writeGuideMap(std::span<uint> words, std::span<const double> weights);
/// The map of a place that sees no opening: all probabilities are 0.
void writeDarkGuideMap(std::span<uint> words);

/// The probability of an opening in a map.
double openingProbability(std::span<const uint> words, size_t opening);

}  // namespace eikonal
