#pragma once
// The contents of leaves.

#include "bvh/box.h"
#include "bvh/build.h"

#include <optional>
#include <span>

namespace eikonal {

/// What a hierarchy is built of.
struct Sources {
    std::span<const TriangleRange> triangles;
    std::span<const BoxedElement> others;

    size_t size() const;
    /// A reference to element i of all, triangles first; nothing if it is to be dropped (see BvhRoot::dropped).
    std::optional<Reference> reference(uint range, size_t i) const;
    std::optional<Reference> reference(size_t other) const;
};

/// Appends the contents of a leaf to the tables and returns the leaf's reference. The references fit a leaf (Range::fitsLeaf).
/// An instance needs no room in the tables: its number is in the leaf's reference.
uint appendLeaf(BvhTables& tables, const Sources& sources, std::span<const Reference> references);

/// Sets child `lane` of a node: its box, padded, and where it leads.
void setChild(bvh_node& node, int lane, const WideBox& box, uint child);

}  // namespace eikonal
