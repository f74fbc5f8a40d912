#include "read/mesh/loop_subdivision.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace eikonal {
namespace {

using Index = std::uint32_t;
constexpr Index nobody = ~Index(0);

/// Edge k of a face goes from its corner k to corner k + 1. side: the faces of an edge, as 3 * face + k; `nobody` beyond a boundary.
struct Edge { std::array<Index, 2> vertex; std::array<Index, 2> side; };
struct Face { std::array<Index, 3> vertex, edge; };

/// The next and previous corner or edge of a triangle.
constexpr int next(int k) { return k == 2 ? 0 : k + 1; }
constexpr int previous(int k) { return k == 0 ? 2 : k - 1; }

/// One level of subdivision: points, faces, and the edges between faces.
struct Level {
    std::vector<glm::dvec3> points;
    std::vector<Face> faces;
    std::vector<Edge> edges;
};

/// Sums over a vertex's neighbours for the subdivision rules.
struct Ring {
    glm::dvec3 sum{0}, boundarySum{0};   ///< over all neighbours, and over those along boundaries
    int count = 0, boundaryCount = 0;
};

template <class F> void inParallel(size_t count, const F& f) {
    tbb::parallel_for(tbb::blocked_range<size_t>(0, count, 4096), [&](const tbb::blocked_range<size_t>& range) {
        for (size_t i = range.begin(); i < range.end(); ++i) f(i);
    });
}

/// The mesh without faces that name a vertex twice, and without unused vertices.
Level firstLevel(const Mesh& mesh, size_t& droppedFaces) {
    Level level;
    std::vector<Index> number(mesh.positions.size(), nobody);
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const Index *v = &mesh.indices[i];
        if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) { ++droppedFaces; continue; }
        Face face{};
        for (int k = 0; k < 3; ++k) {
            if (number[v[k]] == nobody) {
                number[v[k]] = static_cast<Index>(level.points.size());
                level.points.push_back(mesh.positions[v[k]]);
            }
            face.vertex[k] = number[v[k]];
        }
        level.faces.push_back(face);
    }

    /* Pair up sides with the same two ends, in the order of their faces */
    struct Side { Index low, high, side; };
    std::vector<Side> sides;
    for (size_t f = 0; f < level.faces.size(); ++f)
        for (int k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(level.faces[f].vertex[k], level.faces[f].vertex[next(k)]);
            sides.push_back({low, high, static_cast<Index>(3 * f + k)});
        }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return std::tie(a.low, a.high, a.side) < std::tie(b.low, b.high, b.side); });
    for (size_t i = 0; i < sides.size();) {
        const bool pair = i + 1 < sides.size() && sides[i].low == sides[i + 1].low && sides[i].high == sides[i + 1].high;
        const auto edge = static_cast<Index>(level.edges.size());
        level.edges.push_back({{sides[i].low, sides[i].high}, {sides[i].side, pair ? sides[i + 1].side : nobody}});
        for (int s = 0; s <= pair; ++s) level.faces[sides[i + s].side / 3].edge[sides[i + s].side % 3] = edge;
        i += 1 + pair;
    }
    return level;
}

/// Sequential, so sums do not depend on the number of threads.
std::vector<Ring> gatherRings(const Level& level) {
    std::vector<Ring> rings(level.points.size());
    for (const Edge& e : level.edges)
        for (int end = 0; end < 2; ++end) {
            Ring& ring = rings[e.vertex[end]];
            const glm::dvec3& p = level.points[e.vertex[1 - end]];
            ring.sum += p;
            ++ring.count;
            if (e.side[1] == nobody) { ring.boundarySum += p; ++ring.boundaryCount; }
        }
    return rings;
}

/// (1 - n weight) p + weight * (sum of the n neighbours that count).
glm::dvec3 blend(const Ring& ring, const glm::dvec3& p, double weight, double boundaryWeight) {
    if (ring.boundaryCount > 0) return (1 - ring.boundaryCount * boundaryWeight) * p + boundaryWeight * ring.boundarySum;
    return (1 - ring.count * weight) * p + weight * ring.sum;
}

double loopBeta(int valence) { return valence == 3 ? 3. / 16 : 3. / (8. * valence); }
double loopGamma(int valence) { return 1 / (valence + 3 / (8 * loopBeta(valence))); }

