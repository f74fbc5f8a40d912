// Cutting meshes for displacement: no edge stays long, no crack opens, and nothing of the surface is lost.

#include "read/mesh/displacement.h"
#include "unit/mesh_area.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace eikonal {
namespace {

Mesh octahedron() {
    Mesh mesh;
    mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    mesh.uvs = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {0, 0}, {0, 0}};
    mesh.indices = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
    return mesh;
}

const Transform stretched =
    glm::rotate(glm::scale(glm::translate(Transform(1), glm::dvec3(5, 6, 7)), glm::dvec3(3, 0.5, 1)), 0.7, glm::dvec3(1, 2, 3));

TEST(Displacement, CutsEveryLongEdgeAndOpensNoCrack) {
    for (const double length : {10.0, 1.0, 0.3, 0.07}) {
        const double area = areaOf(octahedron(), stretched);
        Mesh mesh = octahedron();
        ASSERT_EQ(splitLongEdges(mesh, stretched, length), Split::done);
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        for (size_t i = 0; i < mesh.indices.size(); ++i) {
            const size_t next = i % 3 == 2 ? i - 2 : i + 1;
            ++edges[{mesh.indices[i], mesh.indices[next]}];
            ASSERT_LT(glm::length(placedCorner(mesh, stretched, i) - placedCorner(mesh, stretched, next)), length);
        }
        /* A closed surface still: each edge once in each direction, and Euler's formula */
        for (const auto& [edge, count] : edges) {
            ASSERT_EQ(count, 1);
            ASSERT_EQ(edges.count({edge.second, edge.first}), 1u);
        }
        const size_t triangles = mesh.indices.size() / 3;
        EXPECT_EQ(mesh.positions.size() + triangles, edges.size() / 2 + 2);
        EXPECT_NEAR(areaOf(mesh, stretched), area, 1e-5 * area);
        EXPECT_LE(static_cast<double>(triangles), 16 * area / (length * length) + 8) << "what the shortest possible edge length rests on";
        ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
        ASSERT_EQ(mesh.uvs.size(), mesh.positions.size());
        for (size_t i = 0; i < mesh.positions.size(); ++i) {
            const glm::vec3 p = mesh.positions[i];
            ASSERT_NEAR(std::abs(p.x) + std::abs(p.y) + std::abs(p.z), 1, 1e-6) << "on the octahedron";
            ASSERT_EQ(mesh.uvs[i], glm::vec2(p)) << "texture coordinates are cut as positions are";
            ASSERT_GT(glm::dot(mesh.normals[i], p), 0.5);
        }
    }
}

TEST(Displacement, LeavesShortEdgesAlone) {
    Mesh mesh = octahedron();
    mesh.normals.assign(6, {0, 0, 1});
    ASSERT_EQ(splitLongEdges(mesh, Transform(1), 1.5), Split::done);
    EXPECT_EQ(mesh.indices, octahedron().indices);
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1)) << "normals that the mesh has are kept";
}

TEST(Displacement, RefusesWhatWouldNotFit) {
    const double area = areaOf(octahedron());
    for (const double length : {1e-300, 1e-9, 0.9 * std::sqrt(area / (std::sqrt(3) / 4 * mostDisplacedTriangles))}) {
        Mesh mesh = octahedron();
        EXPECT_EQ(splitLongEdges(mesh, Transform(1), length), Split::tooMany) << length;
    }
    const auto triangle = [](glm::vec3 a, glm::vec3 b, glm::vec3 c) {
        Mesh mesh;
        mesh.positions = {a, b, c};
        mesh.indices = {0, 1, 2};
        return mesh;
    };
    Mesh sliver = triangle({0, 0, 0}, {1e6f, 0, 0}, {1e6f, 1e-9f, 0}), far = triangle({1e8f, 0, 0}, {1e8f + 8, 0, 0}, {1e8f, 8, 0}),
         point = triangle({1, 2, 3}, {1, 2, 3}, {1, 2, 3});
    EXPECT_EQ(splitLongEdges(sliver, Transform(1), 0.01), Split::tooMany) << "by the length of its edges";
    EXPECT_GT(shortestEdgeLength(sliver, Transform(1)), 0.01);
    EXPECT_EQ(splitLongEdges(far, Transform(1), 0.5), Split::tooFine) << "no number lies between 1e8 and 1e8 + 8";
    EXPECT_LT(far.positions.size(), 1000u) << "found out before long";
    EXPECT_EQ(splitLongEdges(point, Transform(1), 1e-300), Split::done);
    EXPECT_NEAR(shortestEdgeLength(octahedron(), Transform(1)), 4 * std::sqrt(area / mostDisplacedTriangles), 1e-9);
}

TEST(Displacement, FindsNormalsAtAnyScale) {
    for (const float size : {0x1p-60f, 1.f, 0x1p60f}) {
        Mesh mesh = octahedron();
        for (glm::vec3& p : mesh.positions) p *= size;
        ASSERT_EQ(splitLongEdges(mesh, Transform(1), 2e18), Split::done);
        EXPECT_EQ(mesh.normals[2], glm::vec3(0, 1, 0)) << size;
    }
}

TEST(Displacement, MovesVerticesAlongTheirNormals) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}};
    mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {1, 0, 0}};
    mesh.indices = {0, 1, 2};
    const float heights[] = {1, 2, 1, 3};
    displaceVertices(mesh, heights);
    EXPECT_EQ(mesh.positions, (std::vector<glm::vec3>{{0, 0, 1}, {1, 0, 2}, {0, 1, 1}, {8, 5, 5}}));
    const glm::vec3 expected = glm::normalize(glm::vec3(-1, 0, 1));
    for (int i = 0; i < 3; ++i) EXPECT_LT(glm::length(mesh.normals[static_cast<size_t>(i)] - expected), 1e-6f);
    EXPECT_EQ(mesh.normals[3], glm::vec3(0)) << "a vertex without faces has no normal";
}

}  // namespace
}  // namespace eikonal
