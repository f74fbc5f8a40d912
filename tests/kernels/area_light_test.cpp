// Every light that is a surface: samples follow their density over solid angle, and lie on it.

#include "light_sampling.h"
#include "pack/space.h"
#include "random_inputs.h"
#include "statistics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

namespace eikonal {
namespace {

/// A light with an area as a surface over the unit square, in double precision.
using Surface = std::function<glm::dvec3(double, double)>;

struct AreaCase { std::string name; light l; Surface surface; glm::dvec3 outward; std::vector<vec3> points; };
void PrintTo(const AreaCase& c, std::ostream* out) { *out << c.name; }

AreaCase triangleCase(bool twoSided) {
    light l = newLight(kind_triangle_light);
    l.p = {0.1f, -0.2f, 0.3f}; l.a = {1, 0.2f, 0}; l.b = {0.1f, 0.9f, 0.3f};
    const glm::dvec3 across = glm::cross(toGlm(l.a), toGlm(l.b));
    l.n = toVec3(glm::normalize(across));
    l.inverse_area = static_cast<float>(2 / glm::length(across));
    l.two_sided = twoSided;
    const auto surface = [l](double s, double t) { return toGlm(l.p) + s * (1 - t) * toGlm(l.a) + s * t * toGlm(l.b); };
    return {twoSided ? "triangle_two_sided" : "triangle", l, surface, toGlm(l.n), {{0.4f, 0.2f, 0.9f}, {2, 2, 2}, {0.2f, 0.1f, -3}}};
}

AreaCase bilinearCase(bool flat) {
    light l = newLight(kind_bilinear_light);
    l.p = {-0.5f, -0.5f, 0}; l.a = {1, 0, 0}; l.b = {0.1f, 1.2f, 0}; l.c = flat ? vec3{0.3f, -0.2f, 0} : vec3{0.1f, 0.1f, 0.5f};
    const auto surface = [l](double u, double v) { return toGlm(l.p) + u * toGlm(l.a) + v * toGlm(l.b) + u * v * toGlm(l.c); };
    glm::dvec3 n = glm::normalize(glm::cross(toGlm(l.a) + 0.5 * toGlm(l.c), toGlm(l.b) + 0.5 * toGlm(l.c)));
    l.n = toVec3(n);
    return {flat ? "bilinear_flat" : "bilinear_curved", l, surface, n, {{0, 0, 1.5f}, {1.5f, -1, 2}, {0, 0.3f, 20}}};
}

AreaCase sphereCase(bool inwards) {
    light l = newLight(kind_sphere_light);
    l.p = {0.2f, 0.1f, -0.3f};
    l.radius = 0.7f;
    l.inverse_area = static_cast<float>(1 / (4 * M_PI * 0.49));
    l.n = {inwards ? -1.0f : 1.0f, 0, 0};
    const auto surface = [](double u, double v) {
        const double z = std::cos(M_PI * u), r = std::sin(M_PI * u), phi = 2 * M_PI * v;
        return glm::dvec3(0.2f, 0.1f, -0.3f) + 0.7 * glm::dvec3(r * std::cos(phi), r * std::sin(phi), z);
    };
    const std::vector<vec3> inside{{0.2f, 0.1f, -0.3f}, {0.5f, 0.2f, -0.1f}}, outside{{0.2f, 0.1f, 0.5f}, {1, 1, 1}, {-30, 5, 2}};
    return {inwards ? "sphere_from_inside" : "sphere", l, surface, glm::dvec3(0), inwards ? inside : outside};
}

AreaCase diskCase(bool part) {
    light l = newLight(kind_disk_light);
    l.p = {0, 0.1f, 0.2f}; l.a = {0.8f, 0, 0.1f}; l.b = {0, 0.5f, 0};
    l.radius = part ? 0.4f : 0.0f;
    l.extent = part ? 0.6f : 1.0f;
    const double hole = l.radius, extent = l.extent;
    l.inverse_area = static_cast<float>(1 / (glm::length(glm::cross(toGlm(l.a), toGlm(l.b))) * M_PI * (1 - hole * hole) * extent));
    l.n = toVec3(glm::normalize(glm::cross(toGlm(l.a), toGlm(l.b))));
    const auto surface = [l, hole, extent](double u, double v) {
        const double r = hole + (1 - hole) * u, phi = 2 * M_PI * v * extent;
        return toGlm(l.p) + r * std::cos(phi) * toGlm(l.a) + r * std::sin(phi) * toGlm(l.b);
    };
    return {part ? "disk_part" : "disk", l, surface, toGlm(l.n), {{0.1f, 0, 1}, {1, -1, 0.7f}, {0, 0, 30}}};
}

/// Elliptic, of a part of the circle or all of it; from inside and outside.
AreaCase cylinderCase(bool part) {
    light l = newLight(kind_cylinder_light);
    l.p = {0, 0.1f, 0.2f}; l.a = {0.8f, 0, 0.1f}; l.b = {0, 0.5f, 0.1f}; l.c = {0.1f, 0.2f, 1.1f};
    l.extent = part ? 0.6f : 1.0f;
    l.n = {part ? -1.0f : 1.0f, 0, 0};
    const double extent = l.extent;
    const auto surface = [l, extent](double u, double v) {
        const double phi = 2 * M_PI * u * extent;
        return toGlm(l.p) + std::cos(phi) * toGlm(l.a) + std::sin(phi) * toGlm(l.b) + v * toGlm(l.c);
    };
    return {part ? "cylinder_part_inwards" : "cylinder", l, surface, glm::dvec3(0), {{0.05f, 0.2f, 0.8f}, {1.5f, -1, 0.7f}, {0, 20, 30}}};
}

/// An ellipsoid, or a part of a mirrored one that shines inwards.
AreaCase ellipsoidCase(bool part) {
    light l = newLight(kind_ellipsoid_light);
    l.p = {0, 0.1f, 0.2f}; l.a = {0.8f, 0, 0.1f}; l.b = {0, part ? -0.5f : 0.5f, 0.1f}; l.c = {0.1f, 0.2f, 1.1f};
    l.extent = part ? 0.6f : 1.0f;
    l.cos_inner = part ? -0.4f : -1.0f;
    l.cos_outer = part ? 0.8f : 1.0f;
    l.n = {part ? -1.0f : 1.0f, 0, 0};
    const double low = l.cos_inner, high = l.cos_outer, extent = l.extent;
    const auto surface = [=](double u, double v) {
        const double phi = 2 * M_PI * u * extent, z = low + v * (high - low), r = std::sqrt(std::max(1 - z * z, 0.));
        return toGlm(l.p) + r * std::cos(phi) * toGlm(l.a) + r * std::sin(phi) * toGlm(l.b) + z * toGlm(l.c);
    };
    return {part ? "ellipsoid_part_inwards" : "ellipsoid",
            l,
            surface,
            glm::dvec3(0),
            {{0.05f, 0.2f, part ? 0.3f : 1.8f}, {1.5f, -1, 0.7f}, {0, 20, 30}}};
}

class AreaLights : public testing::TestWithParam<AreaCase> {};

/// Functions of direction whose integrals over the light, as seen from a point, are compared: 1 (its solid angle) and some of the
/// first and second moments.
constexpr size_t momentCount = 6;
std::array<double, momentCount> moments(glm::dvec3 w) { return {1, w.x, w.y, w.z, w.x * w.y, w.z * w.z}; }

/// The integrals, by the midpoint rule over the surface: dw = |cos| / d^2 dA.
std::array<double, momentCount> integrate(const AreaCase& c, glm::dvec3 p) {
    constexpr int steps = 600;
    constexpr double h = 1e-6;   /* for derivatives */
    std::array<double, momentCount> sum{};
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const double u = (i + 0.5) / steps, v = (j + 0.5) / steps;
            const glm::dvec3 q = c.surface(u, v), du = (c.surface(u + h, v) - c.surface(u - h, v)) / (2 * h),
                             dv = (c.surface(u, v + h) - c.surface(u, v - h)) / (2 * h);
            glm::dvec3 area = glm::cross(du, dv);
            const bool isRound = c.l.kind == kind_cylinder_light || c.l.kind == kind_ellipsoid_light;
            if (isRound) area *= c.l.n.x;
            const glm::dvec3 side = isRound                         ? area
                                    : c.l.kind == kind_sphere_light ? (q - toGlm(c.l.p)) * static_cast<double>(c.l.n.x)
                                                                    : c.outward;
            if (glm::dot(area, side) < 0) area = -area;
            const glm::dvec3 to = q - p;
            const double distance = glm::length(to), facing = -glm::dot(area, to) / distance;
            if (facing <= 0 && !c.l.two_sided) continue;
            const auto m = moments(to / distance);
            for (size_t k = 0; k < momentCount; ++k) sum[k] += m[k] * std::abs(facing) / (distance * distance) / (steps * steps);
        }
    return sum;
}

/// The mean of f(wi) / pdf is the integral of f over the solid angle of the light, at four standard errors and the quadrature's
/// own error; radiance is that of the light; a path that meets the same point by itself finds the same density.
TEST_P(AreaLights, SamplesFollowTheirDensityOverSolidAngle) {
    const AreaCase& c = GetParam();
    Random random(41);
    const auto u = generate(40000, [&] { return random.unit(); });
    const auto v = generate(40000, [&] { return random.square(); });
    for (vec3 p : c.points) {
        std::array<Accumulator, momentCount> estimates;
        const auto results = sample(sceneOf(c.l), p, u, v);
        for (size_t i = 0; i < results.size(); ++i) {
            const LightResult& r = results[i];
            if (r.pdf == 0) { for (Accumulator& e : estimates) e.add(0); continue; }
            ASSERT_FALSE(r.isDelta);
            ASSERT_NEAR(dot(r.wi, r.wi), 1, 1e-5);
            ASSERT_EQ(r.L.g, 2);
            const auto m = moments(toGlm(r.wi));
            for (size_t k = 0; k < momentCount; ++k) estimates[k].add(m[k] / r.pdf);
            ASSERT_NEAR(r.pdfHit / r.pdf, 1, 2e-3) << "u " << v[i].x << " " << v[i].y;
        }
        const auto expected = integrate(c, toGlm(p));
        for (size_t k = 0; k < momentCount; ++k) {
            const Estimate e = estimates[k].estimate();
            EXPECT_NEAR(e.mean, expected[k], 4 * e.error + 1e-3 * expected[0])
                << "moment " << k << " from " << p.x << " " << p.y << " " << p.z;
        }
    }
}

/// The sampled point lies on the light.
TEST_P(AreaLights, SamplesLieOnTheLight) {
    const AreaCase& c = GetParam();
    Random random(42);
    const auto u = generate(2000, [&] { return random.unit(); });
    const auto v = generate(2000, [&] { return random.square(); });
    const vec3 p = c.points[0];
    for (const LightResult& r : sample(sceneOf(c.l), p, u, v)) {
        if (r.pdf == 0) continue;
        const glm::dvec3 q = toGlm(p) + static_cast<double>(r.distance) * toGlm(r.wi) - toGlm(c.l.p);
        if (c.l.kind == kind_sphere_light) ASSERT_NEAR(glm::length(q), c.l.radius, 2e-6);
        else if (c.l.kind == kind_cylinder_light) {
            const glm::dvec3 local = glm::inverse(glm::dmat3(toGlm(c.l.a), toGlm(c.l.b), toGlm(c.l.c))) * q;
            ASSERT_NEAR(std::hypot(local.x, local.y), 1, 1e-5);
            ASSERT_NEAR(local.z, 0.5, 0.5 + 1e-5);
        }
        else if (c.l.kind == kind_ellipsoid_light) {
            const glm::dvec3 local = glm::inverse(glm::dmat3(toGlm(c.l.a), toGlm(c.l.b), toGlm(c.l.c))) * q;
            ASSERT_NEAR(glm::length(local), 1, 1e-5);
            ASSERT_GT(local.z, c.l.cos_inner - 1e-5f);
            ASSERT_LT(local.z, c.l.cos_outer + 1e-5f);
        }
        else if (c.name != "bilinear_curved") ASSERT_NEAR(glm::dot(q, c.outward), 0, 2e-6);
        else {
            /* A saddle: z = u v / 2, with u and v from x and y */
            ASSERT_GE(q.z, -2e-6);
            ASSERT_LE(q.z, 0.5 + 2e-6);
        }
    }
}

/// From behind, light that is emitted on one side only does not arrive.
TEST_P(AreaLights, OneSideIsDark) {
    const AreaCase& c = GetParam();
    if (c.l.kind == kind_sphere_light || c.l.kind == kind_cylinder_light || c.l.kind == kind_ellipsoid_light || c.name == "bilinear_curved")
        GTEST_SKIP() << "has no plane to be behind of";
    Random random(43);
    const auto u = generate(64, [&] { return random.unit(); });
    const auto v = generate(64, [&] { return random.square(); });
    const vec3 behind = toVec3(toGlm(c.l.p) - c.outward);
    for (const LightResult& r : sample(sceneOf(c.l), behind, u, v)) ASSERT_EQ(r.pdf > 0, c.l.two_sided != 0);
}

INSTANTIATE_TEST_SUITE_P(Lights, AreaLights,
                         testing::Values(triangleCase(false), triangleCase(true), bilinearCase(true), bilinearCase(false),
                                         sphereCase(false), sphereCase(true), diskCase(false), diskCase(true), cylinderCase(false),
                                         cylinderCase(true), ellipsoidCase(false), ellipsoidCase(true)),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace eikonal
