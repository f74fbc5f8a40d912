// Every light of the list LIGHTS: what a sample says arrives at a point is what does, with the density that it says.

#include "device_function.h"
#include "pack/alias_table.h"
#include "pack/packer.h"
#include "pack/pack.h"
#include "random_inputs.h"
#include "scene/equal_area.h"
#include "statistics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <set>

namespace eikonal {
namespace {

struct LightResult {
    spectrum L; vec3 wi; float distance, pdf; int isDelta;   ///< sample_light
    uint index;                                              ///< which light the sampler took
    float pdfHit;                                            ///< density that a path finds which meets that point by itself (areas)
    spectrum Le; float pdfEnvironment;                       ///< eval_x and pdf_x of wi (environments)
};

const DeviceFunction<LightResult>& sampler() {
    static const DeviceFunction<LightResult> function({.include = "route_items.clh", .type = "light_result", .body = R"(
        light_tables tables = BIND_LIGHTS;
        color_tables color_set = BIND_COLORS;
        palette colors = path_palette(color_set, 0u, 0u);
        light_choice found = choose_light_by_power(tables, no_choice(), count, u);
        if (tables.lights[found.light].kind == kind_portal_environment) found = sample_portal(tables, fetch(tables.lights + found.light), p, v, found);
        light_sample s = sample_light(tables, colors, found, p, v);
        result.L = s.L; result.wi = s.wi; result.distance = s.distance; result.pdf = s.pdf; result.is_delta = s.is_delta;
        result.index = sample_light_index(tables, count, u);
        light l = fetch(tables.lights + result.index);
        surface at;
        at.p = mul_add(s.wi, s.distance, p);
        at.ng = l.n;
        at.uv = v;
        if (l.kind == kind_cylinder_light) at.ng = normalize3(cylinder_light_across(l, unit_circle(v.x * l.extent)));
        if (l.kind == kind_sphere_light) at.ng = mul(sub(mul_add(s.wi, s.distance, p), l.p), 1.0f / l.radius);
        if (l.kind == kind_bilinear_light) at.ng = normalize3(cross3(mul_add(l.c, v.y, l.a), mul_add(l.c, v.x, l.b)));
        ray_item r = new_ray();
        r.o = p; r.d = s.wi; r.traveled = 0.0f;
        flight_item f = new_flight();
        f.t = s.distance; f.u = v.x; f.v = v.y;
        result.pdf_hit = pdf_light_here(l, r, f, at);
        int image = l.kind == kind_image_environment;
        result.Le = eval_constant_environment(eval_color(colors, l.L));
        result.pdf_environment = pdf_constant_environment();
        if (image) { result.Le = eval_image_environment(tables, colors, l, eval_color(colors, l.L), s.wi); result.pdf_environment = pdf_image_environment(tables, l, s.wi); }
        if (l.kind == kind_portal_environment) {
            portal_light seen = eval_portal_environment(tables, colors, l, eval_color(colors, l.L), p, s.wi);
            result.Le = seen.Le;
            result.pdf_environment = seen.pdf;
        })",
        .inputs = {"vec3 p", "float u", "vec2 v", "uint count"},
        .declarations = "typedef struct { spectrum L; vec3 wi; float distance, pdf; int is_delta; uint index; float pdf_hit; spectrum Le; float pdf_environment; } light_result;",
        .tables = "LIGHT_ARGUMENTS COLOR_ARGUMENTS"});
    return function;
}

std::vector<LightResult> sample(const PackedScene& scene, vec3 p, const std::vector<float>& u, const std::vector<vec2>& v) {
    const DeviceScene onDevice(testContext(), scene);
    return sampler().with(onDevice, std::vector<vec3>(u.size(), p), u, v, std::vector<uint>(u.size(), static_cast<uint>(scene.tables.lights.size())));
}

PackedScene sceneOf(const light& l) {
    PackedScene scene;
    scene.tables.lights = {l};
    scene.tables.light_aliases = makeAliasTable({1});
    scene.tables.frame.resize(1);
    return scene;
}

glm::dvec3 toGlm(vec3 v) { return {v.x, v.y, v.z}; }

/// A light with an area as a surface over the unit square, in double precision.
using Surface = std::function<glm::dvec3(double, double)>;

struct AreaCase { std::string name; light l; Surface surface; glm::dvec3 outward; std::vector<vec3> points; };
void PrintTo(const AreaCase& c, std::ostream* out) { *out << c.name; }

light newLight(light_kind kind) {
    light l{};
    l.kind = kind;
    l.pmf = 1;
    l.extent = 1;
    l.resolution = l.rows = 1;
    l.element = l.leaf = NONE;
    l.L = packRgb({1, 2, 3});
    return l;
}

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
            const glm::dvec3 q = c.surface(u, v), du = (c.surface(u + h, v) - c.surface(u - h, v)) / (2 * h), dv = (c.surface(u, v + h) - c.surface(u, v - h)) / (2 * h);
            glm::dvec3 area = glm::cross(du, dv);
            if (c.l.kind == kind_cylinder_light) area *= c.l.n.x;
            const glm::dvec3 side = c.l.kind == kind_cylinder_light ? area : c.l.kind == kind_sphere_light ? (q - toGlm(c.l.p)) * static_cast<double>(c.l.n.x) : c.outward;
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
            EXPECT_NEAR(e.mean, expected[k], 4 * e.error + 1e-3 * expected[0]) << "moment " << k << " from " << p.x << " " << p.y << " " << p.z;
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
    if (c.l.kind == kind_sphere_light || c.l.kind == kind_cylinder_light || c.name == "bilinear_curved") GTEST_SKIP() << "has no plane to be behind of";
    Random random(43);
    const auto u = generate(64, [&] { return random.unit(); });
    const auto v = generate(64, [&] { return random.square(); });
    const vec3 behind = toVec3(toGlm(c.l.p) - c.outward);
    for (const LightResult& r : sample(sceneOf(c.l), behind, u, v)) ASSERT_EQ(r.pdf > 0, c.l.two_sided != 0);
}

