// A disk that emits (kernels/light/disk.clh).

#include "kinds/light_packing.h"

#include <algorithm>
#include <cmath>

namespace eikonal {

static light packElement(const AreaElement& e, const color& L) {
    const auto& disk = std::get<Disk>(e.description.kind);
    const glm::dmat4& m = e.sceneFromObject;
    light l = newLight(kind_disk_light, L);
    const glm::dvec3 a = transformVector(m, {disk.radius, 0, 0}), b = transformVector(m, {0, disk.radius, 0});
    l.p = toVec3(transformPoint(m, {0, 0, disk.height}));
    l.a = toVec3(a); l.b = toVec3(b);
    const double hole = disk.innerRadius / disk.radius, extent = shareOfCircle(disk.phiMax);
    l.radius = static_cast<float>(hole);
    l.extent = static_cast<float>(extent);
    const double area = glm::length(glm::cross(a, b)) * M_PI * (1 - hole * hole) * extent;
    l.inverse_area = static_cast<float>(1 / area);
    l.n = toVec3(transformNormal(m, {0, 0, 1}) * (e.packed.flags & shape_reversed ? -1.0 : 1.0));
    return l;
}

static void bound(const light& l, double, LightBounds& bounds) {
    const glm::dvec3 p = toGlm(l.p), x = toGlm(l.a), y = toGlm(l.b);
    const glm::dvec3 reach = glm::sqrt(x * x + y * y);
    bounds.box = {p - reach, p + reach};
}

const LightTraits disk_light{.packElement = packElement, .bound = bound};

}  // namespace eikonal
