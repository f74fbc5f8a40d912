// A part of a sphere, or of an ellipsoid, that emits (kernels/light/ellipsoid.clh).

#include "kinds/light_packing.h"

#include <algorithm>
#include <cmath>

namespace eikonal {

static light packElement(const AreaElement& e, const color& L) {
    const auto& sphere = std::get<Sphere>(e.description.kind);
    const glm::dmat4& m = e.sceneFromObject;
    light l = newLight(kind_ellipsoid_light, L);
    const glm::dvec3 a = transformVector(m, {sphere.radius, 0, 0}), b = transformVector(m, {0, sphere.radius, 0}), c = transformVector(m, {0, 0, sphere.radius});
    l.p = toVec3(transformPoint(m, glm::dvec3(0)));
    l.a = toVec3(a); l.b = toVec3(b); l.c = toVec3(c);
    l.extent = static_cast<float>(shareOfCircle(sphere.phiMax));
    const double low = std::clamp(sphere.zMin / sphere.radius, -1.0, 1.0), high = std::clamp(sphere.zMax / sphere.radius, -1.0, 1.0);
    l.cos_inner = static_cast<float>(low);
    l.cos_outer = static_cast<float>(high);
    /* The area by quadrature: what the sampler's probability needs */
    double area = 0;
    constexpr int steps = 64;
    for (int i = 0; i < steps * steps; ++i) {
        const double phi = 2 * M_PI * l.extent * (i % steps + 0.5) / steps, z = low + (high - low) * (i / steps + 0.5) / steps, r = std::sqrt(1 - z * z);
        const glm::dvec3 across = r * std::cos(phi) * glm::cross(b, c) + r * std::sin(phi) * glm::cross(c, a) + z * glm::cross(a, b);
        area += glm::length(across) * 2 * M_PI * l.extent * (high - low) / (steps * steps);
    }
    l.inverse_area = static_cast<float>(1 / area);
    l.n = sideOf(e);
    return l;
}

static void bound(const light& l, double, LightBounds& bounds) {
    const glm::dvec3 p = toGlm(l.p), x = toGlm(l.a), y = toGlm(l.b);
    const glm::dvec3 c = toGlm(l.c), reach = glm::sqrt(x * x + y * y + c * c);
    bounds.box = {p - reach, p + reach};
    boundAllDirections(bounds);
}

const LightTraits ellipsoid_light{.packElement = packElement, .bound = bound};

}  // namespace eikonal
