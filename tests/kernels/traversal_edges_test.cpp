// Tracing at the edges of what is possible: nothing, degenerate triangles, sizes and distances that differ by much.

#include "brute_force.h"
#include "traversal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace eikonal {
namespace {

TEST(TraversalEdges, AnEmptySceneIsMissed) {
    const PackedScene scene = pack(Scene());
    const auto rays = randomRays(500, 69);
    for (const Hit& h : trace(scene, rays)) { EXPECT_EQ(h.element, NONE); EXPECT_EQ(h.t, FAR_AWAY); }
    const auto dark = blocked(scene, rays);
    EXPECT_EQ(std::count(dark.begin(), dark.end(), true), 0);
}

/// Triangles without area change nothing: points, needles with two equal corners, three corners on a line.
TEST(TraversalEdges, DegenerateTrianglesAreNotThere) {
    Random random(70);
    Scene clean;
    clean.shapes.push_back(randomTriangles(random, 100));
    Scene dirty = clean;
    auto mesh = std::make_shared<Mesh>();
    for (int i = 0; i < 60; ++i) {
        const glm::vec3 p = toGlm(random.box(1)), q = toGlm(random.box(1));
        for (const glm::vec3& corner : i % 3 == 0 ? std::array{p, p, p} : i % 3 == 1 ? std::array{p, p, q} : std::array{p, 0.5f * (p + q), q}) {
            mesh->indices.push_back(static_cast<std::uint32_t>(mesh->positions.size()));
            mesh->positions.push_back(corner);
        }
    }
    dirty.shapes.push_back(triangleMesh(mesh));
    /* Boxes of both scenes are equal, or their spaces would differ */
    for (Scene* s : {&clean, &dirty}) s->shapes.push_back(placed(triangleMesh(closedMesh(1, false)), glm::dmat4(glm::dmat3(4))));
    const PackedScene a = pack(clean), b = pack(dirty);
    const auto rays = randomRays(4000, 71);
    const auto want = trace(a, rays), got = trace(b, rays);
    for (size_t i = 0; i < rays.size(); ++i) {
        ASSERT_EQ(got[i].t, want[i].t) << "ray " << i;
        ASSERT_EQ(got[i].element < 100, want[i].element < 100);
    }
}

/// A scene 2^60 or 2^-60 times as large is the same scene, bit by bit.
TEST(TraversalEdges, ScaleDoesNotMatter) {
    const auto rays = randomRays(3000, 72);
    const auto want = trace(pack(mixedScene()), rays);
    for (double scale : {0x1p60, 0x1p-60}) {
        Scene scene = mixedScene();
        for (Shape& s : scene.shapes) s.worldFromObject = glm::dmat4(glm::dmat3(scale)) * s.worldFromObject;
        const auto got = trace(pack(scene), rays);
        for (size_t i = 0; i < rays.size(); ++i) {
            ASSERT_EQ(got[i].element, want[i].element);
            ASSERT_EQ(got[i].t, want[i].t);
        }
    }
}

/// Tiny triangles among huge ones, and rays from far away.
TEST(TraversalEdges, SizesAndDistancesMayDifferByMillions) {
    Random random(73);
    Scene scene;
    auto mesh = std::make_shared<Mesh>();
    for (int i = 0; i < 200; ++i) {
        const float size = random.logBetween(1e-4f, 1);
        const glm::vec3 p = toGlm(random.box(1));
        for (int k = 0; k < 3; ++k) { mesh->indices.push_back(static_cast<std::uint32_t>(mesh->positions.size())); mesh->positions.push_back(p + toGlm(random.box(size))); }
    }
    scene.shapes.push_back(triangleMesh(mesh));
    const PackedScene packed = pack(scene);
    const BruteForce truth(packed);
    std::vector<Ray> rays;
    for (int i = 0; i < 4000; ++i) {
        /* At the middle of a triangle */
        const size_t first = 3 * random.below(static_cast<uint>(packed.tables.indices.size() / 3));
        const auto corner = [&](size_t k) { return toGlm(packed.tables.positions[packed.tables.indices[first + k]]); };
        const float distance = random.logBetween(0.5f, 1000);
        const glm::vec3 target = (corner(0) + corner(1) + corner(2)) / 3.0f, o = target + distance * toGlm(random.direction()), d = glm::normalize(target - o);
        if (distance < 10) rays.push_back({{o.x, o.y, o.z}, {d.x, d.y, d.z}});
    }
    const auto hits = trace(packed, rays);
    for (size_t i = 0; i < rays.size(); ++i) ASSERT_EQ(judgeHit(truth.meet(rays[i].o, rays[i].d), hits[i].element, hits[i].instance, hits[i].t), "") << "ray " << i;
}

}  // namespace
}  // namespace eikonal
