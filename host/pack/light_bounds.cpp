#include "pack/light_tree.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace eikonal {

using std::numbers::pi;

static glm::dvec3 toGlm(vec3 v) { return {v.x, v.y, v.z}; }
static double angleBetween(glm::dvec3 a, glm::dvec3 b) { return std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0)); }

/// A light that does not fade towards its edge still needs some room there, since the tree takes what it bounds by cosines.
constexpr double leastEmission = 0.05, mostFallOff = 1.4;

LightBounds boundsOfLight(const light& l, double power) {
    LightBounds b;
    const glm::dvec3 p = toGlm(l.p), x = toGlm(l.a), y = toGlm(l.b);
    b.box.grow(p);
    b.axis = toGlm(l.n);
    b.emission = pi / 2;
    b.twoSided = l.two_sided != 0;
    b.intensity = power / (b.twoSided ? 2 * pi : pi);
    const auto shinesEverywhere = [&] { b.axis = {0, 0, 1}; b.normals = pi; };
    switch (l.kind) {
        case kind_triangle_light:
            b.box.grow(p + x);
            b.box.grow(p + y);
            break;
        case kind_bilinear_light: {
            /* Normals are linear in u and in v, so those at the corners bound them; on which side it shines is as in sample_bilinear_light */
            const glm::dvec3 c = toGlm(l.c);
            for (int i = 0; i < 4; ++i) {
                const double u = i & 1, v = i >> 1;
                b.box.grow(p + u * x + v * y + u * v * c);
                const glm::dvec3 n = glm::cross(x + v * c, y + u * c);
                const double length = glm::length(n);
                if (length > 0) b.normals = std::max(b.normals, angleBetween(n / length * (glm::dot(n, b.axis) < 0 ? -1.0 : 1.0), b.axis));
            }
            if (b.normals > pi / 4) shinesEverywhere();
            break;
        }
        case kind_sphere_light:
            b.box = {p - static_cast<double>(l.radius), p + static_cast<double>(l.radius)};
            shinesEverywhere();
            b.intensity /= 4;
            break;
        case kind_ellipsoid_light: {
            const glm::dvec3 c = toGlm(l.c), reach = glm::sqrt(x * x + y * y + c * c);
            b.box = {p - reach, p + reach};
            shinesEverywhere();
            break;
        }
        case kind_disk_light: {
            const glm::dvec3 reach = glm::sqrt(x * x + y * y);
            b.box = {p - reach, p + reach};
            break;
        }
        case kind_cylinder_light: {
            const glm::dvec3 reach = glm::sqrt(x * x + y * y), end = p + toGlm(l.c);
            b.box = {glm::min(p, end) - reach, glm::max(p, end) + reach};
            shinesEverywhere();
            b.intensity /= pi;
            break;
        }
        case kind_spot_light: {
            const double inner = std::acos(std::clamp<double>(l.cos_inner, -1, 1)), outer = std::acos(std::clamp<double>(l.cos_outer, -1, 1));
            b.emission = std::clamp(outer - inner, leastEmission, mostFallOff);
            b.normals = std::max(inner, outer - b.emission);
            b.intensity = power / (2 * pi * (1 - (l.cos_inner + l.cos_outer) / 2));
            break;
        }
        case kind_projection_light: {
            const double corner = std::atan(std::sqrt(1 / glm::dot(x, x) + 1 / glm::dot(y, y)));
            b.normals = corner;
            b.emission = leastEmission;
            b.intensity = power / (2 * pi * (1 - std::cos(corner)));
            break;
        }
        case kind_point_light:
        case kind_goniometric_light:
            shinesEverywhere();
            b.intensity = power / (4 * pi);
            break;
        default: throw std::logic_error("nothing bounds lights of this kind");
    }
    return b;
}

/// Turns a unit vector by an angle towards another one.
static glm::dvec3 turnTowards(glm::dvec3 a, glm::dvec3 b, double angle) {
    glm::dvec3 across = b - glm::dot(a, b) * a;
    if (glm::length(across) < 1e-9) across = glm::cross(a, std::abs(a.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
    return glm::normalize(std::cos(angle) * a + std::sin(angle) * glm::normalize(across));
}

LightBounds unite(const LightBounds& a, const LightBounds& b) {
    if (!(a.intensity > 0)) return b;
    if (!(b.intensity > 0)) return a;
    LightBounds both = a.normals >= b.normals ? a : b;
    const LightBounds& other = a.normals >= b.normals ? b : a;
    both.box.grow(other.box);
    both.intensity += other.intensity;
    both.emission = std::max(a.emission, b.emission);
    both.twoSided = a.twoSided || b.twoSided;
    /* The cone that holds both; what shines on both sides may as well be turned round */
    const glm::dvec3 otherAxis = a.twoSided && b.twoSided && glm::dot(a.axis, b.axis) < 0 ? -other.axis : other.axis;
    const double apart = angleBetween(both.axis, otherAxis);
    if (std::min(apart + other.normals, pi) <= both.normals) return both;
    const double half = (both.normals + apart + other.normals) / 2;
    if (half >= pi) { both.normals = pi; return both; }
    both.axis = turnTowards(both.axis, otherAxis, half - both.normals);
    both.normals = half;
    return both;
}

}  // namespace eikonal