INSTANTIATE_TEST_SUITE_P(Lights, AreaLights, testing::Values(triangleCase(false), triangleCase(true), bilinearCase(true), bilinearCase(false), sphereCase(false),
                                                             sphereCase(true), diskCase(false), diskCase(true), cylinderCase(false), cylinderCase(true)), [](const auto& info) { return info.param.name; });

// ---- lights without area --------------------------------------------------------------------------------------------

/// A point gives E = I / r^2 along the line to it; a distant light its irradiance from one direction; a spot what its cubic
/// between the cosines of the two cones says.
TEST(DeltaLights, GiveTheirIrradiance) {
    light point = newLight(kind_point_light), spot = newLight(kind_spot_light), distant = newLight(kind_distant_light);
    point.p = spot.p = {0.5f, -1, 2};
    spot.n = {0, 0.6f, -0.8f};
    spot.cos_inner = 0.9f; spot.cos_outer = 0.7f;
    distant.n = {0, 0.6f, 0.8f};
    Random random(44);
    for (int i = 0; i < 200; ++i) {
        const vec3 p = random.box(3);
        const glm::dvec3 to = toGlm(point.p) - toGlm(p), w = glm::normalize(to);
        const double r2 = glm::dot(to, to);
        const auto one = [&](const light& l) { return sample(sceneOf(l), p, {0.5f}, {{0.5f, 0.5f}}).front(); };
        const LightResult a = one(point), b = one(spot), c = one(distant);
        for (const LightResult& r : {a, b, c}) { EXPECT_TRUE(r.isDelta); EXPECT_EQ(r.pdf, 1); }
        EXPECT_NEAR(a.L.b, 3 / r2, 1e-5 * 3 / r2);
        EXPECT_NEAR(a.distance, std::sqrt(r2), 1e-5 * std::sqrt(r2));
        EXPECT_NEAR(glm::dot(toGlm(a.wi), w), 1, 1e-6);
        const double x = std::clamp((glm::dot(-w, toGlm(spot.n)) - 0.7) / 0.2, 0.0, 1.0);
        EXPECT_NEAR(b.L.b, 3 / r2 * (3 - 2 * x) * x * x, 1e-5 * 3 / r2);
        EXPECT_EQ(c.L.r, 1);
        EXPECT_EQ(c.wi.y, 0.6f);
        EXPECT_EQ(c.distance, FAR_AWAY);
    }
}

// ---- environments ---------------------------------------------------------------------------------------------------

