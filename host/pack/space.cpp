#include "pack/space.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace eikonal {

glm::dmat4 fromPositions(const glm::dmat4& m, const glm::dvec3& origin) {
    return origin == glm::dvec3(0) ? m : glm::translate(m, origin);
}

glm::dmat4 scaling(double factor) {
    glm::dmat4 m(factor);
    m[3].w = 1;
    return m;
}

glm::dmat4 SceneSpace::sceneFromWorld() const {
    glm::dmat4 m = scaling(scale);
    m[3] = glm::dvec4(-center * scale, 1);
    return m;
}

glm::dmat4 SceneSpace::worldFromScene() const {
    glm::dmat4 m = scaling(1 / scale);
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

glm::dmat3 normalTransform(const glm::dmat4& m) {
    /* Use cofactors instead of the inverse: they give the same direction and work for singular transforms */
    const glm::dmat3 a(m);
    return glm::dmat3(glm::cross(a[1], a[2]), glm::cross(a[2], a[0]), glm::cross(a[0], a[1])) * (swapsHandedness(m) ? -1.0 : 1.0);
}

glm::dvec3 transformNormal(const glm::dmat4& m, glm::dvec3 n) {
    const glm::dvec3 v = normalTransform(m) * n;
    const double length = glm::length(v);
    return length > 0 ? v / length : v;
}

bool swapsHandedness(const glm::dmat4& m) { return glm::determinant(glm::dmat3(m)) < 0; }

double uniformScale(const glm::dmat4& m, double tolerance) {
    const glm::dmat3 a(m);
    const double x = glm::length(a[0]), y = glm::length(a[1]), z = glm::length(a[2]);
    const double skew = std::max({std::abs(glm::dot(a[0], a[1])), std::abs(glm::dot(a[1], a[2])), std::abs(glm::dot(a[0], a[2]))});
    return std::max({std::abs(x - y), std::abs(y - z), skew / x}) < tolerance * x ? x : 0;
}

affine toAffine(const glm::dmat4& m) {
    const auto f = [](double x) { return static_cast<float>(x); };
    return {f(m[0].x), f(m[1].x), f(m[2].x), f(m[3].x), f(m[0].y), f(m[1].y),
            f(m[2].y), f(m[3].y), f(m[0].z), f(m[1].z), f(m[2].z), f(m[3].z)};
}

Box transformed(const Box& box, const glm::dmat4& m) {
    Box reach;
    if (box.empty()) return reach;
    for (unsigned i = 0; i < 8; ++i) reach.grow(transformPoint(m, box.corner(i)));
    return reach;
}

}  // namespace eikonal
