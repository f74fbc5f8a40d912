#pragma once
// Builds the bounding volume hierarchy (include/eikonal/bvh.h): binned surface area heuristic (Wald 2007, "On fast Construction of
// SAH-based Bounding Volume Hierarchies"), then the optimal collapse of the binary tree to nodes with eight children (Ylitie, Karras and
// Laine 2017, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", section 3.1).

#include "bvh/uninitialized.h"

#include <cstddef>
#include <span>

namespace eikonal {

/// An element other than a triangle.
struct BoxedElement {
    vec3 low, high;      ///< bounds in scene space. The caller pads them for rounding in its own intersection test
    uint reference;      ///< element number; for leaf_instances, instance number
    leaf_kind kind;      ///< leaf_elements or leaf_instances
};

/// `count` triangles with 3 indices each into `positions`, numbered from firstElement. Does not own the memory.
struct TriangleRange {
    const vec3* positions;
    const uint* indices;
    size_t count;
    uint firstElement;
};

/// A node without children: rays from within 1e24 of it enter none of its boxes.
bvh_node emptyNode();

/// All hierarchies of a scene. Node 0 is the root of the world and always exists, so an empty scene is valid.
struct BvhTables {
    Table<bvh_node> nodes{emptyNode()};
    Table<triangle_line> triangleLines;
    Table<uint> leafElements;
};

struct BvhOptions {
    bool world = false;   ///< make the root node 0; otherwise append it
};

/// A finished hierarchy in the tables.
struct BvhRoot {
    uint root = 0;                    ///< index of its root node
    vec3 low{0, 0, 0}, high{0, 0, 0}; ///< bounds of the contents, not padded; all zero if empty
    int depth = 0;                    ///< nodes on the longest path from the root, at most BVH_MAX_DEPTH
    size_t elements = 0, dropped = 0; ///< dropped: elements with a number that is not finite, or with two equal corners
    size_t nodes = 0, leaves = 0, lines = 0;
    double cost = 0;                  ///< expected cost of a ray that enters the root's box, in units of a node test
};

/// Appends a hierarchy of triangles and other elements. The result does not depend on the number of threads. Coordinates beyond 1e17 count
/// as not finite. Node boxes are padded for the rounding of the device's slab test and triangle test (host/bvh/padding.h). Throws an Error
/// when indices overflow (2^26 triangle lines, leaf elements or instances).
BvhRoot buildBvh(BvhTables& appendTo, std::span<const TriangleRange> triangles, std::span<const BoxedElement> others,
                 const BvhOptions& options = {});

/// How many rays a work-item traverses in turns where scenes have so many elements (kernels/trace/interleaved.clh).
constexpr int interleavedRays(size_t elements) { return elements > 64 ? 4 : 2; }

}  // namespace eikonal