/// Splits each face in four: child k at corner k, child 3 in the middle. Edge e becomes vertex (old vertices) + e, and edges 2 e (at its
/// first end) and 2 e + 1; edge 2 (old edges) + 3 f + k lies between child k of face f and the middle child.
Level split(const Level& old) {
    Level level;
    const size_t vertices = old.points.size(), edges = old.edges.size(), faces = old.faces.size();
    const std::vector<Ring> rings = gatherRings(old);
    level.points.resize(vertices + edges);
    inParallel(vertices, [&](size_t v) { level.points[v] = blend(rings[v], old.points[v], loopBeta(std::max(rings[v].count, 1)), 1. / 8); });

    /* The corner of a face opposite to one of its edges */
    const auto opposite = [&](Index side) { return old.points[old.faces[side / 3].vertex[previous(static_cast<int>(side % 3))]]; };
    inParallel(edges, [&](size_t e) {
        const Edge& edge = old.edges[e];
        const glm::dvec3 ends = old.points[edge.vertex[0]] + old.points[edge.vertex[1]];
        level.points[vertices + e] = edge.side[1] == nobody ? 0.5 * ends : 3. / 8 * ends + 1. / 8 * (opposite(edge.side[0]) + opposite(edge.side[1]));
    });

    level.faces.resize(4 * faces);
    level.edges.resize(2 * edges + 3 * faces);
    const auto middle = [&](Index edge) { return static_cast<Index>(vertices + edge); };
    const auto half = [&](Index edge, Index vertex) { return 2 * edge + (old.edges[edge].vertex[0] == vertex ? 0 : 1); };
    inParallel(faces, [&](size_t f) {
        const Face& face = old.faces[f];
        const auto inner = [&](int k) { return static_cast<Index>(2 * edges + 3 * f + static_cast<size_t>(k)); };
        for (int k = 0; k < 3; ++k) {
            const int p = previous(k);
            Face& child = level.faces[4 * f + static_cast<size_t>(k)];
            /* Rotate the child's corners so that its corner k is the face's corner k, as in pbrt-v4 */
            child.vertex[k] = face.vertex[k];
            child.vertex[next(k)] = middle(face.edge[k]);
            child.vertex[p] = middle(face.edge[p]);
            child.edge[k] = half(face.edge[k], face.vertex[k]);
            child.edge[next(k)] = inner(k);
            child.edge[p] = half(face.edge[p], face.vertex[k]);
            Face& centre = level.faces[4 * f + 3];
            centre.vertex[k] = middle(face.edge[k]);
            centre.edge[k] = inner(next(k));
            level.edges[inner(k)] = {{middle(face.edge[k]), middle(face.edge[p])},
                                     {static_cast<Index>(3 * (4 * f + static_cast<size_t>(k)) + static_cast<size_t>(next(k))), static_cast<Index>(3 * (4 * f + 3) + static_cast<size_t>(p))}};
        }
    });
    inParallel(edges, [&](size_t e) {
        const Edge& edge = old.edges[e];
        for (int end = 0; end < 2; ++end) {
            Edge& part = level.edges[2 * e + static_cast<size_t>(end)];
            part.vertex = {edge.vertex[end], middle(static_cast<Index>(e))};
            for (int s = 0; s < 2; ++s) {
                if (edge.side[s] == nobody) { part.side[s] = nobody; continue; }
                /* The child at this end of the edge in the face on this side; its side k or k - 1 is this part */
                const Index f = edge.side[s] / 3;
                const int side = static_cast<int>(edge.side[s] % 3);
                const int corner = old.faces[f].vertex[side] == edge.vertex[end] ? side : next(side);
                part.side[s] = 3 * (4 * f + static_cast<Index>(corner)) + static_cast<Index>(side);
            }
        }
    });
    return level;
}

