// Lights with a shape: one for each element of a shape that emits.

#include "overloaded.h"
#include "pack/image_lights.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace eikonal {

static glm::dvec3 toGlm(vec3 v) { return {v.x, v.y, v.z}; }

/// The normal on whose side a flat element emits: its geometric one, on the side of its vertex normals if it has any.
static glm::dvec3 emittingNormal(const SceneTables& tables, const shape& s, glm::dvec3 n, const uint* corners, int count) {
    if (s.first_normal == NONE) return s.flags & shape_reversed ? -n : n;
    glm::dvec3 sum(0);
    for (int i = 0; i < count; ++i) sum += toGlm(tables.normals[s.first_normal + corners[i]]);
    return glm::dot(sum, n) < 0 ? -n : n;
}

static light triangleLight(const SceneTables& tables, const shape& s, size_t element, const color& L) {
    const uint* corner = &tables.indices[s.first_index + 3 * element];
    const vec3* p = &tables.positions[s.first_vertex];
    const glm::dvec3 a = toGlm(p[corner[0]]), b = toGlm(p[corner[1]]), c = toGlm(p[corner[2]]);
    const glm::dvec3 across = glm::cross(b - a, c - a);
    const double area = glm::length(across) / 2;
    light l = newLight(kind_triangle_light, L);
    l.p = toVec3(a); l.a = toVec3(b - a); l.b = toVec3(c - a);
    if (area > 0) {
        l.n = toVec3(emittingNormal(tables, s, across / (2 * area), corner, 3));
        l.inverse_area = static_cast<float>(1 / area);
    } else l.pmf = 0;
    return l;
}

static light bilinearLight(const SceneTables& tables, const shape& s, size_t element, const color& L) {
    const uint* corner = &tables.indices[s.first_index + 4 * element];
    const vec3* p = &tables.positions[s.first_vertex];
    const glm::dvec3 p00 = toGlm(p[corner[0]]), p10 = toGlm(p[corner[1]]), p01 = toGlm(p[corner[2]]), p11 = toGlm(p[corner[3]]);
    light l = newLight(kind_bilinear_light, L);
    l.p = toVec3(p00); l.a = toVec3(p10 - p00); l.b = toVec3(p01 - p00); l.c = toVec3(p11 - p10 - p01 + p00);
    glm::dvec3 n = glm::cross(p10 + p11 - p00 - p01, p01 + p11 - p00 - p10);
    /* The area by quadrature: what the sampler's probability needs */
    double area = 0;
    constexpr int steps = 16;
    for (int i = 0; i < steps * steps; ++i) {
        const double u = (i % steps + 0.5) / steps, v = (i / steps + 0.5) / steps;
        area += glm::length(glm::cross(toGlm(l.a) + v * toGlm(l.c), toGlm(l.b) + u * toGlm(l.c))) / (steps * steps);
    }
    if (area > 0) {
        n = glm::normalize(n);
        l.n = toVec3(emittingNormal(tables, s, n, corner, 4));
        l.inverse_area = static_cast<float>(1 / area);
    } else l.pmf = 0;
    return l;
}

/// Of a whole turn; phiMax in degrees.
static double shareOfTurn(double phiMax) { return std::clamp(phiMax, 0.0, 360.0) / 360; }
/// In x, on which side a round light emits: 1 where the product of its tangents points outwards in the scene as it does in its own space.
static vec3 sideOf(const shape& s, const glm::dmat4& m) { return {((s.flags & shape_reversed) != 0) != swapsHandedness(m) ? -1.0f : 1.0f, 0, 0}; }

static bool isWhole(const Sphere& sphere) { return sphere.zMin <= -sphere.radius && sphere.zMax >= sphere.radius && sphere.phiMax >= 360; }
/// Whole, and still a sphere in the scene: from outside it is sampled by the cone that it fills.
static bool isSeenAsASphere(const Sphere& sphere, const glm::dmat4& m) { return isWhole(sphere) && uniformScale(m) != 0; }

static light sphereLight(const shape& s, const Sphere& sphere, const glm::dmat4& m, const color& L) {
    light l = newLight(kind_sphere_light, L);
    const double radius = sphere.radius * uniformScale(m);
    l.p = toVec3(transformPoint(m, glm::dvec3(0)));
    l.radius = static_cast<float>(radius);
    l.inverse_area = static_cast<float>(1 / (4 * M_PI * radius * radius));
    l.n = {s.flags & shape_reversed ? -1.0f : 1.0f, 0, 0};
    return l;
}

static light ellipsoidLight(const shape& s, const Sphere& sphere, const glm::dmat4& m, const color& L) {
    light l = newLight(kind_ellipsoid_light, L);
    const glm::dvec3 a = transformVector(m, {sphere.radius, 0, 0}), b = transformVector(m, {0, sphere.radius, 0}), c = transformVector(m, {0, 0, sphere.radius});
    l.p = toVec3(transformPoint(m, glm::dvec3(0)));
    l.a = toVec3(a); l.b = toVec3(b); l.c = toVec3(c);
    l.extent = static_cast<float>(shareOfTurn(sphere.phiMax));
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
    l.n = sideOf(s, m);
    return l;
}

