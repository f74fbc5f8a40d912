#pragma once
// Builds the hierarchy of boxes that rays walk down (include/eikonal/bvh.h): binned surface area heuristic (Wald 2007, "On
// fast Construction of SAH-based Bounding Volume Hierarchies"), then the best collapse of the binary tree to eight children
// a node (Ylitie, Karras and Laine 2017, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", section 3.1).

#include "bvh/uninitialized.h"

#include <cstddef>
#include <span>

namespace eikonal {

/// Anything that is not a triangle.
struct BoxedElement {
    vec3 low, high;      ///< its box, scene space. The caller pads it for the rounding of its own intersection test
    uint reference;      ///< element number, or instance number where kind is leaf_instances
    leaf_kind kind;      ///< leaf_elements or leaf_instances
};

/// `count` triangles with 3 indices each into `positions`, numbered from firstElement on. The memory stays the caller's.
struct TriangleRange {
    const vec3* positions;
    const uint* indices;
    size_t count;
    uint firstElement;
};

/// An empty node: no ray enters its children.
bvh_node emptyNode();

/// All hierarchies of a scene. Node 0 is the world's root, there from the start: a scene without anything is valid.
struct BvhTables {
    Table<bvh_node> nodes{emptyNode()};
    Table<triangle_line> triangleLines;
    Table<uint> leafElements;
};

struct BvhOptions {
    bool world = false;   ///< the root becomes node 0; otherwise it is appended
};

/// Where a hierarchy begins, and what it is like.
struct BvhRoot {
    uint root = 0;                    ///< its node
    vec3 low{0, 0, 0}, high{0, 0, 0}; ///< box of all that it holds, not padded; all zero if it holds nothing
    int depth = 0;                    ///< nodes on the longest way down, at most BVH_MAX_DEPTH
    size_t elements = 0, dropped = 0; ///< held; left out because they have a number that is not finite or two equal corners
    size_t nodes = 0, leaves = 0, lines = 0;
    double cost = 0;                  ///< expected work of a ray that enters the root's box, in tests of a node
};

/// Appends the hierarchy of some triangles and other elements. The result does not depend on the number of threads.
/// Coordinates beyond 1e17 count as not finite. Boxes of nodes are padded for the rounding of the device's slab test and
/// triangle test (host/bvh/padding.h). Throws an Error when the tables' numbers run out (2^26 lines of triangles, leaf elements or instances).
BvhRoot buildBvh(BvhTables& appendTo, std::span<const TriangleRange> triangles, std::span<const BoxedElement> others, const BvhOptions& options = {});

}  // namespace eikonal
