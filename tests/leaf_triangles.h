#pragma once
// The triangles of a leaf, as include/eikonal/bvh.h lays them out.

#include "eikonal/bvh.h"

#include <bit>
#include <vector>

namespace eikonal {

struct LeafTriangle {
    uint element;
    vec3 corner[3];
};

/// Of a reference to a leaf of triangles.
inline std::vector<LeafTriangle> leafTriangles(const Table<triangle_line>& lines, uint reference) {
    const size_t count = ((reference >> LEAF_COUNT_SHIFT) & LEAF_COUNT_MASK) + 1, first = reference & LEAF_FIRST_MASK;
    const auto word = [&](size_t row, size_t i) { return lines.at(first + (row * count + i) / 16).words[(row * count + i) % 16]; };
    std::vector<LeafTriangle> triangles(count);
    for (size_t i = 0; i < count; ++i) {
        triangles[i].element = std::bit_cast<uint>(word(9, i)) & ~ELEMENT_MARK;
        for (size_t v = 0; v < 3; ++v) triangles[i].corner[v] = {word(3 * v, i), word(3 * v + 1, i), word(3 * v + 2, i)};
    }
    return triangles;
}

}  // namespace eikonal
