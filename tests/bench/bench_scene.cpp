#include "bench_scene.h"

#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

#include <cmath>
#include <random>

namespace eikonal {

using Point = glm::vec3;

static vec3 toVec3(Point p) { return {p.x, p.y, p.z}; }
static Point toPoint(vec3 p) { return {p.x, p.y, p.z}; }

// ---- meshes -------------------------------------------------------------------------------------------------------------

/// A hash of a lattice point as a number in [-1, 1).
static float latticeValue(int x, int y, int z) {
    uint h = static_cast<uint>(x) * 0x8da6b343u ^ static_cast<uint>(y) * 0xd8163841u ^ static_cast<uint>(z) * 0xcb1ab31fu;
    h ^= h >> 16; h *= 0x7feb352du; h ^= h >> 15; h *= 0x846ca68bu; h ^= h >> 16;
    return static_cast<float>(h) * 0x1p-31f - 1;
}

static float valueNoise(Point p) {
    const Point cell = glm::floor(p), f = p - cell, s = f * f * (3.f - 2.f * f);
    const int x = static_cast<int>(cell.x), y = static_cast<int>(cell.y), z = static_cast<int>(cell.z);
    float corner[2][2][2];
    for (int i = 0; i < 8; ++i) corner[i >> 2][i >> 1 & 1][i & 1] = latticeValue(x + (i & 1), y + (i >> 1 & 1), z + (i >> 2));
    const auto along = [&](int a, int b) { return glm::mix(corner[a][b][0], corner[a][b][1], s.x); };
    return glm::mix(glm::mix(along(0, 0), along(0, 1), s.y), glm::mix(along(1, 0), along(1, 1), s.y), s.z);
}

static float fractalNoise(Point p, int octaves) {
    float sum = 0, weight = 1;
    for (int i = 0; i < octaves; ++i, p *= 2.03f, weight *= 0.5f) sum += weight * valueNoise(p);
    return sum;
}

/// Adds a grid of (n + 1) x (m + 1) points, two triangles a cell.
template <class PointAt> static void addGrid(BenchMesh& mesh, int n, int m, PointAt pointAt) {
    const uint first = static_cast<uint>(mesh.positions.size()), row = static_cast<uint>(m) + 1;
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= m; ++j)
            mesh.positions.push_back(
                toVec3(pointAt(static_cast<float>(i) / static_cast<float>(n), static_cast<float>(j) / static_cast<float>(m))));
    for (uint i = 0; i < static_cast<uint>(n); ++i)
        for (uint j = 0; j < static_cast<uint>(m); ++j) {
            const uint a = first + i * row + j;
            for (const uint k : {a, a + 1, a + row, a + 1, a + row + 1, a + row}) mesh.indices.push_back(k);
        }
}

static Point onSphere(float u, float v) {
    const float theta = glm::pi<float>() * u, phi = glm::two_pi<float>() * v;
    return {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
}

static void addBlock(BenchMesh& mesh, Point centre, Point half, float angle) {
    const float c = std::cos(angle), s = std::sin(angle);
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.f, 1.f})
            addGrid(mesh, 1, 1, [&](float u, float v) {
                Point p;
                p[axis] = side; p[(axis + 1) % 3] = 2 * u - 1; p[(axis + 2) % 3] = 2 * v - 1;
                p *= half;
                return centre + Point(c * p.x + s * p.z, p.y, c * p.z - s * p.x);
            });
}

BenchMesh makeBox() {
    BenchMesh mesh{"box", {}, {}, {0, 0, 0.99f}, {0, 0, -1}, {-.25f, .97f, -.25f}, {.25f, .97f, .25f}};
    addBlock(mesh, {0, 0, 0}, {1, 1, 1}, 0);
    addBlock(mesh, {-.35f, -.4f, -.3f}, {.3f, .6f, .3f}, .3f);
    addBlock(mesh, {.35f, -.7f, .3f}, {.3f, .3f, .3f}, -.3f);
    return mesh;
}

