#pragma once
// The contents of leaves.

#include "bvh/box.h"
#include "bvh/build.h"

#include <optional>
#include <span>

namespace eikonal {

/// The elements of a hierarchy.
struct Sources {
    std::span<const TriangleRange> triangles;
    std::span<const BoxedElement> others;

    size_t size() const;
    /// The reference to triangle i of range `range`, or to element `other` that is not a triangle; nothing if it is dropped (see
    /// BvhRoot::dropped).
    std::optional<Reference> reference(uint range, size_t i) const;
    std::optional<Reference> reference(size_t other) const;
};

/// Appends a leaf's contents to the tables and returns the leaf's reference. The references must fit a leaf (Range::fitsLeaf). An instance
/// needs no table entry: its number is in the leaf's reference.
uint appendLeaf(BvhTables& tables, const Sources& sources, std::span<const Reference> references);

/// Sets child `lane` of a node: its box, which gets padded, and its reference.
void setChild(bvh_node& node, int lane, const WideBox& box, uint child);

}  // namespace eikonal
