#include "bvh/child_order.h"

#include <array>

namespace eikonal {

/* Far children come first, and of equal ones the later. Missing children are wherever their empty boxes put them. */
static uint orderByDistance(const std::array<float, BVH_WIDTH>& distance) {
    uint order = 0;
    for (uint i = 0; i < BVH_WIDTH; ++i) {
        uint before = 0;
        for (uint j = 0; j < BVH_WIDTH; ++j) before += distance[j] > distance[i] || (distance[j] == distance[i] && j > i);
        order |= i << 4 * before;
    }
    return order;
}

void orderChildren(bvh_node& node) {
    for (uint octant = 0; octant < BVH_WIDTH; ++octant) {
        std::array<float, BVH_WIDTH> distance{};
        for (uint axis = 0; axis < 3; ++axis) {
            const float sign = octant >> axis & 1 ? -1.0f : 1.0f;
            for (uint i = 0; i < BVH_WIDTH; ++i) distance[i] += sign * (node.bounds[2 * axis][i] + node.bounds[2 * axis + 1][i]);
        }
        node.order[octant] = orderByDistance(distance);
    }
}

}  // namespace eikonal
