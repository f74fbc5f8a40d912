// Warps from the unit square, and frames: densities by chi-square and moments, accuracy against double precision.

#include "device_function.h"
#include "random_inputs.h"
#include "statistics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace eikonal {
namespace {

struct Warps { vec2 circle, disk; vec3 cosine, sphere; vec2 triangle; float heuristic; };
struct Frame { vec3 x, y, z, round; };

const std::vector<Warps>& warps(std::vector<vec2>* inputs = nullptr) {
    static const std::vector<vec2> u = [] {
        /* The corners of the square, then a stratified grid: cell (i, j) of 256 x 256 has one point */
        std::vector<vec2> points{{0, 0}, {0, 1 - 0x1p-24f}, {1 - 0x1p-24f, 0}, {1 - 0x1p-24f, 1 - 0x1p-24f}};
        Random random(11);
        for (int i = 0; i < 256 * 256; ++i) {
            const vec2 v = random.square();
            points.push_back({(static_cast<float>(i % 256) + v.x) / 256, (static_cast<float>(i / 256) + v.y) / 256});
        }
        return points;
    }();
    static const std::vector<Warps> results = [] {
        const DeviceFunction<Warps> function({.include = "math/warp.clh", .type = "warps",
            .body = "result.circle = unit_circle(u.x); result.disk = warp_disk(u); result.cosine = warp_cosine_hemisphere(u);"
                    "result.sphere = warp_sphere(u); result.triangle = warp_triangle(u); result.heuristic = power_heuristic(u.x, u.y);",
            .inputs = {"vec2 u"},
            .declarations = "typedef struct { vec2 circle, disk; vec3 cosine, sphere; vec2 triangle; float heuristic; } warps;"});
        return function(u);
    }();
    if (inputs) *inputs = u;
    return results;
}

/// Points that are uniform over [0, 1)^2 in the coordinates `coordinates` fall alike into 32 x 32 cells. The inputs are
/// stratified, so the counts vary less than Poisson's: the test is for too much chi-square only.
template <class F> void expectUniform(F coordinates) {
    constexpr int n = 32;
    std::vector<double> counts(n * n), expected(n * n, static_cast<double>(warps().size()) / (n * n));
    for (const Warps& w : warps()) {
        const auto [x, y] = coordinates(w);
        const int i = std::clamp(static_cast<int>(x * n), 0, n - 1), j = std::clamp(static_cast<int>(y * n), 0, n - 1);
        counts[static_cast<size_t>(j * n + i)] += 1;
    }
    const ChiSquare chi = testChiSquare(counts, expected);
    EXPECT_GT(chi.probability, significance) << chi.describe();
}

double turnOf(double x, double y) { const double t = std::atan2(y, x) / (2 * M_PI); return t < 0 ? t + 1 : t; }

/// unit_circle promises an absolute error below 2e-7.
TEST(Warp, CircleIsAccurate) {
    std::vector<vec2> u;
    warps(&u);
    for (size_t i = 0; i < u.size(); ++i) {
        const double angle = 2 * M_PI * static_cast<double>(u[i].x);
        ASSERT_NEAR(warps()[i].circle.x, std::cos(angle), 2e-7) << u[i].x;
        ASSERT_NEAR(warps()[i].circle.y, std::sin(angle), 2e-7) << u[i].x;
    }
}

/// Uniform over the disk: r^2 and the angle are independent and uniform.
TEST(Warp, DiskIsUniform) {
    expectUniform([](const Warps& w) { const double x = w.disk.x, y = w.disk.y; return std::pair(x * x + y * y, turnOf(x, y)); });
    for (const Warps& w : warps()) ASSERT_LE(w.disk.x * w.disk.x + w.disk.y * w.disk.y, 1 + 1e-6f);
}

/// Density cos(theta) / pi: cos^2 is uniform.
TEST(Warp, CosineHemisphereFollowsTheCosine) {
    expectUniform([](const Warps& w) { const double z = w.cosine.z; return std::pair(z * z, turnOf(w.cosine.x, w.cosine.y)); });
    for (const Warps& w : warps()) {
        ASSERT_GE(w.cosine.z, 0);
        ASSERT_NEAR(dot(w.cosine, w.cosine), 1, 2e-6);
    }
}

/// Uniform over the sphere: z is uniform (Archimedes).
TEST(Warp, SphereIsUniform) {
    expectUniform([](const Warps& w) { return std::pair((static_cast<double>(w.sphere.z) + 1) / 2, turnOf(w.sphere.x, w.sphere.y)); });
    for (const Warps& w : warps()) ASSERT_NEAR(dot(w.sphere, w.sphere), 1, 2e-6);
}

/// Uniform over the triangle: with (s, t) = (b1 + b2 squared, b1's share of it), both are uniform.
TEST(Warp, TriangleIsUniform) {
    expectUniform([](const Warps& w) {
        const double b1 = w.triangle.x, b2 = w.triangle.y, sum = b1 + b2;
        return std::pair(sum * sum, sum > 0 ? b1 / sum : 0.5);
    });
    for (const Warps& w : warps()) {
        ASSERT_GE(std::min(w.triangle.x, w.triangle.y), 0);
        ASSERT_LE(w.triangle.x + w.triangle.y, 1 + 1e-6f);
    }
}

/// Weights of two strategies for the same sample add up to one, also where a density is tiny or huge.
TEST(Warp, PowerHeuristicIsAPartitionOfOne) {
    const DeviceFunction<vec2> both({.include = "math/warp.clh",
                                     .type = "vec2",
                                     .body = "result = make_vec2(power_heuristic(p, q), power_heuristic(q, p));",
                                     .inputs = {"float p", "float q"}});
    Random random(3);
    const auto p = generate(10000, [&] { return random.logBetween(1e-15f, 1e15f); }),
               q = generate(10000, [&] { return random.logBetween(1e-15f, 1e15f); });
    const auto weights = both(p, q);
    for (size_t i = 0; i < p.size(); ++i) {
        const double a = p[i], b = q[i], want = a * a / (a * a + b * b);
        ASSERT_NEAR(weights[i].x, want, 1e-6) << a << " " << b;
        ASSERT_NEAR(weights[i].x + weights[i].y, 1, 1e-6) << a << " " << b;
    }
}

/// A frame around any unit vector, the poles included, is orthonormal, right-handed, and to_local and from_local are inverse.
TEST(Warp, FramesAreOrthonormal) {
    const DeviceFunction<Frame> function({.include = "math/warp.clh", .type = "probe",
        .body = "frame3 f = make_frame(z); result.x = f.x; result.y = f.y; result.z = f.z; result.round = from_local(f, to_local(f, v));",
        .inputs = {"vec3 z", "vec3 v"}, .declarations = "typedef struct { vec3 x, y, z, round; } probe;"});
    Random random(4);
    std::vector<vec3> z{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}, {1e-4f, 0, -1}, {0, 1e-6f, -1}, {1e-20f, 1e-20f, -1}};
    while (z.size() < 10000) z.push_back(random.direction());
    const auto v = generate(z.size(), [&] { return random.direction(); });
    const auto frames = function(z, v);
    for (size_t i = 0; i < z.size(); ++i) {
        const Frame& f = frames[i];
        ASSERT_NEAR(dot(f.x, f.x), 1, 1e-5);
        ASSERT_NEAR(dot(f.y, f.y), 1, 1e-5);
        ASSERT_NEAR(dot(f.x, f.y), 0, 1e-5);
        ASSERT_NEAR(dot(f.x, f.z), 0, 1e-5);
        ASSERT_NEAR(dot(f.y, f.z), 0, 1e-5);
        const vec3 cross{f.x.y * f.y.z - f.x.z * f.y.y, f.x.z * f.y.x - f.x.x * f.y.z, f.x.x * f.y.y - f.x.y * f.y.x};
        ASSERT_NEAR(dot(cross, f.z), 1, 1e-5);
        const vec3 d{f.round.x - v[i].x, f.round.y - v[i].y, f.round.z - v[i].z};
        ASSERT_LT(dot(d, d), 1e-10);
    }
}

}  // namespace
}  // namespace eikonal
