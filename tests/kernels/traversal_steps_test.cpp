// Steps of traversal (count_traversal_steps): what they count, and that more are needed where there is more.

#include "render/traversal_steps.h"
#include "test_device.h"
#include "traversal.h"

#include <gtest/gtest.h>

#include <numeric>

namespace eikonal {
namespace {

std::vector<uint> steps(const PackedScene& scene, const std::vector<Ray>& rays, bool areShadowRays) {
    const DeviceScene tables(testContext(), scene);
    const StageShape shape{.localSize = testLocalSize, .itemsPerWorkItem = testRun};
    const TraversalSteps counter(testContext(), testCompiler(), tables, scene, shape, shippedSettings(scene.features, scene.constants));
    TracedRays traced;
    for (const Ray& r : rays) {
        traced.origins.push_back(r.o);
        traced.directions.push_back(r.d);
        traced.ends.push_back(r.tMax);
    }
    return counter.count(traced, areShadowRays);
}

/// A ray visits the root even if it misses all; one that hits tests a leaf at least.
TEST(TraversalSteps, AreNodesAndLeaves) {
    const PackedScene scene = pack(mixedScene());
    const std::vector<Ray> rays = randomRays(3000, 71);
    const std::vector<Hit> hits = trace(scene, rays);
    const std::vector<uint> all = steps(scene, rays, false);
    for (size_t i = 0; i < rays.size(); ++i) EXPECT_GE(all[i], hits[i].element == NONE ? 1u : 2u);
    for (const uint one : steps(scene, {{{100, 0, 0}, {1, 0, 0}}, {{0, 100, 0}, {0, 1, 0}}}, false)) EXPECT_EQ(one, 1u);
}

/// Any blocker ends a shadow ray, and the end of a short one leaves boxes out.
TEST(TraversalSteps, AreFewerForShadowRaysAndForShortOnes) {
    const PackedScene scene = pack(instancedScene());
    std::vector<Ray> rays = randomRays(3000, 72);
    const auto sum = [](const std::vector<uint>& numbers) { return std::accumulate(numbers.begin(), numbers.end(), 0ul); };
    const std::vector<uint> nearest = steps(scene, rays, false);
    EXPECT_LT(sum(steps(scene, rays, true)), sum(nearest));
    for (Ray& r : rays) r.tMax = 0.01f;
    const std::vector<uint> near = steps(scene, rays, false);
    EXPECT_LT(sum(near), sum(nearest) / 2);
    for (size_t i = 0; i < rays.size(); ++i) EXPECT_LE(near[i], nearest[i]) << i;
}

}  // namespace
}  // namespace eikonal
