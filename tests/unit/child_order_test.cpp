// The order in which rays of an octant visit the children of a node.

#include "bvh/build.h"
#include "bvh/child_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

namespace eikonal {
namespace {

/// The children as node.order lists them.
std::array<uint, BVH_WIDTH> listed(uint order) {
    std::array<uint, BVH_WIDTH> children;
    for (uint i = 0; i < BVH_WIDTH; ++i) children[i] = order >> 4 * i & 15;
    return children;
}

/// A node of boxes of random size; the last ones are missing.
bvh_node randomNode(std::mt19937& random, uint children) {
    std::uniform_real_distribution<float> place(-10, 10), size(0, 3);
    bvh_node node = emptyNode();
    for (uint i = 0; i < children; ++i) {
        node.child[i] = i + 1;
        for (uint axis = 0; axis < 3; ++axis) {
            node.bounds[2 * axis][i] = place(random);
            node.bounds[2 * axis + 1][i] = node.bounds[2 * axis][i] + size(random);
        }
    }
    return node;
}

/// Twice the distance of a box's centre along the diagonal of an octant.
float distance(const bvh_node& node, uint child, uint octant) {
    float sum = 0;
    for (uint axis = 0; axis < 3; ++axis)
        sum += (octant >> axis & 1 ? -1.0f : 1.0f) * (node.bounds[2 * axis][child] + node.bounds[2 * axis + 1][child]);
    return sum;
}

TEST(ChildOrder, ListsEachChildOnceAndNearOnesLast) {
    std::mt19937 random(1);
    for (uint count = 1; count <= BVH_WIDTH; ++count) {
        bvh_node node = randomNode(random, count);
        orderChildren(node);
        for (uint octant = 0; octant < BVH_WIDTH; ++octant) {
            const std::array<uint, BVH_WIDTH> children = listed(node.order[octant]);
            uint seen = 0;
            for (const uint child : children) {
                ASSERT_LT(child, uint{BVH_WIDTH});
                seen |= 1u << child;
            }
            EXPECT_EQ(seen, 0xffu) << count;
            for (uint i = 1; i < BVH_WIDTH; ++i)
                EXPECT_GE(distance(node, children[i - 1], octant), distance(node, children[i], octant)) << count << " " << octant;
        }
    }
}

TEST(ChildOrder, IsReversedInTheOppositeOctant) {
    std::mt19937 random(2);
    bvh_node node = randomNode(random, BVH_WIDTH);
    orderChildren(node);
    for (uint octant = 0; octant < BVH_WIDTH; ++octant) {
        std::array<uint, BVH_WIDTH> back = listed(node.order[7 - octant]);
        std::ranges::reverse(back);
        EXPECT_EQ(listed(node.order[octant]), back) << octant;
    }
}

TEST(ChildOrder, ListsBoxesAtTheSamePlaceOnce) {
    bvh_node node = emptyNode();
    for (uint i = 0; i < BVH_WIDTH; ++i) {
        node.child[i] = 1;
        for (uint axis = 0; axis < 3; ++axis) {
            node.bounds[2 * axis][i] = -1;
            node.bounds[2 * axis + 1][i] = 1;
        }
    }
    orderChildren(node);
    for (const uint order : node.order) EXPECT_EQ(order, 0x01234567u);
}

}  // namespace
}  // namespace eikonal
