#pragma once
// Scene space: the device computes in single precision, so the scene is moved and scaled, in double precision, to coordinates
// of order one. The scale is a power of two, which keeps mantissas: a scene and a copy that is 2^k times as large give the same bits.

#include "eikonal/portable.h"

#include <glm/glm.hpp>

namespace eikonal {

/// p_scene = (p_world - center) * scale.
struct SceneSpace {
    glm::dvec3 center{0};
    double scale = 1;   ///< a power of two

    glm::dmat4 sceneFromWorld() const;
    glm::dmat4 worldFromScene() const;
};

/// A box, empty at first.
struct Box {
    glm::dvec3 low{1e300}, high{-1e300};
    void grow(glm::dvec3 p) { low = glm::min(low, p); high = glm::max(high, p); }
    void grow(const Box& b) { low = glm::min(low, b.low); high = glm::max(high, b.high); }
    bool empty() const { return low.x > high.x; }
    glm::dvec3 center() const { return 0.5 * (low + high); }
    /// Corner i of 8: high on the axes whose bits are set.
    glm::dvec3 corner(unsigned i) const { return {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z}; }
    double radius() const { return 0.5 * glm::length(high - low); }
};

/// The space in which a box has its centre at the origin and a radius in (1/2, 1]; for a point, only the translation; for an empty box,
/// world space.
SceneSpace spaceOf(const Box& box);

/// Bounds of a transformed box.
Box transformed(const Box& box, const glm::dmat4& m);

/// The matrix m, applied to positions relative to an origin.
glm::dmat4 fromPositions(const glm::dmat4& m, const glm::dvec3& origin);

/// Multiplies all lengths by `factor`.
glm::dmat4 scaling(double factor);

glm::dvec3 transformPoint(const glm::dmat4& m, glm::dvec3 p);
glm::dvec3 transformVector(const glm::dmat4& m, glm::dvec3 v);
/// The matrix whose product with a normal is the transformed normal, of another length.
glm::dmat3 normalTransform(const glm::dmat4& m);
/// The result has unit length; zero stays zero.
glm::dvec3 transformNormal(const glm::dmat4& m, glm::dvec3 n);
bool swapsHandedness(const glm::dmat4& m);
/// The scale of a transform that keeps angles, which maps spheres to spheres; 0 for any other. tolerance: relative.
double uniformScale(const glm::dmat4& m, double tolerance = 1e-4);

affine toAffine(const glm::dmat4& m);
inline vec3 toVec3(glm::dvec3 v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }

}  // namespace eikonal
