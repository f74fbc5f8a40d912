// Cylinder, which may emit (kernels/shape/cylinder.clh, kernels/light/cylinder.clh).

#include "kinds/shape_packing.h"
#include "kinds/shape_reading.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eikonal {

static bool read(const pbrt::ShapeReading& in, pbrt::PendingShape& pending) {
    Shape& s = pending.shape;
    const double z0 = in.arguments.number("zmin"), z1 = in.arguments.number("zmax");
    s.radius = std::abs(in.arguments.number("radius"));
    s.zMin = std::min(z0, z1);
    s.zMax = std::max(z0, z1);
    s.phiMax = in.arguments.number("phimax");
    return keepIf(s.radius > 0 && s.zMin < s.zMax && s.phiMax > 0, in);
}

/// Bounds both end circles. Along each axis a circle extends by the norm of its two radius vectors' components.
static Box bound(const Shape& s, const glm::dmat4& m) {
    const glm::dvec3 reach = s.radius * glm::sqrt(glm::dvec3(m[0] * m[0] + m[1] * m[1]));
    Box box;
    for (const double z : {s.zMin, s.zMax})
        for (const double side : {-1.0, 1.0}) box.grow(transformPoint(m, {0, 0, z}) + side * reach);
    return box;
}

static size_t pack(const ShapePacking& in) {
    object_space q = newRound(in);
    const double unit = unitOfRound(in);
    q.z_min = static_cast<float>(in.description.zMin / unit);
    q.z_max = static_cast<float>(in.description.zMax / unit);
    return addRound(in, q, 2);
}

static light_kind lightKindOf(const Shape&, const glm::dmat4&) { return kind_cylinder_light; }

static light packLight(const AreaElement& e, const color& L) {
    const Shape& cylinder = e.description;
    const glm::dmat4& m = e.sceneFromObject;
    light l = newLight(kind_cylinder_light, L);
    const glm::dvec3 a = transformVector(m, {cylinder.radius, 0, 0}), b = transformVector(m, {0, cylinder.radius, 0});
    const glm::dvec3 c = transformVector(m, {0, 0, cylinder.zMax - cylinder.zMin});
    l.p = toVec3(transformPoint(m, {0, 0, cylinder.zMin}));
    l.a = toVec3(a); l.b = toVec3(b); l.c = toVec3(c);
    l.extent = static_cast<float>(shareOfCircle(cylinder.phiMax));
    /* Integrate the area numerically; the light sampler's probability needs it */
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

static void boundLight(const light& l, double, LightBounds& bounds) {
    const glm::dvec3 p = toGlm(l.p), x = toGlm(l.a), y = toGlm(l.b);
    const glm::dvec3 reach = glm::sqrt(x * x + y * y), end = p + toGlm(l.c);
    bounds.box = {glm::min(p, end) - reach, glm::max(p, end) + reach};
    boundAllDirections(bounds);
    bounds.intensity /= std::numbers::pi;
}

const LightTraits cylinder_light{.packElement = packLight, .bound = boundLight};

static const ShapeDirective directives[] = {
    {"cylinder", "float radius = 1; float zmin = -1; float zmax = 1; float phimax = 360 clamped to [0, 360]", read},
};

const ShapeTraits cylinder_shape{.directives = directives, .bound = bound, .pack = pack, .lightKindOf = lightKindOf};

}  // namespace eikonal
