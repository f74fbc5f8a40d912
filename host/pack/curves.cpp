#include "pack/curves.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace eikonal {

/// The most splits: 2^10 elements of eight pieces each are as fine as the finest subdivision in pbrt-v4.
constexpr int mostSplits = 10;

uint curveSplits(const Curve& curve) {
    int splits = std::clamp(curve.splitDepth, 0, mostSplits);
    for (const CurveSegment& s : curve.segments) {
        const double width = std::max(s.width[0], s.width[1]);
        if (width <= 0) continue;
        double bend =
            0; /* how far the control points are from evenly spaced: a piece is off its chord by less than 6/8 of that, over pieces^2 */
        for (size_t i = 0; i < 2; ++i) bend = std::max<double>(bend, glm::length(s.points[i] - 2.f * s.points[i + 1] + s.points[i + 2]));
        const double pieces = std::sqrt(bend * 6 / 8 * std::sqrt(2.0) / (width / 20));
        while (splits < mostSplits && std::ldexp(8.0, splits) < pieces) ++splits;
    }
    return static_cast<uint>(splits);
}

curve packSegment(const CurveSegment& segment, curve_type type, const glm::dmat4& m, double scale) {
    curve c{};
    for (size_t i = 0; i < 4; ++i) c.p[i] = toVec3(transformPoint(m, segment.points[i]));
    for (size_t i = 0; i < 2; ++i) c.width[i] = static_cast<float>(segment.width[i] * scale);
    c.type = type;
    if (type != curve_ribbon) return c;
    const std::array<glm::dvec3, 2> n{transformNormal(m, segment.normals[0]), transformNormal(m, segment.normals[1])};
    for (size_t i = 0; i < 2; ++i) c.n[i] = toVec3(n[i]);
    /* Opposite normals have no shortest rotation between them */
    const double angle = std::atan2(glm::length(glm::cross(n[0], n[1])), glm::dot(n[0], n[1]));
    c.normal_angle = angle < 1e-4 || angle > M_PI - 1e-4 ? 0.0f : static_cast<float>(angle);
    return c;
}

Box boundsOfPart(const curve& c, uint part, uint splits) {
    /* The control points of the part: the curve's polar form at (u0, u0, u0), (u0, u0, u1), (u0, u1, u1), (u1, u1, u1) */
    const double u0 = std::ldexp(part, -static_cast<int>(splits)), u1 = std::ldexp(part + 1, -static_cast<int>(splits));
    const auto point = [&](int i) { return glm::dvec3(c.p[i].x, c.p[i].y, c.p[i].z); };
    const auto polar = [&](double a, double b, double d) {
        std::array<glm::dvec3, 3> q{glm::mix(point(0), point(1), a), glm::mix(point(1), point(2), a), glm::mix(point(2), point(3), a)};
        return glm::mix(glm::mix(q[0], q[1], b), glm::mix(q[1], q[2], b), d);
    };
    Box box;
    for (const glm::dvec3& p : {polar(u0, u0, u0), polar(u0, u0, u1), polar(u0, u1, u1), polar(u1, u1, u1)}) box.grow(p);
    const auto widthAt = [&](double u) { return glm::mix(static_cast<double>(c.width[0]), static_cast<double>(c.width[1]), u); };
    const double half = 0.5 * std::max(widthAt(u0), widthAt(u1));
    box.low -= half;
    box.high += half;
    return box;
}

}  // namespace eikonal
