#pragma once
// Cutting a range of references in two.

#include "bvh/box.h"

#include <span>
#include <utility>

namespace eikonal {

/// Cuts where the surface area heuristic is least, among the borders of up to 32 bins an axis; in the middle where all
/// centroids are equal. Reorders the range's references; each half has at least one. range.size() >= 2.
std::pair<Range, Range> splitByCost(std::span<Reference> references, const Range& range);

/// Cuts in halves of equal number, along the axis where the centroids are widest apart: for a bounded depth.
std::pair<Range, Range> splitInHalves(std::span<Reference> references, const Range& range);

/// All there is to know of references [begin, end).
Range measureRange(std::span<const Reference> references, uint begin, uint end);

}  // namespace eikonal
