#pragma once
// SIMD bounding boxes for the BVH builder.

#include "eikonal/bvh.h"

#include <bit>
#include <limits>

namespace eikonal {

using float4 = float __attribute__((vector_size(16)));
using int4 = std::int32_t __attribute__((vector_size(16)));

inline float4 minimum(float4 a, float4 b) { return a < b ? a : b; }
inline float4 maximum(float4 a, float4 b) { return a > b ? a : b; }

/// A box with x, y, z in the first three lanes; the fourth lane is unused.
struct WideBox {
    float4 low, high;

    static WideBox empty() {
        constexpr float huge = std::numeric_limits<float>::max();
        return {float4{huge, huge, huge, huge}, float4{-huge, -huge, -huge, -huge}};
    }
    void grow(const WideBox& other) { low = minimum(low, other.low); high = maximum(high, other.high); }
    void grow(float4 point) { low = minimum(low, point); high = maximum(high, point); }
    /// Half of the surface area; 0 for an empty box.
    float halfArea() const {
        const float4 d = high - low;
        return d[0] < 0 ? 0.f : d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
    }
};

/// A reference to an element: its box, with the element in the fourth lanes.
struct Reference {
    WideBox box;

    Reference() = default;
    Reference(WideBox bounds, leaf_kind kind, uint source, uint index) : box(bounds) {
        box.low[3] = std::bit_cast<float>(index);
        box.high[3] = std::bit_cast<float>(static_cast<uint>(kind) << 29 | source);
    }
    /// The index of the element in its source.
    uint index() const { return std::bit_cast<uint>(static_cast<float>(box.low[3])); }
    /// The index of its TriangleRange; 0 for elements that are not triangles.
    uint source() const { return std::bit_cast<uint>(static_cast<float>(box.high[3])) & 0x1fffffffu; }
    leaf_kind kind() const { return static_cast<leaf_kind>(std::bit_cast<uint>(static_cast<float>(box.high[3])) >> 29); }
    /// Twice the centroid, with 0 in the fourth lane.
    float4 centroid() const {
        const int4 xyz = {-1, -1, -1, 0};
        return reinterpret_cast<float4>(reinterpret_cast<int4>(box.low + box.high) & xyz);
    }
};

/// A range of references, with its bounds.
struct Range {
    uint begin = 0, end = 0;
    WideBox box = WideBox::empty(), centroids = WideBox::empty();
    uint kinds = 0;  ///< bit k: contains elements of leaf kind k

    uint size() const { return end - begin; }
    bool holdsOnly(leaf_kind kind) const { return kinds == 1u << kind; }
    void include(const Reference& r) { box.grow(r.box); centroids.grow(r.centroid()); kinds |= 1u << r.kind(); }
    void include(const Range& r) { box.grow(r.box); centroids.grow(r.centroids); kinds |= r.kinds; }
    /// Whether it fits into one leaf: not larger than a leaf's capacity, and all of one kind.
    bool fitsLeaf() const {
        if (holdsOnly(leaf_instances)) return size() == 1;
        return size() <= BVH_WIDTH && std::has_single_bit(kinds);
    }
};

}  // namespace eikonal
