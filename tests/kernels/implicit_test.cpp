// Implicit surfaces against double precision: bounds hold, no root is missed, and points lie where F is zero.

#include "kind_features.h"
#include "device_function.h"
#include "implicit_scene.h"
#include "pack/pack.h"
#include "random_inputs.h"
#include "stage.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace eikonal {
namespace {

using Function = std::function<double(double, double, double)>;

/// What an expression is, computed by the C++ compiler.
struct Known { const char* text; Function f; };

struct Answer { float t; vec3 p, error, ng; float value_low, value_high, slope_low, slope_high; uint undefined, broken; };

/// For each ray: where it meets the scene's only shape; and bounds on F and on its slope along d over the box o + [0, size] d.
std::vector<Answer> ask(const PackedScene& scene, const std::vector<vec3>& o, const std::vector<vec3>& d, const std::vector<float>& size) {
    static const DeviceFunction<Answer> function({.include = "shape/shapes.clh",
                                                  .type = "answer",
                                                  .body = R"(
        geometry g = BIND_GEOMETRY;
        texture_tables tables = BIND_TEXTURES;
        shape_hit hit = intersect_element(g, 0, o, d, FAR_AWAY);
        result.t = hit.t;
        if (hit.t >= 0.0f) {
            surface at = eval_surface(g, tables, 0, NONE, o, d, 0.0f, hit);
            result.p = at.p; result.error = at.error; result.ng = at.ng;
        }
        object_space q = g.object_spaces[0];
        vec3 a = transform_point(q.object_from_scene, o), w = transform_vector(q.object_from_scene, d), b = mul_add(w, size, a);
        wide_boxes box;
        box.x = make_range((wide)min1(a.x, b.x), (wide)max1(a.x, b.x));
        box.y = make_range((wide)min1(a.y, b.y), (wide)max1(a.y, b.y));
        box.z = make_range((wide)min1(a.z, b.z), (wide)max1(a.z, b.z));
        box.dx = (wide)w.x; box.dy = (wide)w.y; box.dz = (wide)w.z;
        wide_evaluation f = eval_program(g.implicit_instructions, g.implicits[0].instruction_count, &box, 1);
        result.value_low = f.value.low.s3; result.value_high = f.value.high.s3;
        result.slope_low = f.slope.low.s3; result.slope_high = f.slope.high.s3;
        result.undefined = f.undefined.s3 != 0; result.broken = f.broken.s3 != 0;)",
                                                  .inputs = {"vec3 o", "vec3 d", "float size"},
                                                  .declarations = "typedef struct { float t; vec3 p, error, ng; float value_low, "
                                                                  "value_high, slope_low, slope_high; uint undefined, broken; } answer;",
                                                  .tables = "GEOMETRY_TABLES(TABLE) TEXTURE_TABLES(TABLE)",
                                                  .features = Features().require(KindFeature::SHAPE_IMPLICIT)});
    const DeviceScene onDevice(testContext(), scene);
    return function.with(onDevice, o, d, size);
}

constexpr double scale = 4;

glm::dvec3 toGlm(vec3 v) { return {v.x, v.y, v.z}; }
vec3 fromGlm(glm::dvec3 v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }

/// Every instruction of the programs, alone and nested.
const Known expressions[] = {
    {"x + 2*y - z/3 - (.5 - x)", [](double x, double y, double z) { return x + 2 * y - z / 3 - (.5 - x); }},
    {"x*y - z*z + (x - y)^2", [](double x, double y, double z) { return x * y - z * z + (x - y) * (x - y); }},
    {"x^3 - y^4*z^5 + x^11", [](double x, double y, double z) { return x * x * x - std::pow(y, 4) * std::pow(z, 5) + std::pow(x, 11); }},
    {"1/x + y/z - x^-3", [](double x, double y, double z) { return 1 / x + y / z - 1 / (x * x * x); }},
    {"sqrt(x + y) - sqrt(x*x + z*z)", [](double x, double y, double z) { return std::sqrt(x + y) - std::sqrt(x * x + z * z); }},
    {"x^1.5 + (y*y)^.3 - z^-.7", [](double x, double y, double z) { return std::pow(x, 1.5) + std::pow(y * y, .3) - std::pow(z, -.7); }},
    {"exp(2*x - y) - log(z) + log(x*x + y*y)",
     [](double x, double y, double z) { return std::exp(2 * x - y) - std::log(z) + std::log(x * x + y * y); }},
    {"sin(7*x)*cos(5*y) + sin(20*z*x)",
     [](double x, double y, double z) { return std::sin(7 * x) * std::cos(5 * y) + std::sin(20 * z * x); }},
    {"tan(x + y) - z", [](double x, double y, double z) { return std::tan(x + y) - z; }},
    {"asin(x) + acos(y*z)", [](double x, double y, double z) { return std::asin(x) + std::acos(y * z); }},
    {"atan(3*x) - atan2(y, z)", [](double x, double y, double z) { return std::atan(3 * x) - std::atan2(y, z); }},
    {"abs(x - y) - abs(z)*abs(x)", [](double x, double y, double z) { return std::abs(x - y) - std::abs(z) * std::abs(x); }},
    {"min(x*y, z) + max(x, max(y, -.5))", [](double x, double y, double z) { return std::min(x * y, z) + std::max(x, std::max(y, -.5)); }},
    {"sinh(x) - cosh(y*z) + tanh(5*z)", [](double x, double y, double z) { return std::sinh(x) - std::cosh(y * z) + std::tanh(5 * z); }},
    {"(x*x + 1)^y - z", [](double x, double y, double z) { return std::pow(x * x + 1, y) - z; }},
    {"exp(exp(exp(4*x))) - 1/exp(exp(exp(4*y))) + z^200",
     [](double x, double y, double z) {
         return std::exp(std::exp(std::exp(4 * x))) - 1 / std::exp(std::exp(std::exp(4 * y))) + std::pow(z, 200);
     }},
};

