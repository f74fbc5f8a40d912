#include "pack/space.h"

#include "overloaded.h"

#include <algorithm>
#include <cmath>

namespace eikonal {

glm::dmat4 SceneSpace::sceneFromWorld() const {
    glm::dmat4 m(scale);
    m[3] = glm::dvec4(-center * scale, 1);
    return m;
}

glm::dmat4 SceneSpace::worldFromScene() const {
    glm::dmat4 m(1 / scale);
    m[3] = glm::dvec4(center, 1);
    return m;
}

SceneSpace spaceOf(const Box& box) {
    SceneSpace space;
    if (box.empty()) return space;
    space.center = box.center();
    const double radius = box.radius();
    if (!(radius > 0) || !std::isfinite(radius)) return space;
    int exponent = 0;
    if (std::frexp(radius, &exponent) == 0.5) --exponent;  // a radius of exactly 2^k becomes 1
    space.scale = std::ldexp(1.0, -exponent);
    return space;
}

glm::dvec3 transformPoint(const glm::dmat4& m, glm::dvec3 p) { return glm::dvec3(m * glm::dvec4(p, 1)); }
glm::dvec3 transformVector(const glm::dmat4& m, glm::dvec3 v) { return glm::dmat3(m) * v; }

glm::dvec3 transformNormal(const glm::dmat4& m, glm::dvec3 n) {
    /* Cofactors instead of the inverse: the same direction, also for a singular map */
    const glm::dmat3 a(m);
    const glm::dvec3 v = glm::dmat3(glm::cross(a[1], a[2]), glm::cross(a[2], a[0]), glm::cross(a[0], a[1])) * n * (swapsHandedness(m) ? -1.0 : 1.0);
    const double length = glm::length(v);
    return length > 0 ? v / length : v;
}

bool swapsHandedness(const glm::dmat4& m) { return glm::determinant(glm::dmat3(m)) < 0; }

double uniformScale(const glm::dmat4& m) {
    const glm::dmat3 a(m);
    const double x = glm::length(a[0]), y = glm::length(a[1]), z = glm::length(a[2]);
    const double skew = std::max({std::abs(glm::dot(a[0], a[1])), std::abs(glm::dot(a[1], a[2])), std::abs(glm::dot(a[0], a[2]))});
    return std::max({std::abs(x - y), std::abs(y - z), skew / x}) < 1e-4 * x ? x : 0;
}

affine toAffine(const glm::dmat4& m) {
    const auto f = [](double x) { return static_cast<float>(x); };
    return {f(m[0].x), f(m[1].x), f(m[2].x), f(m[3].x), f(m[0].y), f(m[1].y), f(m[2].y), f(m[3].y), f(m[0].z), f(m[1].z), f(m[2].z), f(m[3].z)};
}

static void growByCorners(Box& box, const glm::dmat4& m, glm::dvec3 low, glm::dvec3 high) {
    for (int i = 0; i < 8; ++i) box.grow(transformPoint(m, {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z}));
}

Box transformed(const Box& box, const glm::dmat4& m) {
    Box reach;
    if (!box.empty()) growByCorners(reach, m, box.low, box.high);
    return reach;
}

static Box meshBounds(const Mesh& mesh, const glm::dmat4& m) {
    Box box;
    for (const glm::vec3& p : mesh.positions) box.grow(transformPoint(m, p));
    return box;
}

Box boundsOf(const Shape& shape, const glm::dmat4& m) {
    return std::visit(Overloaded{
        [&](const TriangleMesh& s) { return meshBounds(*s.mesh, m); },
        [&](const BilinearMesh& s) { return meshBounds(*s.mesh, m); },
        [&](const Sphere& s) {
            Box box;
            growByCorners(box, m, {-s.radius, -s.radius, std::max(-s.radius, s.zMin)}, {s.radius, s.radius, std::min(s.radius, s.zMax)});
            return box;
        },
        [&](const Disk& s) {
            Box box;
            growByCorners(box, m, {-s.radius, -s.radius, s.height}, {s.radius, s.radius, s.height});
            return box;
        },
        [&](const CurveShape& s) {
            Box box;
            for (const CurveSegment& segment : s.curve->segments) {
                const double half = 0.5 * std::max(segment.width[0], segment.width[1]);
                for (const glm::dvec3 p : segment.points) growByCorners(box, m, p - half, p + half);
            }
            return box;
        },
        [&](const ImplicitSurface& s) {
            Box box;
            growByCorners(box, m, s.low, s.high);
            return box;
        },
        [&](const Cylinder& s) {
            /* A circle reaches as far along each axis as its two radii together, at right angles */
            const glm::dvec3 reach = s.radius * glm::sqrt(glm::dvec3(m[0] * m[0] + m[1] * m[1]));
            Box box;
            for (const double z : {s.zMin, s.zMax})
                for (const double side : {-1.0, 1.0}) box.grow(transformPoint(m, {0, 0, z}) + side * reach);
            return box;
        }}, shape.kind);
}

}  // namespace eikonal
