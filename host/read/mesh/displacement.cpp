#include "read/mesh/displacement.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <vector>

namespace eikonal {
namespace {

using Corners = glm::uvec3;

Corners cornersOf(const Mesh& mesh, std::size_t triangle) {
    const std::uint32_t* corner = mesh.indices.data() + 3 * triangle;
    return {corner[0], corner[1], corner[2]};
}

glm::dvec3 placeOf(const glm::vec3& p, const Transform& worldFromObject) { return worldFromObject * glm::dvec4(p, 1); }

glm::vec3 unitOrZero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0 ? v / length : glm::dvec3(0);
}

/// Sets each vertex normal to the mean of its faces' normals, with equal weights.
void averageNormals(Mesh& mesh) {
    mesh.normals.assign(mesh.positions.size(), glm::vec3(0));
    for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) {
        const Corners c = cornersOf(mesh, t);
        const glm::dvec3 a = mesh.positions[c.x], b = mesh.positions[c.y];
        const glm::vec3 n = unitOrZero(glm::cross(b - a, glm::dvec3(mesh.positions[c.z]) - b));
        for (int k = 0; k < 3; ++k) mesh.normals[c[k]] += n;
    }
    for (glm::vec3& n : mesh.normals) n = unitOrZero(n);
}

/// The area of a mesh, and the sum of its triangles' longest edges; world space.
struct Extent { double area = 0, length = 0; };

Extent extentOf(const Mesh& mesh, const Transform& worldFromObject) {
    const auto place = [&](std::uint32_t vertex) { return placeOf(mesh.positions[vertex], worldFromObject); };
    Extent sum;
    for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) {
        const Corners c = cornersOf(mesh, t);
        const glm::dvec3 x = place(c.x), y = place(c.y), z = place(c.z);
        sum.area += 0.5 * glm::length(glm::cross(y - x, z - x));
        sum.length += std::max({glm::length(y - x), glm::length(z - y), glm::length(x - z)});
    }
    return sum;
}

struct HashEdge {
    std::size_t operator()(std::uint64_t edge) const { edge *= 0x9e3779b97f4a7c15u; return edge ^ edge >> 32; }
};

class EdgeSplitter {
public:
    EdgeSplitter(Mesh& mesh, const Transform& worldFromObject, double edgeLength)
        : mesh_(mesh), worldFromObject_(worldFromObject), limit_(edgeLength) {
        for (const glm::vec3& p : mesh.positions) places_.push_back(placeOf(p, worldFromObject));
    }

    Split split() {
        std::vector<std::uint32_t> whole;
        std::vector<Corners> open;
        for (std::size_t t = 0; t < mesh_.indices.size() / 3; ++t) {
            open.push_back(cornersOf(mesh_, t));
            while (!open.empty()) {
                const Corners given = open.back(), c = longestEdgeFirst(given);
                open.pop_back();
                if (lengthOf(c.x, c.y) < limit_) {
                    whole.insert(whole.end(), {given.x, given.y, given.z});
                    continue;
                }
                if (whole.size() / 3 + open.size() >= mostDisplacedTriangles) return Split::tooMany;
                const std::uint32_t middle = middleOf(c.x, c.y);
                if (places_[middle] == places_[c.x] || places_[middle] == places_[c.y]) return Split::tooFine;
                open.push_back({middle, c.y, c.z});
                open.push_back({c.x, middle, c.z});
            }
        }
        mesh_.indices = std::move(whole);
        return Split::done;
    }

private:
    double lengthOf(std::uint32_t a, std::uint32_t b) const { return glm::length(places_[a] - places_[b]); }

    /// The same triangle, rotated so that its longest edge goes from x to y.
    Corners longestEdgeFirst(Corners c) const {
        const double xy = lengthOf(c.x, c.y), yz = lengthOf(c.y, c.z), zx = lengthOf(c.z, c.x);
        if (xy > yz && xy > zx) return c;
        if (xy <= yz && yz > zx) return {c.y, c.z, c.x};
        return {c.z, c.x, c.y};
    }

    std::uint32_t middleOf(std::uint32_t a, std::uint32_t b) {
        const auto [found, isNew] = middles_.try_emplace(std::uint64_t(std::min(a, b)) << 32 | std::max(a, b), static_cast<std::uint32_t>(mesh_.positions.size()));
        if (!isNew) return found->second;
        mesh_.positions.push_back(0.5f * (mesh_.positions[a] + mesh_.positions[b]));
        mesh_.normals.push_back(unitOrZero(glm::dvec3(mesh_.normals[a]) + glm::dvec3(mesh_.normals[b])));
        if (!mesh_.uvs.empty()) mesh_.uvs.push_back(0.5f * (mesh_.uvs[a] + mesh_.uvs[b]));
        places_.push_back(placeOf(mesh_.positions.back(), worldFromObject_));
        return found->second;
    }

    Mesh& mesh_;
    const Transform& worldFromObject_;
    double limit_;                        ///< all edges must become shorter than this
    std::vector<glm::dvec3> places_;      ///< of all vertices, world space
    std::unordered_map<std::uint64_t, std::uint32_t, HashEdge> middles_;   ///< (smaller end, larger end) -> vertex
};

}  // namespace

Split splitLongEdges(Mesh& mesh, const Transform& worldFromObject, double edgeLength) {
    /* Bound the number of triangles from below: the largest triangle with short edges is equilateral, and an edge that is split into n
       parts belongs to at least n triangles */
    const Extent extent = extentOf(mesh, worldFromObject);
    const double most = static_cast<double>(mostDisplacedTriangles), triangles = static_cast<double>(mesh.indices.size() / 3);
    if (extent.area / edgeLength > most * std::sqrt(3.0) / 4 * edgeLength || extent.length > (most + triangles) * edgeLength) return Split::tooMany;
    if (mesh.normals.empty()) averageNormals(mesh);
    return EdgeSplitter(mesh, worldFromObject, edgeLength).split();
}

double shortestEdgeLength(const Mesh& mesh, const Transform& worldFromObject) {
    /* Unless it is very narrow, a triangle of repeated bisection has at least a sixteenth of the area of the square over that length */
    const Extent extent = extentOf(mesh, worldFromObject);
    const double most = static_cast<double>(mostDisplacedTriangles);
    return std::max(4 * std::sqrt(extent.area / most), 4 * extent.length / most);
}

void displaceVertices(Mesh& mesh, std::span<const float> heights) {
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) mesh.positions[i] += heights[i] * mesh.normals[i];
    averageNormals(mesh);
}

}  // namespace eikonal
