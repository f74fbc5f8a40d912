#include "pack/light_tree.h"

#include "kinds/light_kind.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace eikonal {

using std::numbers::pi;

static glm::dvec3 toGlm(vec3 v) { return {v.x, v.y, v.z}; }
double angleBetween(glm::dvec3 a, glm::dvec3 b) { return std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0)); }

LightBounds boundsOfLight(const light& l, double power) {
    const LightTraits& traits = kindOf(l).traits;
    if (!traits.bound) throw std::logic_error("this kind of light has no bounds");
    LightBounds bounds;
    bounds.box.grow(toGlm(l.p));
    bounds.axis = toGlm(l.n);
    bounds.emission = pi / 2;
    bounds.twoSided = l.two_sided != 0;
    bounds.intensity = power / (bounds.twoSided ? 2 * pi : pi);
    traits.bound(l, power, bounds);
    return bounds;
}

/// Rotates a unit vector by an angle towards another one.
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
    /* The cone that bounds both; a two-sided light may be flipped */
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
