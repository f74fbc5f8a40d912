#include "read/obj/polygon.h"

#include <cmath>
#include <cstdint>
#include <numeric>

namespace eikonal {
namespace {

/// Twice the signed area of a triangle.
double area(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

bool contains(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 p) { return area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0; }

/// The polygon projected along its normal, counter-clockwise, with two of the three coordinates, relative to the first corner.
std::vector<glm::dvec2> flatten(std::span<const glm::dvec3> corners) {
    const glm::dvec3 normal = polygonNormal(corners), size = glm::abs(normal);
    const int drop = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    int u = (drop + 1) % 3, v = (drop + 2) % 3;
    if (normal[drop] < 0) std::swap(u, v);
    std::vector<glm::dvec2> flat;
    for (const glm::dvec3& corner : corners) flat.emplace_back(corner[u] - corners[0][u], corner[v] - corners[0][v]);
    return flat;
}

}  // namespace

glm::dvec3 polygonNormal(std::span<const glm::dvec3> corners) {
    glm::dvec3 normal(0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) normal += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    return normal;
}

void triangulate(std::span<const glm::dvec3> corners, std::vector<std::array<std::uint32_t, 3>>& triangles) {
    const auto n = static_cast<std::uint32_t>(corners.size());
    if (n < 3) return;
    if (n == 3) { triangles.push_back({0, 1, 2}); return; }
    const std::vector<glm::dvec2> p = flatten(corners);

    bool convex = true;
    for (std::uint32_t i = 0; i < n; ++i) convex = convex && area(p[i], p[(i + 1) % n], p[(i + 2) % n]) >= 0;
    if (convex) {
        const std::uint32_t first = n == 4 && glm::distance(corners[1], corners[3]) < glm::distance(corners[0], corners[2]) ? 1 : 0;
        for (std::uint32_t i = 1; i + 1 < n; ++i) triangles.push_back({first, (first + i) % n, (first + i + 1) % n});
        return;
    }

    // Clip ears: corners whose triangle contains no other corner. If a round finds none, clip the next corner anyway.
    std::vector<std::uint32_t> left(n);
    std::iota(left.begin(), left.end(), 0u);
    for (std::size_t i = 0, misses = 0; left.size() > 3;) {
        const std::size_t m = left.size();
        i %= m;
        const std::uint32_t a = left[(i + m - 1) % m], b = left[i], c = left[(i + 1) % m];
        bool isEar = area(p[a], p[b], p[c]) > 0;
        for (std::size_t k = 0; isEar && k < m; ++k)
            isEar = left[k] == a || left[k] == b || left[k] == c || p[left[k]] == p[a] || p[left[k]] == p[b] || p[left[k]] == p[c] ||
                    !contains(p[a], p[b], p[c], p[left[k]]);
        if (!isEar && ++misses <= m) { ++i; continue; }
        triangles.push_back({a, b, c});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
        misses = 0;
    }
    triangles.push_back({left[0], left[1], left[2]});
}

}  // namespace eikonal