TEST(ImplicitBounds, HoldWhateverFIsInABox) {
    Random random(90);
    constexpr size_t boxes = 1500;
    for (const Known& known : expressions) {
        std::vector<vec3> o, d;
        std::vector<float> size;
        for (size_t i = 0; i < boxes; ++i) {
            o.push_back(random.box(0.4f));
            d.push_back(random.direction());
            size.push_back(i % 3 == 0 ? 0.0f : std::pow(10.0f, -6.0f * random.unit()));
        }
        const auto answers = ask(sceneOf(known.text), o, d, size);
        size_t narrow = 0, points = 0, defined = 0;
        for (size_t i = 0; i < boxes; ++i) {
            const Answer& a = answers[i];
            const auto along = [&](double s) {
                const glm::dvec3 p = scale * (toGlm(o[i]) + s * static_cast<double>(size[i]) * toGlm(d[i]));
                return known.f(p.x, p.y, p.z);
            };
            for (const double s : {0., .1, .37, .5, .8, 1.}) {
                const double value = along(s);
                if (std::isnan(value)) { EXPECT_TRUE(a.broken || a.undefined) << known.text; continue; }
                ++defined;
                /* The boxes' corners were rounded once more here than there */
                const double slope = (along(s + 1e-7) - along(s - 1e-7)) / (2e-7 * std::max(static_cast<double>(size[i]), 1e-30)),
                             moved = 3e-7 * std::abs(slope);
                const double slack = std::isfinite(moved) && size[i] > 0 ? moved : 1e-5 * std::abs(value) + 1e-5;
                if (a.undefined) { ADD_FAILURE() << known.text << " is defined in box " << i; break; }
                if (a.value_low > -1e36f) { ASSERT_GE(value, static_cast<double>(a.value_low) - slack) << known.text << ", box " << i; }
                if (a.value_high < 1e36f) { ASSERT_LE(value, static_cast<double>(a.value_high) + slack) << known.text << ", box " << i; }
                if (size[i] < 1e-2f || a.broken || !std::isfinite(slope) || s == 0 || s == 1) continue;
                if (a.slope_low > -1e36f) {
                    ASSERT_GE(slope, static_cast<double>(a.slope_low) - 1e-4 * std::abs(slope) - 1e-3) << known.text << ", box " << i;
                }
                if (a.slope_high < 1e36f) {
                    ASSERT_LE(slope, static_cast<double>(a.slope_high) + 1e-4 * std::abs(slope) + 1e-3) << known.text << ", box " << i;
                }
            }
            /* And are of some use: at a point there is not much between them */
            if (size[i] > 0 || a.broken || a.undefined || std::abs(a.value_high) > 1e4f) continue;
            ++points;
            narrow += a.value_high - a.value_low < 1e-3f * std::max(1.0f, std::abs(a.value_high));
        }
        EXPECT_GT(defined, boxes / 2) << known.text;
        EXPECT_GE(narrow, points - points / 50) << known.text;
    }
}

