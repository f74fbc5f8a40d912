// A cylinder that emits (kernels/light/cylinder.clh).

#include "kinds/light_packing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eikonal {

static light packElement(const AreaElement& e, const color& L) {
    const auto& cylinder = std::get<Cylinder>(e.description.kind);
    const glm::dmat4& m = e.sceneFromObject;
    light l = newLight(kind_cylinder_light, L);
    const glm::dvec3 a = transformVector(m, {cylinder.radius, 0, 0}), b = transformVector(m, {0, cylinder.radius, 0});
    const glm::dvec3 c = transformVector(m, {0, 0, cylinder.zMax - cylinder.zMin});
    l.p = toVec3(transformPoint(m, {0, 0, cylinder.zMin}));
    l.a = toVec3(a); l.b = toVec3(b); l.c = toVec3(c);
    l.extent = static_cast<float>(shareOfCircle(cylinder.phiMax));
    /* The area by quadrature: what the sampler's probability needs */
    double area = 0;
    constexpr int steps = 256;
    for (int i = 0; i < steps; ++i) {
        const double phi = 2 * M_PI * l.extent * (i + 0.5) / steps;
        area += glm::length(glm::cross(std::cos(phi) * b - std::sin(phi) * a, c)) * 2 * M_PI * l.extent / steps;
    }
    l.inverse_area = static_cast<float>(1 / area);
    /* dp/dphi x c points outwards, unless the transform mirrors it */
    l.n = sideOf(e);
    return l;
}

static void bound(const light& l, double, LightBounds& bounds) {
    const glm::dvec3 p = toGlm(l.p), x = toGlm(l.a), y = toGlm(l.b);
    const glm::dvec3 reach = glm::sqrt(x * x + y * y), end = p + toGlm(l.c);
    bounds.box = {glm::min(p, end) - reach, glm::max(p, end) + reach};
    boundAllDirections(bounds);
    bounds.intensity /= std::numbers::pi;
}

const LightTraits cylinder_light{.packElement = packElement, .bound = bound};

}  // namespace eikonal
