#include "pack/motion.h"

#include <algorithm>
#include <cmath>

namespace eikonal {

Decomposition decompose(const glm::dmat4& m) {
    Decomposition d;
    d.translation = glm::dvec3(m[3]);
    const glm::dmat3 a(m);
    /* Iterate the mean of the matrix and its inverse transpose: it converges to the nearest orthogonal matrix */
    glm::dmat3 r = a / std::cbrt(std::abs(glm::determinant(a)));
    for (int i = 0; i < 100; ++i) {
        const glm::dmat3 next = 0.5 * (r + glm::transpose(glm::inverse(r)));
        double change = 0;
        for (int c = 0; c < 3; ++c) change = std::max(change, glm::length(next[c] - r[c]));
        r = next;
        if (change < 1e-14) break;
    }
    if (glm::determinant(r) < 0) r = -r;
    d.rotation = r;
    d.stretch = glm::transpose(r) * a;
    return d;
}

/// The quaternion of a rotation, from its largest component (Shepperd 1978).
static glm::dvec4 toQuaternion(const glm::dmat3& m) {
    /* 4 q q^T, element by element; m[column][row] */
    const double xx = 1 + m[0][0] - m[1][1] - m[2][2], yy = 1 - m[0][0] + m[1][1] - m[2][2], zz = 1 - m[0][0] - m[1][1] + m[2][2];
    const double ww = 1 + m[0][0] + m[1][1] + m[2][2];
    const double xy = m[0][1] + m[1][0], xz = m[0][2] + m[2][0], yz = m[1][2] + m[2][1];
    const double xw = m[1][2] - m[2][1], yw = m[2][0] - m[0][2], zw = m[0][1] - m[1][0];
    const double largest = std::max({xx, yy, zz, ww});
    const glm::dvec4 q = largest == xx ? glm::dvec4(xx, xy, xz, xw) : largest == yy ? glm::dvec4(xy, yy, yz, yw)
                       : largest == zz ? glm::dvec4(xz, yz, zz, zw) : glm::dvec4(xw, yw, zw, ww);
    return glm::normalize(q);
}

static glm::dmat3 toMatrix(const glm::dvec4& q) {
    const double x = q.x, y = q.y, z = q.z, w = q.w;
    return {1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w), 2 * (x * y - z * w),    1 - 2 * (x * x + z * z),
            2 * (y * z + x * w),     2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)};
}

Motion::Motion(const glm::dmat4& start, const glm::dmat4& end) : start_(decompose(start)), end_(decompose(end)) {
    startRotation_ = toQuaternion(start_.rotation);
    endRotation_ = toQuaternion(end_.rotation);
    if (glm::dot(startRotation_, endRotation_) < 0) endRotation_ = -endRotation_;
    /* By the chord: an arc cosine loses small angles */
    angle_ = 2 * std::asin(std::min(glm::length(endRotation_ - startRotation_) / 2, 1.0));
    if (angle_ < 1e-6) angle_ = 0;
}

glm::dmat4 Motion::at(double t) const {
    const double a = angle_ > 0 ? std::sin((1 - t) * angle_) / std::sin(angle_) : 1 - t,
                 b = angle_ > 0 ? std::sin(t * angle_) / std::sin(angle_) : t;
    const glm::dmat3 stretch = start_.stretch * (1 - t) + end_.stretch * t;
    glm::dmat4 m(toMatrix(glm::normalize(a * startRotation_ + b * endRotation_)) * stretch);
    m[3] = glm::dvec4(glm::mix(start_.translation, end_.translation, t), 1);
    return m;
}

/// A point moves along R(t) y(t) + T(t), where y and T are linear and R rotates by w = 2 angle. Its acceleration is at most
/// a = w^2 |y| + 2 w |y'|, and the path deviates from its chord by at most a / 8 times the duration squared.
Box Motion::bounds(const Box& box, TimeSpan span) const {
    Box reach;
    const glm::dmat4 first = at(span.from), last = at(span.to);
    const double w = 2 * angle_, step = span.to - span.from;
    double stray = 0;
    for (int c = 0; c < 8; ++c) {
        const glm::dvec3 p(c & 1 ? box.high.x : box.low.x, c & 2 ? box.high.y : box.low.y, c & 4 ? box.high.z : box.low.z);
        reach.grow(transformPoint(first, p));
        reach.grow(transformPoint(last, p));
        const glm::dvec3 start = start_.stretch * p, end = end_.stretch * p;
        stray = std::max(stray, w * w * std::max(glm::length(start), glm::length(end)) + 2 * w * glm::length(end - start));
    }
    stray *= step * step / 8;
    reach.low -= stray;
    reach.high += stray;
    return reach;
}

Box boundsInMotion(const std::vector<Motion>& motions, const Box& box, TimeSpan span) {
    Box all;
    if (box.empty()) return all;
    constexpr int steps = 64;
    for (int i = 0; i < steps; ++i) {
        const double from = glm::mix(span.from, span.to, i / double(steps)), to = glm::mix(span.from, span.to, (i + 1) / double(steps));
        Box reach = box;
        for (auto m = motions.rbegin(); m != motions.rend(); ++m) reach = m->bounds(reach, {from, to});
        all.grow(reach);
    }
    return all;
}

motion Motion::pack(const SceneSpace& outer, const SceneSpace& inner) const {
    /* own = inner / scale + center; move the center into the translation, unless it rotates */
    const double k = outer.scale / inner.scale;
    const glm::dvec3 center = inner.center * inner.scale;
    const auto map = [&](const Decomposition& d) {
        glm::dmat4 m(d.stretch * k);
        glm::dvec3 to = (d.translation - outer.center) * outer.scale;
        if (angle_ == 0) to += d.rotation * (d.stretch * inner.center) * outer.scale;
        m[3] = glm::dvec4(to, 1);
        return toAffine(m);
    };
    const auto turn = [](const glm::dvec4& q) {
        return quaternion{static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z), static_cast<float>(q.w)};
    };
    return {map(start_),
            map(end_),
            turn(startRotation_),
            turn(endRotation_),
            static_cast<float>(angle_),
            angle_ == 0 ? vec3{0, 0, 0} : toVec3(center)};
}

bool isInvertible(const glm::dmat4& m) { return std::abs(glm::determinant(glm::dmat3(m))) > 0; }

bool hasMovingParts(const Scene& scene) {
    const auto moves = [](const Shape& s) { return s.worldFromObjectAtEnd.has_value(); };
    return std::ranges::any_of(scene.shapes, moves) ||
           std::ranges::any_of(scene.objects, [&](const Object& o) { return std::ranges::any_of(o.shapes, moves); }) ||
           std::ranges::any_of(scene.instances, [](const Instance& i) { return i.worldFromObjectAtEnd.has_value(); }) ||
           std::ranges::any_of(scene.media, [](const Medium& m) { return m.worldFromMediumAtEnd.has_value(); });
}

TimeSpan timesSeen(const Scene& scene) {
    const auto time = [&](double t) { return std::clamp((t - scene.motionStart) / (scene.motionEnd - scene.motionStart), 0.0, 1.0); };
    return {time(scene.camera.shutterOpen), time(scene.camera.shutterClose)};
}

shutter shutterOf(const Scene& scene) {
    const double span = scene.motionEnd - scene.motionStart;
    return {static_cast<float>((scene.camera.shutterOpen - scene.motionStart) / span),
            static_cast<float>((scene.camera.shutterClose - scene.camera.shutterOpen) / span), hasMovingParts(scene) ? 1u : 0u};
}

}  // namespace eikonal