/// A surface whose roots double precision finds by looking at many points of a ray; tolerance: of t, in object space, besides rounding.
struct Surface { const char* text; Function f; };
const Surface surfaces[] = {
    {"x^2 + y^2 + z^2 - 1", [](double x, double y, double z) { return x * x + y * y + z * z - 1; }},
    {"(x^2 + y^2 + z^2 + .91)^2 - 4*(x^2 + y^2)",
     [](double x, double y, double z) {
         const double s = x * x + y * y + z * z + .91;
         return s * s - 4 * (x * x + y * y);
     }},
    {"x^2*y^2 + y^2*z^2 + z^2*x^2 - x*y*z",
     [](double x, double y, double z) { return x * x * y * y + y * y * z * z + z * z * x * x - x * y * z; }},
    {"x^20 + y^20 + z^20 - 1", [](double x, double y, double z) { return std::pow(x, 20) + std::pow(y, 20) + std::pow(z, 20) - 1; }},
    {"8*x^4 - 8*x^2 + 8*y^4 - 8*y^2 + 8*z^4 - 8*z^2 + 3",
     [](double x, double y, double z) {
         const auto T = [](double t) { return 8 * t * t * t * t - 8 * t * t + 1; };
         return T(x) + T(y) + T(z);
     }},
    {"sin(4*x)*cos(4*y) + sin(4*y)*cos(4*z) + sin(4*z)*cos(4*x)",
     [](double x, double y, double z) {
         return std::sin(4 * x) * std::cos(4 * y) + std::sin(4 * y) * std::cos(4 * z) + std::sin(4 * z) * std::cos(4 * x);
     }},
    {"max(x^2 + y^2 + z^2 - 1, .6 - sqrt(x^2 + y^2))",
     [](double x, double y, double z) { return std::max(x * x + y * y + z * z - 1, .6 - std::sqrt(x * x + y * y)); }},
    {"x^2 + y^2 - z^3", [](double x, double y, double z) { return x * x + y * y - z * z * z; }},
    {"z - .5*log(x + 1) + 1/(y - .2)", [](double x, double y, double z) { return z - .5 * std::log(x + 1) + 1 / (y - .2); }},
};

struct Rays { std::vector<vec3> o, d; std::vector<float> size; };
Rays raysAtBox(size_t count, std::uint64_t seed) {
    Random random(seed);
    Rays r;
    for (size_t i = 0; i < count; ++i) {
        const vec3 target = random.box(0.45f), from = random.direction();
        const double distance = i % 3 ? 1.5 : 0.2;
        r.d.push_back({-from.x, -from.y, -from.z});
        r.o.push_back(fromGlm(toGlm(target) + distance * toGlm(from)));
        r.size.push_back(0);
    }
    return r;
}