/// Lists the neighbours of the vertex at a corner in order, from face to face across the edges at the vertex. At a boundary the list begins
/// with the boundary neighbour and runs in the opposite direction. `side` is 3 * face + corner. With inconsistent orientations the loop may
/// not return to its start; it stops after `count` neighbours, the most that exist.
void walkRing(const Level& level, Index side, bool boundary, int count, std::vector<Index>& ring) {
    ring.clear();
    const Index vertex = level.faces[side / 3].vertex[side % 3];
    const auto cornerOf = [&](Index face) {
        const Face& f = level.faces[face];
        return f.vertex[0] == vertex ? 0 : f.vertex[1] == vertex ? 1 : 2;
    };
    /* The face across edge k of a face; `nobody` at a boundary */
    const auto across = [&](Index face, int k) {
        const Edge& e = level.edges[level.faces[face].edge[k]];
        const Index here = 3 * face + static_cast<Index>(k), other = e.side[0] == here ? e.side[1] : e.side[0];
        return other == nobody ? nobody : other / 3;
    };
    const auto longest = static_cast<size_t>(count);
    const Index start = side / 3;
    Index face = start;
    if (!boundary) {
        do {
            const int k = cornerOf(face);
            ring.push_back(level.faces[face].vertex[next(k)]);
            face = across(face, k);
        } while (face != start && face != nobody && ring.size() < longest);
        return;
    }
    for (size_t steps = 0; steps < longest; ++steps) {
        const Index following = across(face, cornerOf(face));
        if (following == nobody || following == start) break;
        face = following;
    }
    ring.push_back(level.faces[face].vertex[next(cornerOf(face))]);
    const Index last = face;
    do {
        const int k = cornerOf(face);
        ring.push_back(level.faces[face].vertex[previous(k)]);
        face = across(face, previous(k));
    } while (face != nobody && face != last && ring.size() < longest);
}

/// The cross product of two tangents of the surface at a vertex, from its ring (Hoppe et al. 1994, "Piecewise Smooth Surface
/// Reconstruction").
glm::dvec3 normalAt(const std::vector<glm::dvec3>& points, const glm::dvec3& p, const std::vector<Index>& ring, bool boundary) {
    const size_t n = ring.size();
    const auto at = [&](size_t i) { return points[ring[i]]; };
    glm::dvec3 s(0), t(0);
    if (!boundary) {
        for (size_t i = 0; i < n; ++i) {
            const double angle = 2 * M_PI * static_cast<double>(i) / static_cast<double>(n);
            s += std::cos(angle) * at(i);
            t += std::sin(angle) * at(i);
        }
        return glm::cross(s, t);
    }
    s = at(n - 1) - at(0);
    if (n == 2) t = at(0) + at(1) - 2. * p;
    else if (n == 3) t = at(1) - p;
    else if (n == 4) t = 2. * (at(1) + at(2)) - at(0) - at(3) - 2. * p;
    else {
        const double angle = M_PI / static_cast<double>(n - 1);
        t = -std::sin(angle) * (at(0) + at(n - 1));
        for (size_t i = 1; i + 1 < n; ++i) t -= (2 * std::cos(angle) - 2) * std::sin(static_cast<double>(i) * angle) * at(i);
    }
    return glm::cross(s, t);
}

/// Moves the finest level's points to the limit surface; tangents are computed from the moved points (as in pbrt-v4).
Mesh limitOf(const Level& level) {
    const size_t vertices = level.points.size();
    const std::vector<Ring> rings = gatherRings(level);
    std::vector<glm::dvec3> points(vertices);
    inParallel(vertices, [&](size_t v) { points[v] = blend(rings[v], level.points[v], loopGamma(std::max(rings[v].count, 1)), 1. / 5); });

    std::vector<Index> someCorner(vertices);
    for (size_t f = 0; f < level.faces.size(); ++f)
        for (int k = 0; k < 3; ++k) someCorner[level.faces[f].vertex[k]] = static_cast<Index>(3 * f + static_cast<size_t>(k));
    Mesh mesh;
    mesh.positions.resize(vertices);
    mesh.normals.resize(vertices);
    tbb::parallel_for(tbb::blocked_range<size_t>(0, vertices, 4096), [&](const tbb::blocked_range<size_t>& range) {
        std::vector<Index> ring;
        for (size_t v = range.begin(); v < range.end(); ++v) {
            const bool boundary = rings[v].boundaryCount > 0;
            walkRing(level, someCorner[v], boundary, rings[v].count, ring);
            mesh.positions[v] = points[v];
            const glm::dvec3 n = ring.size() < 2 ? glm::dvec3(0) : normalAt(points, points[v], ring, boundary);
            const double length = glm::length(n);
            mesh.normals[v] = length > 0 ? n / length : n;
        }
    });
    mesh.indices.resize(3 * level.faces.size());
    inParallel(level.faces.size(), [&](size_t f) { std::copy(level.faces[f].vertex.begin(), level.faces[f].vertex.end(), &mesh.indices[3 * f]); });
    return mesh;
}

}  // namespace

SubdividedMesh subdivideByLoop(const Mesh& mesh, int levels) {
    SubdividedMesh result;
    Level level = firstLevel(mesh, result.droppedFaces);
    for (int i = 0; i < levels && !level.faces.empty(); ++i) level = split(level);
    result.mesh = limitOf(level);
    return result;
}

}  // namespace eikonal
