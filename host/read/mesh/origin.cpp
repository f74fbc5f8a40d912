#include "read/mesh/origin.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace eikonal {

glm::dvec3 originOf(const glm::dvec3& low, const glm::dvec3& high) {
    const glm::dvec3 farthest = glm::max(glm::abs(low), glm::abs(high)), size = high - low;
    constexpr double farAway = 16;
    return std::max({farthest.x, farthest.y, farthest.z}) > farAway * std::max({size.x, size.y, size.z}) ? (low + high) / 2.
                                                                                                         : glm::dvec3(0);
}

glm::dvec3 originOf(std::span<const glm::dvec3> points) {
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const glm::dvec3& p : points) {
        if (!std::isfinite(p.x + p.y + p.z)) continue;
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const glm::dvec3 origin = originOf(low, high);
    if (origin == glm::dvec3(0)) return origin;
    const bool areFloats = std::ranges::all_of(points, [](const glm::dvec3& p) { return glm::dvec3(glm::vec3(p)) == p; });
    return areFloats ? glm::dvec3(0) : origin;
}

std::vector<glm::vec3> positionsFrom(const glm::dvec3& origin, std::span<const glm::dvec3> points) {
    std::vector<glm::vec3> positions;
    positions.reserve(points.size());
    for (const glm::dvec3& p : points) positions.emplace_back(p - origin);
    return positions;
}

void setPositions(Mesh& mesh, std::span<const glm::dvec3> points) {
    mesh.origin = originOf(points);
    mesh.positions = positionsFrom(mesh.origin, points);
}

}  // namespace eikonal