/// Where the ray, in scene space, leaves the box; and enters it.
std::pair<double, double> spanOf(vec3 o, vec3 d) {
    double enter = 0, leave = 1e9;
    for (int c = 0; c < 3; ++c) {
        const double a = (-.5 - toGlm(o)[c]) / toGlm(d)[c], b = (.5 - toGlm(o)[c]) / toGlm(d)[c];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return {enter, leave};
}

TEST(ImplicitRoots, AreTheFirstOnesOfDoublePrecision) {
    constexpr size_t rays = 3000;
    constexpr int steps = 3000;
    for (const Surface& surface : surfaces) {
        const Rays r = raysAtBox(rays, 91);
        const auto answers = ask(sceneOf(surface.text), r.o, r.d, r.size);
        size_t met = 0;
        for (size_t i = 0; i < rays; ++i) {
            const auto at = [&](double t) {
                const glm::dvec3 p = scale * (toGlm(r.o[i]) + t * toGlm(r.d[i]));
                return surface.f(p.x, p.y, p.z);
            };
            const auto [enter, leave] = spanOf(r.o[i], r.d[i]);
            const double step = (leave - enter) / steps;
            double root = -1;
            for (int k = 0; k < steps && enter < leave && root < 0; ++k) {
                double a = enter + k * step, b = enter + (k + 1) * step;
                const double fa = at(a), fb = at(b);
                if (!(fa * fb < 0) || std::abs(fa - fb) > 10) continue;   // a pole is no root
                for (int n = 0; n < 60; ++n) { const double m = (a + b) / 2; (at(m) * fa > 0 ? a : b) = m; }
                root = a;
            }
            const double found = answers[i].t;
            met += found >= 0;
            if (root >= 0) { ASSERT_GE(found, 0) << surface.text << ", ray " << i << " misses the root at " << root; }
            /* One that is nearer than double precision's steps tell apart must be a root all the same */
            if (found < 0) continue;
            const glm::dvec3 p = scale * toGlm(answers[i].p), n = toGlm(answers[i].ng);
            constexpr double by = 2e-4;
            const double inside = surface.f(p.x - by * n.x, p.y - by * n.y, p.z - by * n.z),
                         outside = surface.f(p.x + by * n.x, p.y + by * n.y, p.z + by * n.z);
            if (root >= 0) { ASSERT_LT(found, root + 2e-5) << surface.text << ", ray " << i; }
            if (root < 0 || found < root - 2e-5) {
                EXPECT_LT(std::abs(at(found)), 1e-4 + 2e-5 * std::abs(at(found + 1e-7) - at(found - 1e-7)) / 2e-7)
                    << surface.text << ", ray " << i << " finds a root at " << found << " that is none; there is one at " << root;
            }
            /* The normal goes from negative to positive; at an edge or a tip it may not */
            if (inside * outside < 0) { EXPECT_GT(outside, inside) << surface.text << ", ray " << i; }
            ASSERT_NEAR(glm::length(n), 1, 1e-5);
            EXPECT_LT(glm::length(toGlm(answers[i].p) - (toGlm(r.o[i]) + found * toGlm(r.d[i]))), 2e-3) << surface.text << ", ray " << i;
        }
        EXPECT_GT(met, rays / 20) << surface.text;
    }
}

/// Where F touches zero and nowhere changes its sign, the surface is what single precision cannot tell from zero: here less than 1e-3
/// thick.
TEST(ImplicitRoots, ThatTouchAreFound) {
    for (const char* text : {"(x^2 + y^2 + z^2 - 1)^2", "abs(x^2 + y^2 + z^2 - 1)", "-(1 - sqrt(x^2 + y^2 + z^2))^2"}) {
        const Rays r = raysAtBox(4000, 92);
        const auto answers = ask(sceneOf(text), r.o, r.d, r.size);
        size_t missed = 0;
        for (size_t i = 0; i < r.o.size(); ++i) {
            const glm::dvec3 o = scale * toGlm(r.o[i]), d = toGlm(r.d[i]);
            const double b = -glm::dot(o, d), nearest = glm::length(o + b * d);
            if (nearest > 1.001) { EXPECT_LT(answers[i].t, 0) << text << ", ray " << i; continue; }
            if (nearest > 0.995) continue;
            const double half = std::sqrt(1 - nearest * nearest), first = b - half > 0 ? b - half : b + half;
            if (first <= 1e-2) { continue; }   // it starts on the surface, or behind it
            if (answers[i].t < 0) { ++missed; continue; }
            EXPECT_NEAR(scale * static_cast<double>(answers[i].t), first, 2e-3 / half) << text << ", ray " << i;
            EXPECT_LT(glm::dot(toGlm(answers[i].ng), d) * (text[0] == '-' ? -1 : 1), 0)
                << "the normal is the gradient where the ray comes from";
        }
        EXPECT_EQ(missed, 0u) << text;
    }
}

/// A ball in a box of any size: scene space is the same, object space is not.
TEST(ImplicitRoots, DoNotDependOnTheUnit) {
    const Rays r = raysAtBox(500, 94);
    const auto expected = ask(sceneOf("x^2 + y^2 + z^2 - 1"), r.o, r.d, r.size);
    for (const int exponent : {-45, -20, 20, 45}) {
        const double unit = std::ldexp(1, exponent);
        const PackedScene scene =
            packText(fmt::format("WorldBegin Shape \"implicit\" \"string F\" \"x^2 + y^2 + z^2 - a^2\" \"float a\" {0:.17g} \"point3 "
                                 "bounds\" [{1:.17g} {1:.17g} {1:.17g}  {2:.17g} {2:.17g} {2:.17g}]",
                                 unit, -2 * unit, 2 * unit));
        const auto answers = ask(scene, r.o, r.d, r.size);
        for (size_t i = 0; i < answers.size(); ++i) {
            ASSERT_NEAR(answers[i].t, expected[i].t, 1e-5f) << "in units of 2^" << exponent << ", ray " << i;
            if (answers[i].t >= 0) {
                ASSERT_LT(glm::length(toGlm(answers[i].error)), 1e-5) << "in units of 2^" << exponent << ", ray " << i;
            }
        }
    }
}

/// Nothing that can be written makes the search endless, or its answer no number.
TEST(ImplicitRoots, EndWhateverFIs) {
    for (const char* text :
         {"sin(1/(x^2 + y^2))", "0*x", "x - x", "sqrt(x - 10)", "log(-x*x)", "1/x", "exp(exp(exp(9*x))) - exp(exp(exp(9*y)))",
          "sin(1e6*x)*sin(1e6*y)*sin(1e6*z)", "tan(30*x*y*z)", "x^1000 - y^999", "1e-30*x", "1e34*x*y*z*x*y", "(x*y*z)^9",
          "max(x^2 + y^2 + z^2 - 1, 0)", "atan2(y, x)", "min(sqrt(x), log(y))"}) {
        const Rays r = raysAtBox(200, 93);
        for (const Answer& a : ask(sceneOf(text), r.o, r.d, r.size)) {
            ASSERT_TRUE(std::isfinite(a.t)) << text;
            if (a.t < 0) continue;
            ASSERT_TRUE(std::isfinite(a.p.x) && std::isfinite(a.error.x) && std::isfinite(a.error.y) && std::isfinite(a.ng.z)) << text;
            ASSERT_NEAR(glm::length(toGlm(a.ng)), 1, 1e-4) << text;
        }
    }
}

}  // namespace
}  // namespace eikonal
