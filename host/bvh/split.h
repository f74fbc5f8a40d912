#pragma once
// Splits a range of references in two.

#include "bvh/box.h"

#include <span>
#include <utility>

namespace eikonal {

/// Splits where the surface area heuristic is lowest, among the borders of up to 32 bins per axis; in the middle if all centroids are
/// equal. Reorders the references; neither half is empty. Needs range.size() >= 2.
std::pair<Range, Range> splitByCost(std::span<Reference> references, const Range& range);

/// Splits into halves of equal count along the axis with the largest extent of centroids, which bounds the depth.
std::pair<Range, Range> splitInHalves(std::span<Reference> references, const Range& range);

/// Measures references [begin, end).
Range measureRange(std::span<const Reference> references, uint begin, uint end);

}  // namespace eikonal
