// Disk, which may emit (kernels/shape/disk.clh, kernels/light/disk.clh).

#include "kinds/shape_packing.h"
#include "kinds/shape_reading.h"

#include <algorithm>
#include <cmath>

namespace eikonal {

static bool read(const pbrt::ShapeReading& in, pbrt::PendingShape& pending) {
    Shape& s = pending.shape;
    s.radius = std::abs(in.arguments.number("radius"));
    s.innerRadius = std::abs(in.arguments.number("innerradius"));
    s.height = in.arguments.number("height");
    s.phiMax = in.arguments.number("phimax");
    return keepIf(s.innerRadius < s.radius && s.phiMax > 0, in);
}

static Box bound(const Shape& s, const glm::dmat4& m) {
    return transformed({{-s.radius, -s.radius, s.height}, {s.radius, s.radius, s.height}}, m);
}

static size_t pack(const ShapePacking& in) {
    object_space q = newRound(in);
    q.inner_radius = static_cast<float>(in.description.innerRadius / unitOfRound(in));
    return addRound(in, q, 0);
}

static light_kind lightKindOf(const Shape&, const glm::dmat4&) { return kind_disk_light; }

static light packLight(const AreaElement& e, const color& L) {
    const Shape& disk = e.description;
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

static void boundLight(const light& l, double, LightBounds& bounds) {
    const glm::dvec3 p = toGlm(l.p), x = toGlm(l.a), y = toGlm(l.b);
    const glm::dvec3 reach = glm::sqrt(x * x + y * y);
    bounds.box = {p - reach, p + reach};
}

const LightTraits disk_light{.packElement = packLight, .bound = boundLight};

static const ShapeDirective directives[] = {
    {"disk", "float radius = 1; float innerradius = 0; float height = 0; float phimax = 360 clamped to [0, 360]", read},
};

const ShapeTraits disk_shape{.directives = directives, .bound = bound, .pack = pack, .lightKindOf = lightKindOf};

}  // namespace eikonal