TEST(ConstantEnvironment, IsUniformOverTheSphere) {
    Random random(45);
    const auto v = generate(65536, [&] { return random.square(); });
    std::vector<double> counts(256), expected(256, 256.0);
    for (const LightResult& r : sample(sceneOf(newLight(kind_constant_environment)), {0, 0, 0}, std::vector<float>(v.size(), 0.5f), v)) {
        ASSERT_NEAR(r.pdf, 1 / (4 * M_PI), 1e-8);
        ASSERT_EQ(r.pdfEnvironment, r.pdf);
        ASSERT_EQ(r.Le.b, 3);
        const double turn = std::atan2(r.wi.y, r.wi.x) / (2 * M_PI) + 0.5;
        counts[static_cast<size_t>(std::min((r.wi.z + 1) / 2 * 16, 15.0f)) * 16 + static_cast<size_t>(std::min(turn * 16, 15.0))] += 1;
    }
    const ChiSquare chi = testChiSquare(counts, expected);
    EXPECT_GT(chi.probability, significance) << chi.describe();
}

/// An environment of very different texels, turned, as the packer makes it.
PackedScene imageScene(int resolution) {
    Scene scene;
    auto pixels = std::make_shared<ImageData>();
    pixels->width = pixels->height = resolution;
    pixels->channels = 3;
    Random random(46);
    for (int i = 0; i < resolution * resolution * 3; ++i) pixels->floats.push_back(random.below(8) == 0 ? 0 : random.logBetween(0.01f, 10));
    ImageFile file;
    file.pixels = pixels;
    scene.images.push_back(file);
    Light l;
    l.kind = ImageInfiniteLight{0};
    l.scale = 2;
    const double c = std::cos(0.7), s = std::sin(0.7);
    l.worldFromLight = glm::dmat4(glm::dmat3(c, s, 0, -s, c, 0, 0, 0, 1) * glm::dmat3(1, 0, 0, 0, c, s, 0, -s, c));
    scene.lights.push_back(l);
    Diagnostics diagnostics(LogLevel::silent);
    return packScene(scene, diagnostics);
}

/// Directions fall into the texels as often as their probability, which follows their radiance; pdf and eval of a direction are those
/// of the sample, except for directions at a texel's edge; the mean of Le / pdf is the integral over the sphere.
TEST(ImageEnvironment, SamplesFollowTheImage) {
    constexpr int n = 16;
    const PackedScene scene = imageScene(n);
    const light& l = scene.tables.lights.at(0);
    Random random(47);
    const auto v = generate(200000, [&] { return random.square(); });
    const auto results = sample(scene, {0, 0, 0}, std::vector<float>(v.size(), 0.5f), v);
    std::vector<double> counts(n * n), expected(n * n);
    double total = 0;
    const std::vector<float>& texels = scene.tables.environment_texels;
    for (float channel : texels) total += channel;
    for (size_t i = 0; i < n * n; ++i) expected[i] = (texels[3 * i] + texels[3 * i + 1] + texels[3 * i + 2]) / total * static_cast<double>(v.size());
    Accumulator red;
    int elsewhere = 0;
    for (const LightResult& r : results) {
        const glm::dvec3 d(dot(r.wi, l.a), dot(r.wi, l.b), dot(r.wi, l.n));
        const glm::dvec2 square = squareFromDirection(d);
        const size_t x = std::min(static_cast<size_t>(square.x * n), size_t{n - 1}), y = std::min(static_cast<size_t>(square.y * n), size_t{n - 1});
        counts[y * n + x] += 1;
        red.add(r.L.r / r.pdf);
        ASSERT_NEAR(dot(r.wi, r.wi), 1, 1e-5);
        const bool same = std::abs(r.pdfEnvironment - r.pdf) < 1e-4 * r.pdf && r.Le.r == r.L.r && r.Le.g == r.L.g;
        if (!same) {
            ++elsewhere;
            const double dx = square.x * n - std::round(square.x * n), dy = square.y * n - std::round(square.y * n);
            ASSERT_LT(std::min(std::abs(dx), std::abs(dy)), 1e-4) << "inside of a texel, yet another is looked up";
        }
    }
    EXPECT_LT(elsewhere, 100);
    const ChiSquare chi = testChiSquare(counts, expected);
    EXPECT_GT(chi.probability, significance) << chi.describe();
    double integral = 0;
    for (size_t i = 0; i < n * n; ++i) integral += static_cast<double>(texels[3 * i]) * 4 * M_PI / (n * n);
    EXPECT_NEAR(red.estimate().mean, integral, 4 * red.estimate().error);
}