static light diskLight(const shape& s, const Disk& disk, const glm::dmat4& m, const color& L) {
    light l = newLight(kind_disk_light, L);
    const glm::dvec3 a = transformVector(m, {disk.radius, 0, 0}), b = transformVector(m, {0, disk.radius, 0});
    l.p = toVec3(transformPoint(m, {0, 0, disk.height}));
    l.a = toVec3(a); l.b = toVec3(b);
    const double hole = disk.innerRadius / disk.radius, extent = shareOfTurn(disk.phiMax);
    l.radius = static_cast<float>(hole);
    l.extent = static_cast<float>(extent);
    const double area = glm::length(glm::cross(a, b)) * M_PI * (1 - hole * hole) * extent;
    l.inverse_area = static_cast<float>(1 / area);
    l.n = toVec3(transformNormal(m, {0, 0, 1}) * (s.flags & shape_reversed ? -1.0 : 1.0));
    return l;
}

static light cylinderLight(const shape& s, const Cylinder& cylinder, const glm::dmat4& m, const color& L) {
    light l = newLight(kind_cylinder_light, L);
    const glm::dvec3 a = transformVector(m, {cylinder.radius, 0, 0}), b = transformVector(m, {0, cylinder.radius, 0});
    const glm::dvec3 c = transformVector(m, {0, 0, cylinder.zMax - cylinder.zMin});
    l.p = toVec3(transformPoint(m, {0, 0, cylinder.zMin}));
    l.a = toVec3(a); l.b = toVec3(b); l.c = toVec3(c);
    l.extent = static_cast<float>(shareOfTurn(cylinder.phiMax));
    /* The area by quadrature: what the sampler's probability needs */
    double area = 0;
    constexpr int steps = 256;
    for (int i = 0; i < steps; ++i) {
        const double phi = 2 * M_PI * l.extent * (i + 0.5) / steps;
        area += glm::length(glm::cross(std::cos(phi) * b - std::sin(phi) * a, c)) * 2 * M_PI * l.extent / steps;
    }
    l.inverse_area = static_cast<float>(1 / area);
    /* dp/dphi x c points outwards, unless the transform mirrors it */
    l.n = sideOf(s, m);
    return l;
}

/// Emitted power in scene units: what the sampler's probabilities follow.
static double areaPower(const light& l, double luminance) { return l.pmf > 0 ? M_PI * luminance / l.inverse_area * (l.two_sided ? 2 : 1) : 0; }

void packAreaLight(Packer& packer, const Shape& s, shape& packed, const glm::dmat4& m, size_t elements) {
    const AreaLight& description = packer.scene.areaLights[static_cast<size_t>(s.areaLight)];
    Table<light>& lights = packer.packed.tables.lights;
    packed.first_light = static_cast<uint>(lights.size());
    const bool isUnseen = s.alpha.texture == none && s.alpha.value.value() <= 0;
    if (isUnseen) packed.flags |= shape_is_unseen;
    if (description.image != none) packed.emission = packEmissionImage(packer, description);
    const bool hasPattern = packed.emission != NONE || (packed.alpha != NONE && !isUnseen);
    const double scale = description.scale * (description.image != none ? meanLuminance(packer, description.image) : 1);
    const color L = packEmission(packer, description.L, scale);
    const SceneTables& tables = packer.packed.tables;
    for (size_t e = 0; e < elements; ++e) {
        light l = std::visit(Overloaded{
            [&](const TriangleMesh&) { return triangleLight(tables, packed, e, L); },
            [&](const BilinearMesh&) { return bilinearLight(tables, packed, e, L); },
            [&](const Sphere& q) { return isSeenAsASphere(q, m) ? sphereLight(packed, q, m, L) : ellipsoidLight(packed, q, m, L); },
            [&](const Disk& q) { return diskLight(packed, q, m, L); },
            [&](const Cylinder& q) { return cylinderLight(packed, q, m, L); },
            [&](const CurveShape&) -> light { throw std::logic_error("curves do not emit"); },
            [&](const ImplicitSurface&) -> light { throw std::logic_error("implicit surfaces do not emit"); }}, s.kind);
        l.two_sided = description.twoSided ? 1 : 0;
        /* Cut out altogether, it shines unseen (as in pbrt-v4) */
        l.invisible = isUnseen;
        if (hasPattern) l.element = packed.first_element + static_cast<uint>(e);
        /* A power in watts is that of the whole shape without its holes, through each of its elements alike (pbrt-v4) */
        double factor = scale;
        if (description.power && l.inverse_area > 0) {
            const double area = 1 / (l.inverse_area * packer.space.scale * packer.space.scale);
            factor = description.scale * *description.power / (M_PI * area * (description.twoSided ? 2 : 1));
            l.L = packEmission(packer, description.L, factor);
        }
        packer.areaPowers.push_back(areaPower(l, luminanceOf(description.L, factor)));
        lights.push_back(l);
    }
    const std::string why = description.where.toString() + ": area light";
    packer.packed.require(Feature::EMITTERS, why);
    if (hasPattern) packer.packed.require(Feature::LIGHT_PATTERN, why);
    packer.packed.require(std::visit(Overloaded{
        [](const TriangleMesh&) { return Feature::LIGHT_TRIANGLE; }, [](const BilinearMesh&) { return Feature::LIGHT_BILINEAR; },
        [&](const Sphere& q) { return isSeenAsASphere(q, m) ? Feature::LIGHT_SPHERE : Feature::LIGHT_ELLIPSOID; }, [](const Disk&) { return Feature::LIGHT_DISK; },
        [](const Cylinder&) { return Feature::LIGHT_CYLINDER; },
        [](const CurveShape&) -> Feature { throw std::logic_error("curves do not emit"); },
        [](const ImplicitSurface&) -> Feature { throw std::logic_error("implicit surfaces do not emit"); }}, s.kind), why);
}

}  // namespace eikonal
