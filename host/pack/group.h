#pragma once
// The elements of one hierarchy, gathered before it is built.

#include "bvh/build.h"
#include "pack/space.h"

#include <algorithm>
#include <vector>

namespace eikonal {

/// The elements of one hierarchy: of the world, or of an object that is instanced or moves.
struct Group {
    SceneSpace space;               ///< the space in which the hierarchy is built
    struct Triangles { size_t firstVertex, firstIndex, count; uint firstElement; };
    std::vector<Triangles> triangles;
    std::vector<BoxedElement> boxed;

    bool isEmpty() const { return triangles.empty() && boxed.empty(); }
};

/// Adds an element's box, padded by more than the rounding error of the intersection test, relative to its largest coordinate.
inline void addBox(Group& group, const Box& box, uint reference, leaf_kind kind = leaf_elements) {
    const glm::dvec3 reach = glm::max(glm::abs(box.low), glm::abs(box.high));
    const double padding = 32 * 6e-8 * std::max({reach.x, reach.y, reach.z});
    group.boxed.push_back({toVec3(box.low - padding), toVec3(box.high + padding), reference, kind});
}

}  // namespace eikonal
