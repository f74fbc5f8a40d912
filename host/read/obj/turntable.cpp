#include "read/obj/turntable.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace eikonal {
namespace {

/// Calls f(h, r) for each vertex: its height above the target along the axis, and its distance from the axis.
template <class F>
void forCircles(const std::vector<ViewedTriangle>& triangles, const View& view, F f) {
    const glm::dvec3 axis = glm::normalize(view.up);
    for (const ViewedTriangle& triangle : triangles)
        for (const glm::vec3& vertex : {triangle.a, triangle.b, triangle.c}) {
            const glm::dvec3 p = glm::dvec3(vertex) - view.target;
            const double h = glm::dot(p, axis);
            f(h, glm::length(p - h * axis));
        }
}

/// Sine and cosine of the camera's elevation above the target.
glm::dvec2 elevationOf(const View& view) {
    const double sine = std::clamp(glm::dot(glm::normalize(view.eye - view.target), glm::normalize(view.up)), -1., 1.);
    return {sine, std::sqrt(1 - sine * sine)};
}

}  // namespace

/// A vertex at azimuth a from the camera is h sin e + r cos e cos a nearer than the target, r sin a to the right, and
/// h cos e - r sin e cos a above the middle. What it needs of the distance is largest at a = 0 or pi for its height in the image, and has
/// its maximum over a in closed form for its width.
double turningDistance(const std::vector<ViewedTriangle>& triangles, const View& view, glm::dvec2 halfTangents, double size) {
    const glm::dvec2 e = elevationOf(view), widening = 1.05 / halfTangents;
    double distance = 0.05 * size;
    forCircles(triangles, view, [&](double h, double r) {
        distance = std::max({distance, h * e.x + r * std::hypot(e.y, widening.x), h * e.x + r * e.y + 0.05 * size});
        for (const double side : {r, -r}) distance = std::max(distance, h * e.x + side * e.y + std::abs(h * e.y - side * e.x) * widening.y);
    });
    return distance;
}

bool isTurnWider(const std::vector<ViewedTriangle>& triangles, const View& view, double ratio) {
    const glm::dvec2 e = elevationOf(view);
    double radius = 0, low = std::numeric_limits<double>::infinity(), high = -low;
    forCircles(triangles, view, [&](double h, double r) {
        radius = std::max(radius, r);
        low = std::min(low, h * e.y - r * std::abs(e.x));
        high = std::max(high, h * e.y + r * std::abs(e.x));
    });
    return !triangles.empty() && 2 * radius > ratio * (high - low);
}

glm::dvec3 turnedEye(const View& view, double turns) {
    const double angle = 2 * std::numbers::pi * turns, sine = std::sin(angle), cosine = std::cos(angle);
    const glm::dvec3 axis = glm::normalize(view.up), arm = view.eye - view.target;
    return view.target + cosine * arm + sine * glm::cross(axis, arm) + (1 - cosine) * glm::dot(axis, arm) * axis;
}

}  // namespace eikonal
