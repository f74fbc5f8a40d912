// Tracing at the edges of what is possible: nothing, degenerate triangles, sizes and distances that differ by much.

#include "brute_force.h"
#include "traversal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace eikonal {
namespace {

TEST(TraversalEdges, AnEmptySceneIsMissed) {
    const PackedScene scene = pack(Scene());
    const auto rays = randomRays(500, 69);
    for (const Hit& h : trace(scene, rays)) { EXPECT_EQ(h.element, NONE); EXPECT_EQ(h.t, FAR_AWAY); }
    const auto dark = blocked(scene, rays);
    EXPECT_EQ(std::count(dark.begin(), dark.end(), true), 0);
}

/// Boxes of missing children are hit from farther away than they are large, and nothing is there. Numbers that are no distances end, too.
TEST(TraversalEdges, RaysFromNowhereEnd) {
    const float far = 1e26f, farthest = 3e38f, nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    std::vector<Ray> rays;
    for (const float x : {far, -far, farthest, nan, inf, -inf})
        for (int axis = 0; axis < 3; ++axis) {
            Ray from{{0.1f, 0.2f, 0.3f}, {0, 0, 1}}, along{{0.1f, 0.2f, 0.3f}, {0.6f, 0, 0.8f}};
            (axis == 0 ? from.o.x : axis == 1 ? from.o.y : from.o.z) = x;
            (axis == 0 ? along.d.x : axis == 1 ? along.d.y : along.d.z) = x;
            rays.insert(rays.end(), {from, along});
        }
    const auto usual = randomRays(100, 75);
    rays.insert(rays.end(), usual.begin(), usual.end());
    for (const Scene& s : {triangleScene(), mixedScene(), instancedScene()}) {
        const PackedScene scene = pack(s);
        const auto want = trace(scene, usual), got = trace(scene, rays);
        for (size_t i = 0; i < usual.size(); ++i) EXPECT_EQ(got[rays.size() - usual.size() + i].t, want[i].t) << i;
        EXPECT_EQ(blocked(scene, rays).size(), rays.size());
    }
}

/// How many rays a work-item follows in turns changes nothing.
TEST(TraversalEdges, TurnsDoNotMatter) {
    const auto rays = randomRays(2000, 76);
    for (const Scene& s : {triangleScene(), mixedScene(), instancedScene()}) {
        PackedScene scene = pack(s);
        scene.constants.interleavedRays = 1;
        const auto want = trace(scene, rays);
        const auto dark = blocked(scene, rays);
        for (const int count : {2, 3, 4, 7}) {
            scene.constants.interleavedRays = count;
            const auto got = trace(scene, rays);
            for (size_t i = 0; i < rays.size(); ++i) {
                ASSERT_EQ(got[i].t, want[i].t) << count << ", ray " << i;
                ASSERT_EQ(got[i].element, want[i].element) << count << ", ray " << i;
                ASSERT_EQ(got[i].instance, want[i].instance) << count << ", ray " << i;
                ASSERT_EQ(got[i].u, want[i].u) << count << ", ray " << i;
            }
            EXPECT_EQ(blocked(scene, rays), dark) << count;
        }
    }
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
        for (const glm::vec3& corner : i % 3 == 0   ? std::array{p, p, p}
                                       : i % 3 == 1 ? std::array{p, p, q}
                                                    : std::array{p, 0.5f * (p + q), q}) {
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
        for (int k = 0; k < 3; ++k) {
            mesh->indices.push_back(static_cast<std::uint32_t>(mesh->positions.size()));
            mesh->positions.push_back(p + toGlm(random.box(size)));
        }
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
        const glm::vec3 target = (corner(0) + corner(1) + corner(2)) / 3.0f, o = target + distance * toGlm(random.direction()),
                        d = glm::normalize(target - o);
        if (distance < 10) rays.push_back({{o.x, o.y, o.z}, {d.x, d.y, d.z}});
    }
    const auto hits = trace(packed, rays);
    for (size_t i = 0; i < rays.size(); ++i)
        ASSERT_EQ(judgeHit(truth.meet(rays[i].o, rays[i].d), hits[i].element, hits[i].instance, hits[i].t), "") << "ray " << i;
}

/// Octahedra |x| + |y| + |z| = size within one another, each an instance but the third, which is a shape of the world. A ray towards +x
/// between two of them meets the larger at x = size - |y| - |z|, whichever boxes it entered before: it has left their spaces again.
TEST(TraversalEdges, InstancesMayLieWithinOneAnother) {
    const std::array<double, 4> sizes{1, 0.5, 0.25, 0.125};
    Scene scene;
    scene.objects.push_back({"octahedron", {triangleMesh(closedMesh(1, false))}, {}});
    for (size_t i = 0; i < sizes.size(); ++i) {
        const glm::dmat4 size(glm::dmat4(glm::dmat3(sizes[i])));
        if (i == 2) scene.shapes.push_back(placed(triangleMesh(closedMesh(1, false)), size));
        else scene.instances.push_back({0, size, {}, {}});
    }
    const double toWorld = sizes[0] / spaceOf({{-1, -1, -1}, {1, 1, 1}}).scale;   /* coordinates of rays are those of scene space */
    Random random(74);
    std::vector<Ray> rays;
    std::vector<double> expected;
    for (int i = 0; i < 2000; ++i) {
        const double y = random.between(-0.05f, 0.05f), z = random.between(-0.05f, 0.05f), off = std::fabs(y) + std::fabs(z);
        const size_t next = random.below(static_cast<uint>(sizes.size()));
        const double inner = next + 1 < sizes.size() ? sizes[next + 1] - off : 0;
        const double x = inner + (sizes[next] - off - inner) * random.between(0.1f, 0.9f);
        rays.push_back({toVec3(glm::dvec3(x, y, z) / toWorld), {1, 0, 0}});
        expected.push_back((sizes[next] - off - x) / toWorld);
    }
    const auto hits = trace(pack(scene), rays);
    for (size_t i = 0; i < rays.size(); ++i) ASSERT_NEAR(hits[i].t, expected[i], 1e-6) << "ray " << i;
}

/// The same triangles as instances whose boxes overlap, and as shapes of the world: the same distances, and the same rays are blocked.
TEST(TraversalEdges, InstancesEqualTheirFlattenedTriangles) {
    Random random(75);
    Scene placedTwice, flat;
    const Shape triangles = randomTriangles(random, 40);
    placedTwice.objects.push_back({"triangles", {triangles}, {}});
    for (int i = 0; i < 60; ++i) {
        const glm::dmat4 place = randomTransform(random, 0.3);
        placedTwice.instances.push_back({0, place, {}, {}});
        flat.shapes.push_back(placed(triangles, place * triangles.worldFromObject));
    }
    /* Boxes of both scenes are equal, or their spaces would differ */
    for (Scene* s : {&placedTwice, &flat}) s->shapes.push_back(placed(triangleMesh(closedMesh(1, false)), glm::dmat4(glm::dmat3(8))));
    const PackedScene a = pack(placedTwice), b = pack(flat);
    auto rays = randomRays(4000, 76);
    for (Ray& r : rays) r.tMax = 0.3f;
    const auto got = trace(a, rays), want = trace(b, rays);
    size_t differ = 0;
    for (size_t i = 0; i < rays.size(); ++i) differ += std::fabs(got[i].t - want[i].t) > 1e-5f;
    EXPECT_LE(differ, 4u) << "at edges, rounding decides";
    const auto dark = blocked(a, rays), flatDark = blocked(b, rays);
    size_t other = 0;
    for (size_t i = 0; i < rays.size(); ++i) other += dark[i] != flatDark[i];
    EXPECT_LE(other, 4u);
    EXPECT_GT(std::count(dark.begin(), dark.end(), true), 400);
}

}  // namespace
}  // namespace eikonal
