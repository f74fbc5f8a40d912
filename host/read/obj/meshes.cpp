#include "read/obj/meshes.h"

#include "read/mesh/origin.h"
#include "read/mesh/polygon.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace eikonal {
namespace {

bool isFinite(const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

/// The origin of all meshes of the model (read/mesh/origin.h).
glm::dvec3 chooseOffset(const ObjGeometry& geometry) {
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const ObjCorner& corner : geometry.corners) {
        const glm::dvec3& p = geometry.positions[static_cast<std::size_t>(corner.position)];
        if (!isFinite(p)) continue;
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return originOf(low, high);
}

/// The vertices of a mesh; equal corners share one.
class Vertices {
public:
    explicit Vertices(std::size_t positions) : first_(positions, -1) {}

    std::uint32_t find(const ObjCorner& corner) {
        int& first = first_[static_cast<std::size_t>(corner.position)];
        for (int i = first; i >= 0; i = entries_[static_cast<std::size_t>(i)].next) {
            const Entry& entry = entries_[static_cast<std::size_t>(i)];
            if (entry.corner.uv == corner.uv && entry.corner.normal == corner.normal) return static_cast<std::uint32_t>(i);
        }
        entries_.push_back({corner, first});
        first = static_cast<int>(entries_.size()) - 1;
        return static_cast<std::uint32_t>(first);
    }
    std::size_t size() const { return entries_.size(); }
    const ObjCorner& operator[](std::size_t i) const { return entries_[i].corner; }

    void clear() {
        for (const Entry& entry : entries_) first_[static_cast<std::size_t>(entry.corner.position)] = -1;
        entries_.clear();
    }

private:
    struct Entry { ObjCorner corner; int next; };  ///< next: another corner at the same position
    std::vector<Entry> entries_;
    std::vector<int> first_;  ///< by position
};

bool isClosed(const std::vector<std::array<int, 3>>& triangles) {
    // Each edge as (lower, higher, direction); after sorting, both directions are adjacent.
    std::vector<std::array<int, 3>> edges;
    for (const auto& t : triangles)
        for (int i = 0; i < 3; ++i) {
            const int a = t[static_cast<std::size_t>(i)], b = t[static_cast<std::size_t>((i + 1) % 3)];
            edges.push_back({std::min(a, b), std::max(a, b), a < b});
        }
    std::ranges::sort(edges);
    if (edges.size() % 2) return false;
    for (std::size_t i = 0; i < edges.size(); i += 2)
        if (edges[i][0] != edges[i + 1][0] || edges[i][1] != edges[i + 1][1] || edges[i][2] == edges[i + 1][2]) return false;
    return true;
}

void fillMesh(const ObjGeometry& geometry, const Vertices& vertices, const glm::dvec3& offset, Mesh& mesh) {
    bool hasNormals = false, hasUvs = false;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        hasNormals = hasNormals || vertices[i].normal >= 0;
        hasUvs = hasUvs || vertices[i].uv >= 0;
    }
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const ObjCorner& corner = vertices[i];
        mesh.positions.emplace_back(geometry.positions[static_cast<std::size_t>(corner.position)] - offset);
        if (hasUvs) {
            const glm::dvec2 uv = corner.uv >= 0 ? geometry.uvs[static_cast<std::size_t>(corner.uv)] : glm::dvec2(0);
            mesh.uvs.emplace_back(std::isfinite(uv.x) && std::isfinite(uv.y) ? uv : glm::dvec2(0));
        }
        if (hasNormals) {
            const glm::dvec3 n = corner.normal >= 0 ? geometry.normals[static_cast<std::size_t>(corner.normal)] : glm::dvec3(0);
            const double length = glm::length(n);
            mesh.normals.emplace_back(length > 0 && std::isfinite(length) ? n / length : glm::dvec3(0));
        }
    }
}

}  // namespace

ObjMeshes buildMeshes(const ObjGeometry& geometry) {
    ObjMeshes result;
    result.offset = chooseOffset(geometry);
    result.groups.resize(geometry.groups.size());

    // The faces of each group, in file order.
    std::vector<std::vector<std::uint32_t>> facesOf(geometry.groups.size());
    for (std::uint32_t f = 0; f < geometry.faces.size(); ++f) facesOf[geometry.faces[f].group].push_back(f);

    const auto skip = [&result](const ObjFace& face) {
        ++result.degenerate;
        if (result.firstDegenerateLine == 0 || face.line < result.firstDegenerateLine) result.firstDegenerateLine = face.line;
    };
    Vertices vertices(geometry.positions.size());
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<glm::dvec3> polygon;
    for (std::size_t g = 0; g < geometry.groups.size(); ++g) {
        ObjMesh& group = result.groups[g];
        auto mesh = std::make_shared<Mesh>();
        std::vector<std::array<int, 3>> byPosition;
        vertices.clear();
        for (const std::uint32_t f : facesOf[g]) {
            const ObjFace& face = geometry.faces[f];
            polygon.clear();
            for (std::uint32_t i = 0; i < face.cornerCount; ++i)
                polygon.push_back(geometry.positions[static_cast<std::size_t>(geometry.cornersOf(face)[i].position)] - result.offset);
            triangles.clear();
            triangulate(polygon, triangles);
            if (face.cornerCount < 3) skip(face);
            for (const auto& [a, b, c] : triangles) {
                const double area = glm::length(glm::cross(polygon[b] - polygon[a], polygon[c] - polygon[a])) / 2;
                if (!(area > 0) || !std::isfinite(area)) { skip(face); continue; }
                const ObjCorner* corners = geometry.cornersOf(face);
                for (const std::uint32_t i : {a, b, c}) mesh->indices.push_back(vertices.find(corners[i]));
                byPosition.push_back({corners[a].position, corners[b].position, corners[c].position});
                group.area += area;
                if (corners[a].uv >= 0 && corners[b].uv >= 0 && corners[c].uv >= 0) {
                    const auto uv = [&](std::uint32_t i) { return geometry.uvs[static_cast<std::size_t>(corners[i].uv)]; };
                    const glm::dvec2 s = uv(b) - uv(a), t = uv(c) - uv(a);
                    group.uvArea += std::abs(s.x * t.y - s.y * t.x) / 2;
                }
            }
        }
        if (mesh->indices.empty()) continue;
        fillMesh(geometry, vertices, result.offset, *mesh);
        result.triangles += byPosition.size();
        group.isClosed = isClosed(byPosition);
        group.mesh = std::move(mesh);
    }
    return result;
}

}  // namespace eikonal
