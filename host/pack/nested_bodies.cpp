#include "pack/nested_bodies.h"

#include "eikonal/medium.h"
#include "pack/context.h"
#include "pack/scene_bounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace eikonal {

static bool contains(const Box& outer, const Box& inner) {
    return glm::all(glm::lessThanEqual(outer.low, inner.low)) && glm::all(glm::greaterThanEqual(outer.high, inner.high));
}

void warnOfNestedBodies(const PackContext& context) {
    const Scene& scene = context.scene;
    std::vector<Box> boxes = boxesOf(scene, [&](const Shape& s) {
        return s.material != none && scene.materials[static_cast<size_t>(s.material)].isWalked();
    });
    /* Every body is compared with every other: many are no nest, but a crowd */
    constexpr size_t most = 1000;
    if (boxes.size() <= MOST_NESTED_BODIES || boxes.size() > most) return;
    std::ranges::sort(boxes, std::greater(), [](const Box& box) { return box.radius(); });
    std::vector<unsigned> within(boxes.size(), 1);   // the body itself, and those that it is in
    for (size_t i = 0; i < boxes.size(); ++i)
        for (size_t j = 0; j < i; ++j)
            if (contains(boxes[j], boxes[i])) within[i] = std::max(within[i], within[j] + 1);
    if (const unsigned deepest = std::ranges::max(within); deepest > MOST_NESTED_BODIES)
        context.diagnostics.warnOnce("nested bodies", {},
                                     fmt::format("{} bodies of material \"subsurface\" lie in one another, and paths remember what is "
                                                 "around {}: within that many, light may be wrong", deepest, MOST_NESTED_BODIES));
}

}  // namespace eikonal
