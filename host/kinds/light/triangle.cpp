// A triangle that emits (kernels/light/triangle.clh).

#include "kinds/light_packing.h"

#include <algorithm>
#include <cmath>

namespace eikonal {

static light packElement(const AreaElement& e, const color& L) {
    const uint* corner = &e.tables.indices[e.packed.first_index + 3 * e.element];
    const vec3* p = &e.tables.positions[e.packed.first_vertex];
    const glm::dvec3 a = toGlm(p[corner[0]]), b = toGlm(p[corner[1]]), c = toGlm(p[corner[2]]);
    const glm::dvec3 across = glm::cross(b - a, c - a);
    const double area = glm::length(across) / 2;
    light l = newLight(kind_triangle_light, L);
    l.p = toVec3(a); l.a = toVec3(b - a); l.b = toVec3(c - a);
    if (area > 0) {
        l.n = toVec3(emittingNormal(e, across / (2 * area), corner, 3));
        l.inverse_area = static_cast<float>(1 / area);
    } else l.pmf = 0;
    return l;
}

static void bound(const light& l, double, LightBounds& bounds) {
    const glm::dvec3 p = toGlm(l.p), x = toGlm(l.a), y = toGlm(l.b);
    bounds.box.grow(p + x);
    bounds.box.grow(p + y);
}

const LightTraits triangle_light{.packElement = packElement, .bound = bound};

}  // namespace eikonal
