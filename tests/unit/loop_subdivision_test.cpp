// Loop subdivision, against what must hold of the limit surface.

#include "read/mesh/loop_subdivision.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace eikonal {
namespace {

Mesh octahedron() {
    Mesh mesh;
    mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    mesh.indices = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
    return mesh;
}

/// A closed surface of vertices with three, four, five and more neighbours, dented.
Mesh lump() {
    Mesh mesh = octahedron();
    mesh.positions.push_back({0.9f, 0.8f, 0.7f});
    mesh.indices.erase(mesh.indices.begin(), mesh.indices.begin() + 3);
    for (std::uint32_t v : {0, 2, 6, 2, 4, 6, 4, 0, 6}) mesh.indices.push_back(v);
    return mesh;
}

/// n x n squares in the plane z = 0, each cut in two, over [0, n]^2.
Mesh sheet(std::uint32_t n) {
    Mesh mesh;
    for (std::uint32_t y = 0; y <= n; ++y)
        for (std::uint32_t x = 0; x <= n; ++x) mesh.positions.push_back({x, y, 0});
    for (std::uint32_t y = 0; y < n; ++y)
        for (std::uint32_t x = 0; x < n; ++x) {
            const std::uint32_t a = y * (n + 1) + x;
            for (std::uint32_t v : {a, a + 1, a + n + 2, a, a + n + 2, a + n + 1}) mesh.indices.push_back(v);
        }
    return mesh;
}

glm::vec3 faceNormal(const Mesh& mesh, size_t face) {
    const auto corner = [&](size_t k) { return mesh.positions[mesh.indices[3 * face + k]]; };
    return glm::cross(corner(1) - corner(0), corner(2) - corner(0));
}

/// Each edge of a closed surface is that of two faces, once in each direction, at every level; V - E + F = 2.
TEST(LoopSubdivision, keepsASurfaceClosed) {
    for (int levels = 0; levels < 4; ++levels) {
        const Mesh mesh = subdivideByLoop(lump(), levels).mesh;
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        for (size_t i = 0; i < mesh.indices.size(); ++i) ++edges[{mesh.indices[i], mesh.indices[i % 3 == 2 ? i - 2 : i + 1]}];
        for (const auto& [edge, count] : edges) {
            ASSERT_EQ(count, 1);
            ASSERT_EQ(edges.count({edge.second, edge.first}), 1u);
        }
        const size_t faces = mesh.indices.size() / 3;
        EXPECT_EQ(faces, lump().indices.size() / 3 << 2 * levels);
        EXPECT_EQ(mesh.positions.size() + faces, edges.size() / 2 + 2);
    }
}

/// Vertices lie on the limit surface: a further level moves none of them.
TEST(LoopSubdivision, verticesLieOnTheLimitSurface) {
    const Mesh coarse = subdivideByLoop(lump(), 0).mesh;
    for (int levels = 1; levels < 5; ++levels) {
        const Mesh fine = subdivideByLoop(lump(), levels).mesh;
        for (size_t v = 0; v < coarse.positions.size(); ++v)
            ASSERT_LT(glm::distance(coarse.positions[v], fine.positions[v]), 1e-6f) << "vertex " << v << " at level " << levels;
    }
}

/// Normals are those of the faces around, in the limit; they look against the right hand's rule, as in pbrt-v4.
TEST(LoopSubdivision, normalsFollowTheSurface) {
    const Mesh mesh = subdivideByLoop(lump(), 5).mesh;
    for (size_t f = 0; f < mesh.indices.size() / 3; ++f)
        for (size_t k = 0; k < 3; ++k)
            ASSERT_LT(glm::dot(glm::normalize(faceNormal(mesh, f)), mesh.normals[mesh.indices[3 * f + k]]), -0.98f) << "face " << f;
    const Mesh round = subdivideByLoop(octahedron(), 2).mesh;
    for (size_t v = 0; v < 6; ++v) EXPECT_LT(glm::distance(round.normals[v], -glm::normalize(round.positions[v])), 1e-5f) << v;
}

/// A flat sheet stays flat and square: boundaries are curves of their own, corners are rounded by the rule for boundaries.
TEST(LoopSubdivision, sheetsKeepTheirPlane) {
    const Mesh mesh = subdivideByLoop(sheet(4), 3).mesh;
    size_t onBoundary = 0;
    for (size_t v = 0; v < mesh.positions.size(); ++v) {
        const glm::vec3 p = mesh.positions[v];
        ASSERT_EQ(p.z, 0);
        ASSERT_LT(glm::distance(mesh.normals[v], glm::vec3(0, 0, -1)), 1e-5f) << p.x << " " << p.y;
        ASSERT_TRUE(p.x > -1e-6f && p.x < 4 + 1e-6f && p.y > -1e-6f && p.y < 4 + 1e-6f);
        onBoundary += std::abs(p.x) < 1e-6f;
    }
    EXPECT_GT(onBoundary, 15u);
    /* Inside, where all is regular, subdivision keeps what is linear */
    const glm::vec3 middle = mesh.positions[2 * 5 + 2];
    EXPECT_LT(glm::distance(middle, glm::vec3(2, 2, 0)), 1e-6f);
}

/// What is not a surface does no harm: three faces at an edge, faces turned the wrong way, two fans at one vertex, faces that are none.
TEST(LoopSubdivision, survivesWhatIsNotASurface) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}, {5, 5, 5}, {6, 5, 5}, {7, 7, 7}};
    mesh.indices = {0, 1, 2, 0, 1, 3, 1, 0, 4, 2, 2, 3, 2, 6, 5, 0, 0, 0, 1, 2, 0};
    const SubdividedMesh result = subdivideByLoop(mesh, 4);
    EXPECT_EQ(result.droppedFaces, 2u);
    EXPECT_EQ(result.mesh.indices.size(), 3u * 5 * 256);
    for (const glm::vec3& p : result.mesh.positions) ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    EXPECT_TRUE(subdivideByLoop(Mesh(), 1000).mesh.indices.empty());
}

}  // namespace
}  // namespace eikonal