/// Straight-line code computes every kind for every light and selects: lights of other kinds beside an image must not make it read
/// outside of the tables, nor change what the image gives.
TEST(ImageEnvironment, BesideOtherLights) {
    Scene description;
    auto pixels = std::make_shared<ImageData>();
    pixels->width = pixels->height = 2;
    pixels->channels = 1;
    pixels->floats = {1, 2, 3, 4};
    ImageFile file;
    file.pixels = pixels;
    description.images.push_back(file);
    for (int i = 0; i < 3; ++i) {
        Light l;
        if (i == 0) l.kind = PointLight{Spectrum::constant(1), {0, 0, 5}};
        else if (i == 1) l.kind = ConstantInfiniteLight{Spectrum::constant(1)};
        else l.kind = ImageInfiniteLight{0};
        description.lights.push_back(l);
    }
    Diagnostics diagnostics(LogLevel::silent);
    const PackedScene scene = packScene(description, diagnostics);
    for (const light& l : scene.tables.lights) EXPECT_GE(l.resolution, 1u) << "an index modulo nothing";
    Random random(51);
    const auto u = generate(4096, [&] { return random.unit(); });
    const auto v = generate(4096, [&] { return random.square(); });
    std::array<int, 3> seen{};
    for (const LightResult& r : sample(scene, {0, 0, 0}, u, v)) {
        ASSERT_LT(r.index, 3u);
        ++seen[r.index];
        ASSERT_TRUE(std::isfinite(r.pdf) && std::isfinite(r.L.r) && std::isfinite(r.Le.r));
        ASSERT_GT(r.pdf, 0);
    }
    for (int n : seen) EXPECT_GT(n, 0);
}

/// Beside a large image of another kind as well, which straight-line code must not take for its own.
TEST(ImageEnvironment, BesideLargerImages) {
    Scene description;
    for (int n : {2, 64}) {
        auto pixels = std::make_shared<ImageData>();
        pixels->width = pixels->height = n;
        pixels->floats.assign(static_cast<size_t>(n * n), 1);
        ImageFile file;
        file.pixels = pixels;
        description.images.push_back(file);
    }
    Light sky, slide, lamp, window;
    sky.kind = ImageInfiniteLight{0};
    slide.kind = ProjectionLight{1, 90};
    lamp.kind = GoniometricLight{Spectrum::constant(1), 1};
    window.kind = PortalInfiniteLight{Spectrum::constant(1), 1, {glm::dvec3{-1, -1, 2}, {-1, 1, 2}, {1, 1, 2}, {1, -1, 2}}};
    description.lights = {slide, sky, lamp, window};
    description.integrator.lightSampler = LightSampler::power;
    Diagnostics diagnostics(LogLevel::silent);
    const PackedScene scene = packScene(description, diagnostics);
    Random random(52);
    const auto u = generate(4096, [&] { return random.unit(); });
    const auto v = generate(4096, [&] { return random.square(); });
    for (const LightResult& r : sample(scene, {0, 0, -1}, u, v)) ASSERT_TRUE(std::isfinite(r.pdf) && std::isfinite(r.L.r) && std::isfinite(r.Le.r) && std::isfinite(r.pdfEnvironment));
}

/// The equal-area mapping on the device is the host's, both ways, to a millionth.
TEST(ImageEnvironment, MappingIsTheHosts) {
    struct Mapped { vec2 square; vec3 sphere; };
    const DeviceFunction<Mapped> function({.include = "light/light.clh", .type = "mapped",
        .body = "result.square = equal_area_square(d); result.sphere = equal_area_sphere(s);", .inputs = {"vec3 d", "vec2 s"},
        .declarations = "typedef struct { vec2 square; vec3 sphere; } mapped;"});
    Random random(48);
    std::vector<vec3> d{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0.6f, 0.8f, 0}};
    std::vector<vec2> s{{0.5f, 0.5f}, {0, 0}, {1, 1}, {0, 0.5f}, {0.5f, 0}, {0.25f, 0.25f}, {1, 0.5f}};
    while (d.size() < 20000) { d.push_back(random.direction()); s.push_back(random.square()); }
    const auto mapped = function(d, s);
    for (size_t i = 0; i < d.size(); ++i) {
        const glm::dvec3 sphere = directionFromSquare({s[i].x, s[i].y});
        ASSERT_LT(glm::length(toGlm(mapped[i].sphere) - sphere), 2e-6) << s[i].x << " " << s[i].y;
        /* The far pole is at all four corners, and opposite points of the edge are one direction */
        const glm::dvec3 back = directionFromSquare({std::clamp<double>(mapped[i].square.x, 0, 1), std::clamp<double>(mapped[i].square.y, 0, 1)});
        ASSERT_LT(glm::length(back - glm::normalize(toGlm(d[i]))), 4e-4) << d[i].x << " " << d[i].y << " " << d[i].z;
        if (std::abs(d[i].z) < 0.999f && d[i].z > -0.9f) {
            const glm::dvec2 square = squareFromDirection(toGlm(d[i]));
            const double near = std::min({std::abs(d[i].x), std::abs(d[i].y), std::abs(d[i].z)});
            if (near > 1e-3) { ASSERT_LT(std::max(std::abs(square.x - mapped[i].square.x), std::abs(square.y - mapped[i].square.y)), 2e-6) << d[i].x << " " << d[i].y << " " << d[i].z; }
        }
    }
}

