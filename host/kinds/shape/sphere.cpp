// Sphere or part of one, which may emit (kernels/shape/sphere.clh, kernels/light/sphere.clh, kernels/light/ellipsoid.clh).

#include "kinds/shape_packing.h"
#include "kinds/shape_reading.h"

#include <algorithm>
#include <cmath>

namespace eikonal {

static bool read(const pbrt::ShapeReading& in, pbrt::PendingShape& pending) {
    Shape& s = pending.shape;
    s.radius = std::abs(in.arguments.number("radius"));
    const double z0 = in.arguments.number("zmin", -s.radius), z1 = in.arguments.number("zmax", s.radius);
    s.zMin = std::clamp(std::min(z0, z1), -s.radius, s.radius);
    s.zMax = std::clamp(std::max(z0, z1), -s.radius, s.radius);
    s.phiMax = in.arguments.number("phimax");
    return keepIf(s.radius > 0 && s.zMin < s.zMax && s.phiMax > 0, in);
}

static Box bound(const Shape& s, const glm::dmat4& m) {
    return transformed({{-s.radius, -s.radius, std::max(-s.radius, s.zMin)}, {s.radius, s.radius, std::min(s.radius, s.zMax)}}, m);
}

static size_t pack(const ShapePacking& in) {
    const Shape& s = in.description;
    object_space q = newRound(in);
    const double unit = unitOfRound(in);
    q.z_min = static_cast<float>(std::clamp(std::min(s.zMin, s.zMax), -s.radius, s.radius) / unit);
    q.z_max = static_cast<float>(std::clamp(std::max(s.zMin, s.zMax), -s.radius, s.radius) / unit);
    return addRound(in, q, 3);
}

/// A full sphere that is not stretched is sampled by the cone that it subtends; any other as an ellipsoid.
static light_kind lightKindOf(const Shape& s, const glm::dmat4& m) {
    const bool isWhole = s.zMin <= -s.radius && s.zMax >= s.radius && s.phiMax >= 360;
    return isWhole && uniformScale(m) != 0 ? kind_sphere_light : kind_ellipsoid_light;
}

static light packLight(const AreaElement& e, const color& L) {
    const Shape& sphere = e.description;
    const glm::dmat4& m = e.sceneFromObject;
    light l = newLight(kind_sphere_light, L);
    const double radius = sphere.radius * uniformScale(m);
    l.p = toVec3(transformPoint(m, glm::dvec3(0)));
    l.radius = static_cast<float>(radius);
    l.inverse_area = static_cast<float>(1 / (4 * M_PI * radius * radius));
    l.n = {e.packed.flags & shape_reversed ? -1.0f : 1.0f, 0, 0};
    return l;
}

const LightTraits sphere_light{.packElement = packLight, .bound = boundSphere};

/* Partial sphere or ellipsoid */

static light packLightOfPart(const AreaElement& e, const color& L) {
    const Shape& sphere = e.description;
    const glm::dmat4& m = e.sceneFromObject;
    light l = newLight(kind_ellipsoid_light, L);
    const glm::dvec3 a = transformVector(m, {sphere.radius, 0, 0}), b = transformVector(m, {0, sphere.radius, 0}),
                     c = transformVector(m, {0, 0, sphere.radius});
    l.p = toVec3(transformPoint(m, glm::dvec3(0)));
    l.a = toVec3(a); l.b = toVec3(b); l.c = toVec3(c);
    l.extent = static_cast<float>(shareOfCircle(sphere.phiMax));
    const double low = std::clamp(sphere.zMin / sphere.radius, -1.0, 1.0), high = std::clamp(sphere.zMax / sphere.radius, -1.0, 1.0);
    l.cos_inner = static_cast<float>(low);
    l.cos_outer = static_cast<float>(high);
    /* Integrate the area numerically; the light sampler's probability needs it */
    double area = 0;
    constexpr int steps = 64;
    for (int i = 0; i < steps * steps; ++i) {
        const double phi = 2 * M_PI * l.extent * (i % steps + 0.5) / steps, z = low + (high - low) * (i / steps + 0.5) / steps,
                     r = std::sqrt(1 - z * z);
        const glm::dvec3 across = r * std::cos(phi) * glm::cross(b, c) + r * std::sin(phi) * glm::cross(c, a) + z * glm::cross(a, b);
        area += glm::length(across) * 2 * M_PI * l.extent * (high - low) / (steps * steps);
    }
    l.inverse_area = static_cast<float>(1 / area);
    l.n = sideOf(e);
    return l;
}

static void boundLightOfPart(const light& l, double, LightBounds& bounds) {
    const glm::dvec3 p = toGlm(l.p), x = toGlm(l.a), y = toGlm(l.b);
    const glm::dvec3 c = toGlm(l.c), reach = glm::sqrt(x * x + y * y + c * c);
    bounds.box = {p - reach, p + reach};
    boundAllDirections(bounds);
}

const LightTraits ellipsoid_light{.packElement = packLightOfPart, .bound = boundLightOfPart};

static const ShapeDirective directives[] = {
    {"sphere", "float radius = 1; float zmin; float zmax; float phimax = 360 clamped to [0, 360]", read},
};

const ShapeTraits sphere_shape{.directives = directives, .bound = bound, .pack = pack, .lightKindOf = lightKindOf};

}  // namespace eikonal
