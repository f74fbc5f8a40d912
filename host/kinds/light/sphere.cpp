// A whole sphere that emits (kernels/light/sphere.clh).

#include "kinds/light_packing.h"

#include <algorithm>
#include <cmath>

namespace eikonal {

static light packElement(const AreaElement& e, const color& L) {
    const auto& sphere = std::get<Sphere>(e.description.kind);
    const glm::dmat4& m = e.sceneFromObject;
    light l = newLight(kind_sphere_light, L);
    const double radius = sphere.radius * uniformScale(m);
    l.p = toVec3(transformPoint(m, glm::dvec3(0)));
    l.radius = static_cast<float>(radius);
    l.inverse_area = static_cast<float>(1 / (4 * M_PI * radius * radius));
    l.n = {e.packed.flags & shape_reversed ? -1.0f : 1.0f, 0, 0};
    return l;
}

static void bound(const light& l, double, LightBounds& bounds) {
    const glm::dvec3 p = toGlm(l.p);
    bounds.box = {p - static_cast<double>(l.radius), p + static_cast<double>(l.radius)};
    boundAllDirections(bounds);
    bounds.intensity /= 4;
}

const LightTraits sphere_light{.packElement = packElement, .bound = bound};

}  // namespace eikonal
