#include "read/mesh/polygon.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace eikonal {
namespace {

/// Twice the signed area of a triangle.
double area(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

bool contains(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 p) {
    return area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0;
}

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

/// A polygon whose corners are clipped one by one, and where its reflex corners lie: only they can lie in an ear.
class EarClipper {
public:
    explicit EarClipper(std::span<const glm::dvec2> p)
        : p_(p), next_(p.size()), previous_(p.size()), place_(p.size(), notReflex),
          cells_(std::clamp(static_cast<int>(std::sqrt(p.size()) / 2), 1, 256)), reflexInCell_(indexOf({0, cells_})) {
        low_ = high_ = p[0];
        for (const glm::dvec2& corner : p) {
            low_ = glm::min(low_, corner);
            high_ = glm::max(high_, corner);
        }
        const auto n = static_cast<std::uint32_t>(p.size());
        for (std::uint32_t i = 0; i < n; ++i) {
            next_[i] = (i + 1) % n;
            previous_[i] = (i + n - 1) % n;
        }
        for (std::uint32_t i = 0; i < n; ++i) classify(i);
    }

    std::uint32_t next(std::uint32_t i) const { return next_[i]; }
    std::uint32_t previous(std::uint32_t i) const { return previous_[i]; }

    /// Whether the triangle of corner b and its neighbours contains no other corner.
    bool isEar(std::uint32_t b) const {
        const glm::dvec2 a = p_[previous_[b]], c = p_[next_[b]];
        if (!(area(a, p_[b], c) > 0)) return false;
        const glm::ivec2 from = cellOf(glm::min(glm::min(a, c), p_[b])), to = cellOf(glm::max(glm::max(a, c), p_[b]));
        for (int y = from.y; y <= to.y; ++y)
            for (int x = from.x; x <= to.x; ++x)
                for (const std::uint32_t i : reflexInCell_[indexOf({x, y})])
                    if (p_[i] != a && p_[i] != p_[b] && p_[i] != c && contains(a, p_[b], c, p_[i])) return false;
        return true;
    }

    void clip(std::uint32_t b) {
        const std::uint32_t a = previous_[b], c = next_[b];
        next_[a] = c;
        previous_[c] = a;
        remove(b);
        classify(a);
        classify(c);
    }

private:
    static constexpr std::uint32_t notReflex = ~0u;

    glm::ivec2 cellOf(glm::dvec2 q) const {
        const glm::dvec2 share = (q - low_) / glm::max(high_ - low_, glm::dvec2(std::numeric_limits<double>::min()));
        return glm::clamp(glm::ivec2(glm::clamp(share, 0., 1.) * static_cast<double>(cells_)), 0, cells_ - 1);
    }
    std::size_t indexOf(glm::ivec2 cell) const {
        return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(cells_) + static_cast<std::size_t>(cell.x);
    }

    void remove(std::uint32_t i) {
        if (place_[i] == notReflex) return;
        auto& cell = reflexInCell_[indexOf(cellOf(p_[i]))];
        place_[cell.back()] = place_[i];
        cell[place_[i]] = cell.back();
        cell.pop_back();
        place_[i] = notReflex;
    }

    void classify(std::uint32_t i) {
        remove(i);
        if (area(p_[previous_[i]], p_[i], p_[next_[i]]) > 0) return;
        auto& cell = reflexInCell_[indexOf(cellOf(p_[i]))];
        place_[i] = static_cast<std::uint32_t>(cell.size());
        cell.push_back(i);
    }

    std::span<const glm::dvec2> p_;
    std::vector<std::uint32_t> next_, previous_;
    std::vector<std::uint32_t> place_;                       ///< in its cell; notReflex: in none
    int cells_;                                              ///< per side of the bounds
    std::vector<std::vector<std::uint32_t>> reflexInCell_;
    glm::dvec2 low_, high_;
};

/// Clips ears. If a round finds none, clips the next corner anyway.
void clipEars(std::span<const glm::dvec2> p, std::vector<std::array<std::uint32_t, 3>>& triangles) {
    EarClipper polygon(p);
    std::uint32_t b = 0;
    for (std::size_t left = p.size(), misses = 0; left > 3;) {
        if (!polygon.isEar(b) && ++misses <= left) {
            b = polygon.next(b);
            continue;
        }
        triangles.push_back({polygon.previous(b), b, polygon.next(b)});
        const std::uint32_t after = polygon.next(b);
        polygon.clip(b);
        b = after;
        --left;
        misses = 0;
    }
    const std::uint32_t first = std::min({b, polygon.next(b), polygon.previous(b)});
    triangles.push_back({first, polygon.next(first), polygon.previous(first)});
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

    clipEars(p, triangles);
}

}  // namespace eikonal