BenchMesh makeTerrain(size_t triangles) {
    BenchMesh mesh{"terrain", {}, {}, {-.9f, .45f, -.9f}, {0, .05f, 0}, {-1, 1.5f, -1}, {1, 2, 1}};
    const auto height = [](Point p) { return .15f * fractalNoise(p * 3.f, 9); };
    const int n = static_cast<int>(std::sqrt(static_cast<double>(triangles) / 4));
    addGrid(mesh, n, n, [&](float u, float v) {
        const Point p{2 * u - 1, 0, 2 * v - 1};
        return Point(p.x, height(p), p.z);
    });
    std::mt19937 rng(7);
    std::uniform_real_distribution<float> uniform(0, 1);
    while (mesh.triangles() < triangles) {
        const float size = .004f * std::pow(20.f, uniform(rng));
        const Point ground{2 * uniform(rng) - 1, 0, 2 * uniform(rng) - 1}, seed = 100.f * Point(uniform(rng), uniform(rng), uniform(rng));
        const Point centre = ground + Point(0, height(ground) + .25f * uniform(rng) * uniform(rng), 0);
        const int rings = 12 + static_cast<int>(20 * uniform(rng));
        addGrid(mesh, rings, 2 * rings, [&](float u, float v) {
            const Point p = onSphere(u, v == 1 ? 0 : v);
            return centre + p * size * (1 + .4f * fractalNoise(p * 2.f + seed, 4));
        });
    }
    return mesh;
}

BenchMesh makeBall(size_t triangles) {
    BenchMesh mesh{"ball", {}, {}, {.3f, .4f, 1.7f}, {0, .1f, 0}, {-2, 2, 1}, {2, 3, 3}};
    const int n = static_cast<int>(std::sqrt(static_cast<double>(triangles) / 4));
    addGrid(mesh, n, 2 * n, [&](float u, float v) {
        const Point p = onSphere(u, v == 1 ? 0 : v);
        return p * (1 + .1f * fractalNoise(p * 3.f, 10));
    });
    addGrid(mesh, 1, 1, [](float u, float v) { return Point(10 * u - 5, 10 * v - 5, -1.5f); });
    return mesh;
}

// ---- rays ---------------------------------------------------------------------------------------------------------------

std::vector<BenchRay> primaryRays(const BenchMesh& mesh, int width, int height) {
    const Point eye = toPoint(mesh.eye), forward = glm::normalize(toPoint(mesh.target) - eye);
    const Point right = glm::normalize(glm::cross(forward, Point(0, 1, 0))), up = glm::cross(right, forward);
    std::vector<BenchRay> rays;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::vec2 pixel(x, y), size(width, height), at = 2.f * (pixel + .5f) / size - 1.f;
            rays.push_back({toVec3(eye), toVec3(glm::normalize(forward + .7f * (at.x * right - at.y * up))), FAR_AWAY});
        }
    return rays;
}

/// The point of a hit, moved off its triangle towards the ray, and the normal on that side.
struct Origin { Point p, n; };
static Origin originAt(const BenchMesh& mesh, const BenchRay& ray, const BenchHit& hit) {
    const uint* index = &mesh.indices[3 * static_cast<size_t>(hit.element)];
    const Point a = toPoint(mesh.positions[index[0]]), b = toPoint(mesh.positions[index[1]]), c = toPoint(mesh.positions[index[2]]);
    Point n = glm::normalize(glm::cross(b - a, c - a));
    if (glm::dot(n, toPoint(ray.d)) > 0) n = -n;
    return {toPoint(ray.o) + hit.t * toPoint(ray.d) + 2e-5f * n, n};
}

std::vector<BenchRay> bouncedRays(const BenchMesh& mesh, const std::vector<BenchRay>& rays, const std::vector<BenchHit>& hits) {
    std::mt19937 rng(11);
    std::uniform_real_distribution<float> uniform(0, 1);
    std::vector<BenchRay> bounced;
    for (size_t i = 0; i < rays.size(); ++i) {
        const Point onUnitSphere = onSphere(std::acos(1 - 2 * uniform(rng)) / glm::pi<float>(), uniform(rng));
        if (hits[i].t < 0) continue;
        const Origin at = originAt(mesh, rays[i], hits[i]);
        bounced.push_back({toVec3(at.p), toVec3(glm::normalize(at.n + .999f * onUnitSphere)), FAR_AWAY});
    }
    return bounced;
}

std::vector<BenchRay> shadowRays(const BenchMesh& mesh, const std::vector<BenchRay>& rays, const std::vector<BenchHit>& hits) {
    std::mt19937 rng(13);
    std::uniform_real_distribution<float> uniform(0, 1);
    std::vector<BenchRay> shadows;
    for (size_t i = 0; i < rays.size(); ++i) {
        const Point light = glm::mix(toPoint(mesh.lightLow), toPoint(mesh.lightHigh), Point(uniform(rng), uniform(rng), uniform(rng)));
        if (hits[i].t < 0) continue;
        const Point o = originAt(mesh, rays[i], hits[i]).p;
        const float distance = glm::distance(o, light);
        shadows.push_back({toVec3(o), toVec3((light - o) / distance), .999f * distance});
    }
    return shadows;
}

}  // namespace eikonal
