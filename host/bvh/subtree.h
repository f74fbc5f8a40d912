#pragma once
// The lower part of a hierarchy: a range of references small enough for one thread.

#include "bvh/leaf.h"

namespace eikonal {

/// A finished part of a hierarchy, numbered on its own: node, block and leaf element 0 are its first.
struct Subtree {
    BvhTables tables{{}, {}, {}};
    uint root = NONE;    ///< its node 0, or a leaf
    int depth = 0;       ///< nodes on the longest way down
    double cost = 0;     ///< sum of the areas of all nodes and leaves, each with what a visit costs in tests of a node
    size_t leaves = 0;
};

/// Nodes on the longest way down when a range of `count` is cut in halves all the way.
int balancedDepth(uint count);

/// Builds at most `maxDepth` >= balancedDepth(range.size()) nodes deep. alwaysNode: the root is a node even if a leaf would do.
Subtree buildSubtree(const Sources& sources, std::span<Reference> references, const Range& range, int maxDepth, bool alwaysNode);

}  // namespace eikonal
