// Implicit surfaces at their extremes: thin shells, steep powers, functions that are nowhere defined.

#include "kind_features.h"
#include "device_function.h"
#include "implicit_scene.h"
#include "pack/space.h"
#include "random_inputs.h"
#include "stage.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace eikonal {
namespace {

/// Where a ray meets the scene's only shape, and the origins of new rays on either side of it, in scene space. t: -1 for a miss.
struct Answer { float t; vec3 p, ng, outside, inside; };

std::vector<Answer> ask(const PackedScene& scene, const std::vector<vec3>& o, const std::vector<vec3>& d) {
    static const DeviceFunction<Answer> function(
        {.include = "shape/shapes.clh",
         .type = "answer",
         .body = R"(
        geometry g = BIND_GEOMETRY;
        texture_tables tables = BIND_TEXTURES;
        shape_hit hit = intersect_element(g, 0, o, d, FAR_AWAY);
        result.t = hit.t;
        if (hit.t >= 0.0f) {
            surface at = eval_surface(g, tables, 0, NONE, o, d, 0.0f, hit);
            result.p = at.p; result.ng = at.ng;
            result.outside = offset_origin(at.p, surface_offset(at), at.ng, at.ng);
            result.inside = offset_origin(at.p, surface_offset(at), at.ng, negate(at.ng));
        })",
         .inputs = {"vec3 o", "vec3 d"},
         .declarations = "typedef struct { float t; vec3 p, ng, outside, inside; } answer;",
         .tables = "GEOMETRY_TABLES(TABLE) TEXTURE_TABLES(TABLE)",
         .features = Features().require(KindFeature::SHAPE_IMPLICIT)});
    const DeviceScene onDevice(testContext(), scene);
    return function.with(onDevice, o, d);
}

glm::dvec3 toGlm(vec3 v) { return {v.x, v.y, v.z}; }

/// Object space over scene space.
constexpr double scale = 4;

/// F + 1 at a point of scene space.
double squaredRadius(vec3 p) { return scale * scale * glm::dot(toGlm(p), toGlm(p)); }

/// Rays from all around at a ball that is a little smaller than the shells below.
struct Rays { std::vector<vec3> o, d; };
Rays raysAtBall(size_t count) {
    Random random(95);
    Rays r;
    for (size_t i = 0; i < count; ++i) {
        const glm::dvec3 target = toGlm(random.direction()) * 0.249 * std::cbrt(static_cast<double>(random.unit()));
        const glm::dvec3 from = toGlm(random.direction());
        r.o.push_back(toVec3(target + from));
        r.d.push_back(toVec3(-from));
    }
    return r;
}

/// A shell between the radii sqrt(1 - h) and sqrt(1 + h). Evaluating F rounds six times at magnitudes of about 1, by less than 1e-6 in all.
/// So for h from 1e-5 up every ray at the ball meets the outer side with the normal outward, new rays start on the side that they belong
/// to, and rays that leave meet nothing, since the outer side is convex.
TEST(ExtremeImplicit, ThinShellsHaveTwoSides) {
    for (const double h : {1e-2, 1e-3, 1e-4, 1e-5}) {
        const Rays rays = raysAtBall(20000);
        const PackedScene scene = sceneOf(fmt::format("abs(x^2 + y^2 + z^2 - 1) - {}", h));
        const auto answers = ask(scene, rays.o, rays.d);
        Random random(96);
        std::vector<vec3> leaving, on;
        size_t missed = 0, turned = 0, notOutside = 0, notWithin = 0, metAgain = 0;
        for (const Answer& a : answers) {
            missed += a.t < 0;
            turned += glm::dot(toGlm(a.ng), toGlm(a.p)) <= 0;
            notOutside += squaredRadius(a.outside) <= 1 + h;
            notWithin += std::abs(squaredRadius(a.inside) - 1) >= h;
            const glm::dvec3 w = toGlm(random.direction());
            on.push_back(toVec3(glm::dot(w, toGlm(a.ng)) < 0 ? -w : w));
            leaving.push_back(a.outside);
        }
        for (const Answer& a : ask(scene, leaving, on)) metAgain += a.t >= 0;
        EXPECT_EQ(missed, 0u) << h;
        EXPECT_EQ(turned, 0u) << h;
        EXPECT_EQ(notOutside, 0u) << h;
        EXPECT_EQ(notWithin, 0u) << h;
        EXPECT_EQ(metAgain, 0u) << h;
    }
}

/// x^n + y^2 = 1: against bisection in double precision along rays through the middle. Near the flat sides |x| = 1 the power's bound is
/// n 2^-23 wide, which moves the root by 2^-23.
TEST(ExtremeImplicit, SteepPowersKeepTheirSurface) {
    for (const int n : {1000, 10000, 1000000}) {
        Random random(97);
        Rays rays;
        for (int i = 0; i < 4000; ++i) {
            const double angle = 2 * M_PI * static_cast<double>(random.unit());
            const glm::dvec3 from(std::cos(angle), std::sin(angle), 0);
            rays.o.push_back(toVec3(from));
            rays.d.push_back(toVec3(-from));
        }
        const auto answers = ask(sceneOf(fmt::format("x^{} + y^2 - 1", n)), rays.o, rays.d);
        for (size_t i = 0; i < answers.size(); ++i) {
            const glm::dvec3 o = scale * toGlm(rays.o[i]), d = toGlm(rays.d[i]);
            double outside = 2, inside = 4;   // distances in object space: on the box or beyond; in the middle
            for (int step = 0; step < 60; ++step) {
                const glm::dvec3 p = o + (outside + inside) / 2 * d;
                (std::pow(std::abs(p.x), n) + p.y * p.y > 1 ? outside : inside) = (outside + inside) / 2;
            }
            ASSERT_NEAR(scale * static_cast<double>(answers[i].t), inside, 1e-5) << "n " << n << ", ray " << i;
        }
    }
}

}  // namespace
}  // namespace eikonal
