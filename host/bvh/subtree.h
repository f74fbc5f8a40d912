#pragma once
// Builds the lower part of a hierarchy, over a range of references small enough for one thread.

#include "bvh/leaf.h"

namespace eikonal {

/// A finished part of a hierarchy with its own numbering from 0 of nodes, lines and leaf elements.
struct Subtree {
    BvhTables tables{{}, {}, {}};
    uint root = NONE;    ///< node 0, or a leaf
    int depth = 0;       ///< nodes on the longest path from the root
    double cost = 0;     ///< sum over all nodes and leaves of area times visiting cost, in units of a node test
    size_t leaves = 0;
};

/// Depth in nodes when a range of `count` references is only split in halves.
int balancedDepth(uint count);

/// Builds a subtree of depth at most `maxDepth`, which must be at least balancedDepth(range.size()). alwaysNode: the root is a node even if
/// a leaf would suffice.
Subtree buildSubtree(const Sources& sources, std::span<Reference> references, const Range& range, int maxDepth, bool alwaysNode);

}  // namespace eikonal
