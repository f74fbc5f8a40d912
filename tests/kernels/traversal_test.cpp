// Tracing against brute force in double precision: nearest hits (intersect_rays) and blockers (test_shadows).

#include "brute_force.h"
#include "traversal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace eikonal {
namespace {

struct SceneCase { std::string name; Scene (*make)(); size_t rays; };
void PrintTo(const SceneCase& c, std::ostream* out) { *out << c.name; }

class Traversal : public testing::TestWithParam<SceneCase> {};

TEST_P(Traversal, FindsTheNearestHit) {
    const PackedScene scene = pack(GetParam().make());
    const BruteForce truth(scene);
    const auto rays = randomRays(GetParam().rays, 63);
    const auto hits = trace(scene, rays);
    size_t met = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
        ASSERT_EQ(judgeHit(truth.meet(rays[i].o, rays[i].d), hits[i].element, hits[i].instance, hits[i].t), "") << "ray " << i;
        met += hits[i].element != NONE;
    }
    EXPECT_GT(met, rays.size() / 100);
    EXPECT_LT(met, rays.size());
}

/// Shadow rays stop at the first blocker, whichever, within their length: some short, some long.
TEST_P(Traversal, FindsBlockers) {
    const PackedScene scene = pack(GetParam().make());
    const BruteForce truth(scene);
    auto rays = randomRays(GetParam().rays, 64);
    Random random(65);
    for (Ray& r : rays) r.tMax = random.below(4) ? random.between(0.02f, 0.5f) : FAR_AWAY;
    const auto results = blocked(scene, rays);
    size_t count = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
        ASSERT_EQ(judgeShadow(truth.meet(rays[i].o, rays[i].d), rays[i].tMax, results[i]), "") << "ray " << i;
        count += results[i];
    }
    EXPECT_GT(count, rays.size() / 100);
    EXPECT_LT(count, rays.size());
}

/// A hit is only one in (0, t_max): a ray that ends before its hit finds nothing, one that ends behind it finds it.
TEST_P(Traversal, RespectsTheLengthOfRays) {
    const PackedScene scene = pack(GetParam().make());
    auto rays = randomRays(2000, 66);
    const auto first = trace(scene, rays);
    auto shorter = rays, longer = rays;
    for (size_t i = 0; i < rays.size(); ++i) { shorter[i].tMax = first[i].t * 0.999f; longer[i].tMax = first[i].t * 1.001f; }
    const auto none = trace(scene, shorter), same = trace(scene, longer);
    for (size_t i = 0; i < rays.size(); ++i) {
        EXPECT_EQ(none[i].element, NONE);
        EXPECT_EQ(same[i].element, first[i].element);
        EXPECT_EQ(same[i].t, first[i].element == NONE ? longer[i].tMax : first[i].t);
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Traversal,
                         testing::Values(SceneCase{"triangles", triangleScene, 12000}, SceneCase{"mixed", mixedScene, 12000},
                                         SceneCase{"curves", curveScene, 12000}, SceneCase{"instances", instancedScene, 12000}),
                         [](const auto& info) { return info.param.name; });

/// The point that a triangle's coordinates name is the point on the ray.
TEST(TraversalPoint, CoordinatesNameThePointOfTheRay) {
    const PackedScene scene = pack(triangleScene());
    const auto rays = randomRays(4000, 67);
    const auto hits = trace(scene, rays);
    for (size_t i = 0; i < rays.size(); ++i) {
        if (hits[i].element == NONE) continue;
        const shape& s = scene.tables.shapes[scene.tables.element_shapes[hits[i].element]];
        const uint* index = &scene.tables.indices[s.first_index + 3 * (hits[i].element - s.first_element)];
        const auto corner = [&](int k) { return toGlm(scene.tables.positions[s.first_vertex + index[k]]); };
        const glm::vec3 p = (1 - hits[i].u - hits[i].v) * corner(0) + hits[i].u * corner(1) + hits[i].v * corner(2),
                        q = toGlm(rays[i].o) + hits[i].t * toGlm(rays[i].d);
        const glm::vec3 n = glm::normalize(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
        ASSERT_LT(glm::length(p - q), 1e-5f / std::max(std::abs(glm::dot(n, toGlm(rays[i].d))), 1e-3f)) << "ray " << i;
    }
}

}  // namespace
}  // namespace eikonal