// ---- the light sampler --------------------------------------------------------------------------------------------------

/// Lights are taken as often as their probability; a sample's density has the probability of its light as a factor.
TEST(LightSampler, TakesLightsByTheirProbability) {
    PackedScene scene;
    const std::vector<double> weights{1, 5, 0.01, 3, 0, 2, 0.5, 7};
    scene.tables.light_aliases = makeAliasTable(weights);
    for (size_t i = 0; i < weights.size(); ++i) {
        light l = newLight(kind_point_light);
        l.p = {static_cast<float>(i), 0, 0};
        l.pmf = scene.tables.light_aliases[i].pmf;
        scene.tables.lights.push_back(l);
    }
    scene.tables.frame.resize(1);
    Random random(49);
    const auto u = generate(100000, [&] { return random.unit(); });
    const auto results = sample(scene, {0.3f, 1, 1}, u, std::vector<vec2>(u.size(), {0.5f, 0.5f}));
    std::vector<double> counts(weights.size()), expected;
    for (double w : weights) expected.push_back(w / 18.51 * static_cast<double>(u.size()));
    for (const LightResult& r : results) {
        ASSERT_LT(r.index, weights.size());
        counts[r.index] += 1;
        ASSERT_NEAR(r.pdf, weights[r.index] / 18.51, 1e-6);
    }
    const ChiSquare chi = testChiSquare(counts, expected);
    EXPECT_GT(chi.probability, significance) << chi.describe();
    EXPECT_EQ(counts[4], 0);
}

/// What is left over of the number that chose is uniform again, whatever was chosen: it places a point in a texel.
TEST(LightSampler, LeavesAUniformRest) {
    struct Chosen { int i; float rest; };
    PackedScene scene;
    scene.tables.light_aliases = makeAliasTable({0.3, 4, 1, 0.7});
    scene.tables.frame.resize(1);
    const DeviceScene onDevice(testContext(), scene);
    const DeviceFunction<Chosen> function({.include = "light/light.clh", .type = "alias_sample", .body = "result = sample_alias(light_aliases, 4, u);",
                                           .inputs = {"float u"}, .tables = "LIGHT_ARGUMENTS"});
    Random random(50);
    const auto u = generate(100000, [&] { return random.unit(); });
    std::vector<double> counts(4 * 16), expected;
    for (double w : {0.3, 4.0, 1.0, 0.7}) expected.insert(expected.end(), 16, w / 6 / 16 * 100000);
    for (const Chosen& c : function.with(onDevice, u)) {
        ASSERT_GE(c.rest, 0);
        ASSERT_LT(c.rest, 1);
        counts[static_cast<size_t>(c.i) * 16 + static_cast<size_t>(c.rest * 16)] += 1;
    }
    const ChiSquare chi = testChiSquare(counts, expected);
    EXPECT_GT(chi.probability, significance) << chi.describe();
}

/// Every kind of the list is in one of the tests above.
TEST(LightList, IsCovered) {
    const std::set<std::string> tested{"point_light", "spot_light", "distant_light", "triangle_light", "bilinear_light", "sphere_light", "disk_light", "cylinder_light",
                                       "constant_environment", "image_environment",
                                       "goniometric_light", "projection_light", "portal_environment" /* image_light_test.cpp */};
#define EXPECT_TESTED(name, FEATURE) EXPECT_TRUE(tested.count(#name)) << "no test knows what a " #name " should give: add one here";
    LIGHTS(EXPECT_TESTED)
#undef EXPECT_TESTED
}

}  // namespace
}  // namespace eikonal
