// Polygons of many corners become triangles that cover them once.

#include "read/mesh/polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace eikonal {
namespace {

struct Covering {
    std::size_t triangles = 0, flipped = 0;
    double area = 0;
};

Covering cover(const std::vector<glm::dvec3>& corners) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    triangulate(corners, triangles);
    Covering covering{triangles.size()};
    for (const auto& [a, b, c] : triangles) {
        const double area = glm::cross(corners[b] - corners[a], corners[c] - corners[a]).z / 2;
        covering.flipped += area < 0;
        covering.area += area;
    }
    return covering;
}

/// A simple polygon is covered by triangles of its own orientation only if they do not overlap.
void expectCovered(const std::vector<glm::dvec3>& corners) {
    const double area = polygonNormal(corners).z / 2;
    const Covering covering = cover(corners);
    EXPECT_EQ(covering.triangles, corners.size() - 2);
    EXPECT_EQ(covering.flipped, 0u);
    EXPECT_NEAR(covering.area, area, 1e-9 * area);
}

/// Corners at distances radius(i) around the origin.
template <class Radius> std::vector<glm::dvec3> around(int n, Radius radius) {
    std::vector<glm::dvec3> corners;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        corners.emplace_back(radius(i) * std::cos(angle), radius(i) * std::sin(angle), 0);
    }
    return corners;
}

// With a search through all corners for each ear, these took a quarter of a minute each.
TEST(Polygon, aHundredThousandCornersTakeNoTime) {
    expectCovered(around(100'000, [](int i) { return i % 2 ? 1. : .5; }));                       // a star
    expectCovered(around(100'000, [](int i) { return 2 + std::sin(i * 2e-3); }));                // a flower
    std::vector<glm::dvec3> comb;
    for (int i = 0; i < 50'000; ++i) {
        comb.emplace_back(i, 0, 0);
        comb.emplace_back(i + .5, -1, 0);
    }
    comb.emplace_back(50'000, 1, 0);
    comb.emplace_back(0, 1, 0);
    expectCovered(comb);
}

TEST(Polygon, smallOnesThatAreNotConvex) {
    expectCovered({{0, 0, 0}, {2, 0, 0}, {.5, .5, 0}, {0, 2, 0}});
    expectCovered({{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}});
}

// It has no right answer, but the number of triangles and an end.
TEST(Polygon, onesThatCrossThemselves) {
    EXPECT_EQ(cover(around(1001, [](int i) { return i % 3 ? 1. : -1.; })).triangles, 999u);
    EXPECT_EQ(cover(std::vector<glm::dvec3>(500, glm::dvec3(1))).triangles, 498u);
}

}  // namespace
}  // namespace eikonal
