#pragma once
// Bounds on the function of an implicit surface over a box, on the host.

#include "eikonal/shape.h"
#include "pack/space.h"

#include <optional>
#include <span>

namespace eikonal {

/// The numbers from `low` to `high`. Magnitudes above 1e35 are infinite, as on the device.
struct ValueRange {
    double low, high;
    bool hasZero() const { return low <= 0 && high >= 0; }
    double middle() const { return 0.5 * (low + high); }
};

/// Bounds on what a program (pack/implicit.h) computes over a box; none if it is undefined everywhere in it. They contain what the device
/// finds by interval arithmetic in single precision (kernels/shape/wide_range.clh): each operation is widened by more than there.
std::optional<ValueRange> boundsOver(std::span<const implicit_instruction> program, const Box& box);

}  // namespace eikonal
