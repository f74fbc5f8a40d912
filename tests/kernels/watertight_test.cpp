// Rays do not slip between the triangles of a closed mesh.

#include "traversal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace eikonal {
namespace {

/// From inside of a closed mesh, no ray escapes: aimed at vertices, at points of edges, and along axes through vertices.
TEST(Watertight, NoRayEscapesAClosedMesh) {
    for (bool round : {true, false}) {
        Scene scene;
        scene.shapes.push_back(triangleMesh(closedMesh(24, round)));
        const PackedScene packed = pack(scene);
        const auto& positions = packed.tables.positions;
        Random random(68);
        std::vector<Ray> rays;
        const auto aim = [&](vec3 o, glm::vec3 target) {
            const glm::vec3 d = glm::normalize(target - toGlm(o));
            rays.push_back({o, {d.x, d.y, d.z}});
        };
        for (int i = 0; i < 120000; ++i) {
            const vec3 o = i % 4 == 0 ? vec3{0, 0, 0} : random.box(0.15f);
            const size_t triangle = 3 * random.below(static_cast<uint>(packed.tables.indices.size() / 3));
            const glm::vec3 a = toGlm(positions[packed.tables.indices[triangle]]),
                            b = toGlm(positions[packed.tables.indices[triangle + 1]]);
            const float s = i % 3 == 0 ? 0 : i % 3 == 1 ? 0.5f : random.unit();
            aim(o, a + s * (b - a));
            /* Along an axis, through a vertex: two coordinates are those of the vertex exactly */
            const uint axis = random.below(3);
            vec3 from{a.x, a.y, a.z};
            (axis == 0 ? from.x : axis == 1 ? from.y : from.z) = 0;
            vec3 d{0, 0, 0};
            (axis == 0 ? d.x : axis == 1 ? d.y : d.z) = random.below(2) ? 1.0f : -1.0f;
            const double inner =
                std::abs(static_cast<double>(from.x)) + std::abs(static_cast<double>(from.y)) + std::abs(static_cast<double>(from.z));
            const double radius = packed.tables.object_spaces.empty()
                                      ? std::abs(static_cast<double>(positions[0].x)) + std::abs(static_cast<double>(positions[0].y)) +
                                            std::abs(static_cast<double>(positions[0].z))
                                      : 1;
            if (inner < 0.9 * radius) rays.push_back({from, d});
        }
        size_t escaped = 0;
        for (const Hit& h : trace(packed, rays)) escaped += h.element == NONE;
        EXPECT_EQ(escaped, 0u) << "of " << rays.size() << (round ? " from a sphere" : " from an octahedron");
        const auto dark = blocked(packed, rays);
        EXPECT_EQ(std::count(dark.begin(), dark.end(), false), 0);
    }
}

/// A height field of tiny triangles, seen from up to five million times their size: rays at its edges and vertices, from far away. The
/// rounding of the distance to a plane is then that of the origin's coordinates, which the padding of boxes does not know.
/// Without the share of the origin about one ray in a hundred passes at the largest distance.
TEST(Watertight, NoRayPassesATinyMeshFromFarAway) {
    constexpr int side = 60;
    for (float distance : {10.0f, 100.0f, 500.0f}) {
        const float size = 1e-4f;
        Random random(70);
        auto mesh = std::make_shared<Mesh>();
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                mesh->positions.push_back(size * glm::vec3(static_cast<float>(x - side / 2) + random.between(-0.3f, 0.3f),
                                                           static_cast<float>(y - side / 2) + random.between(-0.3f, 0.3f),
                                                           random.between(-1.0f, 1.0f)));
        for (uint y = 0; y + 1 < side; ++y)
            for (uint x = 0; x + 1 < side; ++x) {
                const uint a = y * side + x;
                for (uint index : {a, a + 1, a + side + 1, a, a + side + 1, a + side}) mesh->indices.push_back(index);
            }
        Scene scene;
        scene.shapes.push_back(triangleMesh(mesh));
        const PackedScene packed = pack(scene);
        const auto& positions = packed.tables.positions;
        /* The rows and columns at the border are left out: beside them a ray passes rightly */
        const auto inner = [&] { return 5 + random.below(side - 10); };
        /* Scene space may have another scale: measured in the packed mesh */
        const float scale = (positions[1].x - positions[0].x) / (mesh->positions[1].x - mesh->positions[0].x);
        std::vector<Ray> rays;
        for (int i = 0; i < 100000; ++i) {
            const uint at = inner() * side + inner();
            const glm::vec3 a = toGlm(positions[at]), b = toGlm(positions[at + (i % 2 ? 1 : side)]);
            const glm::vec3 target = a + (i % 3 == 0 ? 0 : random.unit()) * (b - a);
            const glm::vec3 o = target + distance * scale * glm::normalize(glm::vec3(0.3f, 0.4f, 0.85f)), d = glm::normalize(target - o);
            rays.push_back({{o.x, o.y, o.z}, {d.x, d.y, d.z}});
        }
        size_t passed = 0;
        for (const Hit& h : trace(packed, rays)) passed += h.element == NONE;
        EXPECT_EQ(passed, 0u) << "of " << rays.size() << " from " << distance;
    }
}

/// A closed mesh, squeezed across x, and how far it reaches on the device.
struct Needle { PackedScene packed; float length, across; };
Needle needle(int steps, bool round, float squeeze) {
    const std::shared_ptr<Mesh> mesh = closedMesh(steps, round);
    for (glm::vec3& p : mesh->positions) p *= glm::vec3(1, squeeze, squeeze);
    Scene scene;
    scene.shapes.push_back(triangleMesh(mesh));
    PackedScene packed = pack(scene);
    float length = 0;
    for (const vec3& p : packed.tables.positions) length = std::max(length, p.x);
    return {std::move(packed), length, length * squeeze};
}

/// Needles: the same meshes, squeezed to as little as a millionth across x. Rays from inside, half of them in all directions and half
/// squeezed like the needle, meet triangles at all angles, where the products of an edge function nearly cancel.
TEST(Watertight, NoRayEscapesANeedle) {
    for (float squeeze : {1e-4f, 1e-5f, 1e-6f})
        for (bool round : {true, false}) {
            const auto [packed, length, across] = needle(4, round, squeeze);
            Random random(69);
            std::vector<Ray> rays;
            for (int i = 0; i < 500000; ++i) {
                const vec3 o = random.box(0.15f), w = random.box(1);
                const float thin = i % 2 ? across / length : 1;
                const glm::vec3 d = glm::normalize(glm::vec3(w.x, w.y * thin, w.z * thin));
                rays.push_back({{o.x * length, o.y * across, o.z * across}, {d.x, d.y, d.z}});
            }
            size_t escaped = 0;
            for (const Hit& h : trace(packed, rays)) escaped += h.element == NONE;
            EXPECT_EQ(escaped, 0u) << "of " << rays.size() << " from a needle of 1 : " << squeeze;
        }
}

/// A hundred million rays from inside of closed meshes and of needles, at vertices and at points of edges.
TEST(SlowWatertight, NoneOfAHundredMillionAimedRaysEscapes) {
    struct Body { int steps; float squeeze; };
    for (const Body body : {Body{24, 1}, Body{4, 1e-4f}, Body{4, 1e-5f}, Body{4, 1e-6f}})
        for (bool round : {true, false}) {
            const auto [packed, length, across] = needle(body.steps, round, body.squeeze);
            const auto& indices = packed.tables.indices;
            Random random(71);
            size_t escaped = 0, all = 0;
            while (all < 12500000) {
                std::vector<Ray> rays;
                for (int i = 0; i < 500000; ++i) {
                    const vec3 o = random.box(0.15f);
                    const glm::vec3 from{o.x * length, o.y * across, o.z * across};
                    const size_t triangle = 3 * random.below(static_cast<uint>(indices.size() / 3));
                    const glm::vec3 a = toGlm(packed.tables.positions[indices[triangle]]),
                                    b = toGlm(packed.tables.positions[indices[triangle + 1]]);
                    const float s = i % 3 == 0 ? 0 : i % 3 == 1 ? 0.5f : random.unit();
                    const glm::vec3 d = glm::normalize(a + s * (b - a) - from);
                    rays.push_back({{from.x, from.y, from.z}, {d.x, d.y, d.z}});
                }
                for (const Hit& h : trace(packed, rays)) escaped += h.element == NONE;
                all += rays.size();
            }
            EXPECT_EQ(escaped, 0u) << "of " << all << " from 1 : " << body.squeeze << (round ? ", round" : ", flat");
        }
}

}  // namespace
}  // namespace eikonal
