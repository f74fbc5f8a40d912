// Textures against double precision: all kinds but images (imagemap_test.cpp) and noise (noise_test.cpp); mappings; bumps and normal maps.

#include "random_inputs.h"
#include "texture_values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace eikonal {
namespace {

/// scale, mix, sqrt, metal, invert and both checkerboards.
TEST(TextureProgram, ComputesWhatItSays) {
    Textures t;
    const auto op = [](texture_kind kind) { return Textures::instruction(kind); };
    const spectrum a{0.2f, 0.5f, 0.9f}, b{0.8f, 0.1f, 0.4f};
    t.program({t.constant(a), t.constant(b), op(kind_scale_texture)});
    t.program({t.constant(a), t.constant(b), t.constant({0.3f, 0.3f, 0.3f}), op(kind_mix_texture)});
    t.program({t.constant(a), op(kind_sqrt_texture)});
    t.program({t.constant(a), op(kind_metal_texture)});
    texture_instruction checks = op(kind_checkerboard_texture);
    checks.texture_from_scene.xx = 4; checks.texture_from_scene.yy = 2; checks.texture_from_scene.xw = 0.25f;
    t.program({t.constant(a), t.constant(b), checks});
    checks.mapping = mapping_point;
    checks.texture_from_scene = {3, 0, 0, 0.1f, 0, 3, 0, 0.2f, 0, 0, 3, 0.3f};
    t.program({t.constant(a), t.constant(b), checks});
    texture_instruction inverted = t.lookup(t.image(1, 1, 3, format_float, wrap_clamp, filter_nearest, {0.25f, 0.5f, 1}));
    inverted.flags = texture_invert;
    t.program({inverted});
    /* As deep as a stack may get */
    std::vector<texture_instruction> deep;
    for (int i = 0; i < TEXTURE_STACK; ++i) deep.push_back(t.constant({0.9f, 0.9f, 0.9f}));
    for (int i = 0; i < TEXTURE_STACK - 1; ++i) deep.push_back(op(kind_scale_texture));
    t.program(deep);

    Random random(82);
    std::vector<uint> program;
    std::vector<vec2> uv;
    std::vector<vec3> p;
    for (int i = 0; i < 8000; ++i) {
        program.push_back(static_cast<uint>(i % 8));
        uv.push_back({random.between(-2, 2), random.between(-2, 2)});
        p.push_back(random.box(2));
    }
    const auto results = evaluate(t.scene, program, uv, p);
    const auto floorOf = [](double x) { return static_cast<int>(std::floor(x)); };
    for (size_t i = 0; i < results.size(); ++i) {
        const double u = uv[i].x, v = uv[i].y;
        const auto same = [&](double r, double g, double blue) {
            EXPECT_NEAR(results[i].value.r, r, 2e-5) << "program " << program[i];
            EXPECT_NEAR(results[i].value.g, g, 2e-5) << "program " << program[i];
            EXPECT_NEAR(results[i].value.b, blue, 2e-5 * std::max(1.0, blue)) << "program " << program[i];
        };
        const auto metal = [](double r) { return 2 * std::sqrt(r / (1 - r)); };
        const int flat = floorOf(4 * u + 0.25) + floorOf(2 * v),
                  solid = floorOf(3 * p[i].x + 0.1) + floorOf(3 * p[i].y + 0.2) + floorOf(3 * p[i].z + 0.3);
        switch (program[i]) {
            case 0: same(0.16, 0.05, 0.36); break;
            case 1: same(0.7 * 0.2 + 0.3 * 0.8, 0.7 * 0.5 + 0.3 * 0.1, 0.7 * 0.9 + 0.3 * 0.4); break;
            case 2: same(std::sqrt(0.2), std::sqrt(0.5), std::sqrt(0.9)); break;
            case 3: same(metal(0.2), metal(0.5), metal(0.9)); break;
            case 4:
                if (std::abs(4 * u + 0.25 - std::round(4 * u + 0.25)) > 1e-5) { flat & 1 ? same(b.r, b.g, b.b) : same(a.r, a.g, a.b); }
                break;
            case 5: solid & 1 ? same(b.r, b.g, b.b) : same(a.r, a.g, a.b); break;
            case 6: same(0.75, 0.5, 0); break;
            case 7: same(std::pow(0.9, 8), std::pow(0.9, 8), std::pow(0.9, 8)); break;
        }
    }
}

/// Coordinates that fit no integer: floats of 2^24 and more are even, and an image goes on as its ends do.
TEST(TextureProgram, HasValuesFarAway) {
    Textures t;
    const spectrum a{1, 0, 0}, b{0, 1, 0};
    const auto image = [&](image_wrap wrap, image_filter filter) {
        return t.program({t.lookup(t.image(2, 1, 1, format_float, wrap, filter, {0.25f, 0.75f}))});
    };
    const uint checks = t.program({t.constant(a), t.constant(b), Textures::instruction(kind_checkerboard_texture)});
    const uint clamped = image(wrap_clamp, filter_bilinear), clampedNearest = image(wrap_clamp, filter_nearest);
    const uint black = image(wrap_black, filter_bilinear), blackNearest = image(wrap_black, filter_nearest);
    struct Case { uint program; vec2 uv; float red; };
    std::vector<Case> cases = {{checks, {8388609, 0}, 0}, {checks, {8388608, 0}, 1}, {checks, {-8388609, 0}, 0}};
    for (float far : {3e9f, 1e20f, 3e38f}) {
        for (uint image : {clamped, clampedNearest}) {
            cases.push_back({image, {far, -far}, 0.75f});
            cases.push_back({image, {-far, far}, 0.25f});
        }
        for (uint image : {black, blackNearest}) {
            cases.push_back({image, {far, 0.5f}, 0});
            cases.push_back({image, {0.5f, -far}, 0});
        }
        cases.push_back({checks, {far, -far}, 1});
    }
    std::vector<uint> program;
    std::vector<vec2> uv;
    for (const Case& c : cases) program.push_back(c.program), uv.push_back(c.uv);
    const auto results = evaluate(t.scene, program, uv, std::vector<vec3>(uv.size()));
    for (size_t i = 0; i < cases.size(); ++i) EXPECT_EQ(results[i].value.r, cases[i].red) << "program " << program[i] << " at " << uv[i].x;
}

/// bilerp beyond the unit square, directionmix over the plane z = 0, and what is brought into [0, 1].
TEST(TextureProgram, BlendsAndClamps) {
    Textures t;
    const spectrum v00{0.8f, 0, 0.1f}, v01{0, 0.8f, 0.2f}, v10{0, 0.4f, 0.8f}, v11{0.8f, 0.6f, 0};
    texture_instruction bilerp = Textures::instruction(kind_bilerp_texture);
    t.program({t.constant(v00), t.constant(v01), t.constant(v10), t.constant(v11), bilerp});
    texture_instruction across = Textures::instruction(kind_directionmix_texture);
    across.direction = {0.8f, 0, -0.6f};
    t.program({t.constant(v00), t.constant(v01), across});
    t.program({t.constant({-0.5f, 0.5f, 2}), Textures::instruction(kind_clamp_texture)});
    Random random(85);
    const auto uv = generate(600, [&] { return vec2{random.between(-1, 2), random.between(-1, 2)}; });
    std::vector<uint> program;
    for (uint i = 0; i < uv.size(); ++i) program.push_back(i % 3);
    const auto results = evaluate(t.scene, program, uv, std::vector<vec3>(uv.size()));
    for (size_t i = 0; i < results.size(); ++i) {
        const double s = uv[i].x, v = uv[i].y;
        const auto between = [&](float a, float b, float c, float d) {
            return (1 - s) * (1 - v) * a + (1 - s) * v * b + s * (1 - v) * c + s * v * d;
        };
        const spectrum got = results[i].value;
        const spectrum expected = program[i] == 0   ? spectrum{static_cast<float>(between(v00.r, v01.r, v10.r, v11.r)),
                                                             static_cast<float>(between(v00.g, v01.g, v10.g, v11.g)),
                                                             static_cast<float>(between(v00.b, v01.b, v10.b, v11.b))}
                                  : program[i] == 1 ? spectrum{0.6f * v00.r, 0.4f * v01.g, 0.6f * v00.b + 0.4f * v01.b}
                                                    : spectrum{0, 0.5f, 1};
        ASSERT_NEAR(got.r, expected.r, 1e-5) << "program " << program[i];
        ASSERT_NEAR(got.g, expected.g, 1e-5) << "program " << program[i];
        ASSERT_NEAR(got.b, expected.b, 1e-5) << "program " << program[i];
    }
}

/// pbrt-v4's dots cover 14.44 % of the square from (0.03, 0.07) to (39.93, 39.97), sampled every 0.1.
TEST(TextureProgram, DotsAreWherePbrtHasThem) {
    Textures t;
    t.program({t.constant({1, 0, 0}), t.constant({0, 1, 0}), Textures::instruction(kind_dots_texture)});
    std::vector<vec2> uv;
    for (int i = 0; i < 160000; ++i) uv.push_back({static_cast<float>(i / 400) * 0.1f + 0.03f, static_cast<float>(i % 400) * 0.1f + 0.07f});
    double covered = 0;
    for (const TextureResult& r : evaluate(t.scene, std::vector<uint>(uv.size(), 0), uv, std::vector<vec3>(uv.size()))) {
        ASSERT_EQ(r.value.r + r.value.g, 1);
        covered += r.value.r;
    }
    EXPECT_NEAR(covered / 160000, 0.1444, 2e-4);
}

/// Spherical, cylindrical and planar coordinates, seen through an image whose texels are their own coordinates.
TEST(TextureMapping, FindsItsCoordinates) {
    Textures t;
    constexpr uint n = 64;
    std::vector<float> ramp;
    for (uint y = 0; y < n; ++y)
        for (uint x = 0; x < n; ++x)
            for (float c : {(static_cast<float>(x) + 0.5f) / n, 1 - (static_cast<float>(y) + 0.5f) / n, 0.0f}) ramp.push_back(c);
    const uint image = t.image(n, n, 3, format_float, wrap_clamp, filter_bilinear, ramp);
    for (texture_mapping mapping : {mapping_spherical, mapping_cylindrical, mapping_planar}) {
        texture_instruction i = t.lookup(image);
        i.mapping = mapping;
        t.program({i});
    }
    Random random(83);
    std::vector<uint> program;
    std::vector<vec3> p;
    for (int i = 0; i < 6000; ++i) { program.push_back(static_cast<uint>(i % 3)); p.push_back(random.box(1)); }
    const auto results = evaluate(t.scene, program, std::vector<vec2>(p.size()), p);
    for (size_t i = 0; i < results.size(); ++i) {
        const double x = p[i].x, y = p[i].y, z = p[i].z, phi = std::atan2(y, x), turn = (phi < 0 ? phi + 2 * M_PI : phi) / (2 * M_PI);
        const double s = program[i] == 0   ? std::acos(z / std::sqrt(x * x + y * y + z * z)) / M_PI
                         : program[i] == 1 ? phi / (2 * M_PI) + 0.5
                                           : x;
        const double v = program[i] == 0 ? turn : program[i] == 1 ? z : y;
        const double low = 0.5 / n, high = 1 - low;
        ASSERT_NEAR(results[i].value.r, std::clamp(s, low, high), 1e-4) << "mapping " << program[i];
        ASSERT_NEAR(results[i].value.g, std::clamp(v, low, high), 1e-4) << "mapping " << program[i];
    }
}

/// Stripes of texels, up and down, four to a step of 0.0005: slopes are those between texels where the step is half a texel. And noise
/// whose waves are shorter than what 0.0005 of (u, v) are in space.
TEST(Relief, KeepsDetailsSmallerThanTheUsualStep) {
    Textures t;
    t.image(1, 1, 3, format_float, wrap_clamp, filter_nearest, {0.5f, 0.5f, 1.0f});
    constexpr uint n = 8192;
    const double height = 1e-4, slope = height * n;
    std::vector<float> stripes;
    for (uint x = 0; x < n; ++x) stripes.push_back(x % 2 ? static_cast<float>(height) : 0.0f);
    t.program({t.lookup(t.image(n, 1, 1, format_float, wrap_repeat, filter_bilinear, stripes))}, 0.5f / n);
    texture_instruction noise = Textures::instruction(kind_fbm_texture);
    noise.octaves = 1;
    constexpr float frequency = 4096;
    noise.texture_from_scene.xx = noise.texture_from_scene.yy = noise.texture_from_scene.zz = frequency;
    t.program({noise}, 0.0005f, 0.125f / frequency);
    Random random(85);
    const auto uv = generate(2000, [&] { return vec2{random.between(0.1f, 0.9f), 0.5f}; });
    const auto points = generate(2000, [&] { return random.box(1); });
    std::vector<uint> program(uv.size(), 0);
    int steep = 0;
    for (const TextureResult& r : evaluate(t.scene, program, uv, points))
        steep += std::abs(std::abs(r.bumped.x / r.bumped.z) * 2 / slope - 1) < 0.05;
    /* A step from one side of a texel's middle to the other sees less */
    EXPECT_NEAR(steep, 1000, 100);
    /* The slope of a lattice's gradient noise is about 1 over a cell */
    double squares = 0;
    for (const TextureResult& r : evaluate(t.scene, std::vector<uint>(uv.size(), 1), uv, points))
        squares += std::pow(r.bumped.x / r.bumped.z * 2 / frequency, 2);
    EXPECT_GT(std::sqrt(squares / 2000), 0.3);
    EXPECT_LT(std::sqrt(squares / 2000), 3);
}

/// Adds program 0: a displacement that rises by `u` along u and by `v` along v.
void addSlope(Textures& t, double u, double v) {
    constexpr uint n = 16;
    std::vector<float> heights;
    for (uint y = 0; y < n; ++y)
        for (uint x = 0; x < n; ++x) heights.push_back(static_cast<float>(u * (x + 0.5) / n + v * (1 - (y + 0.5) / n)));
    t.program({t.lookup(t.image(n, n, 1, format_float, wrap_clamp, filter_bilinear, heights))});
}

/// Over the plane with dpdu = 2 x and dpdv = 3 y, a displacement that rises by a in u and b in v turns the normal to
/// (dpdu + a n) x (dpdv + b n) = (-3 a, -2 b, 6); a normal map says the normal in the frame along dpdu.
TEST(Relief, TurnsNormals) {
    Textures t;
    t.image(1, 1, 3, format_float, wrap_clamp, filter_nearest, {0.5f + 0.5f * 0.6f, 0.5f, 0.5f + 0.5f * 0.8f});
    const double a = 0.8, b = -0.5;
    addSlope(t, a, b);
    Random random(84);
    const auto uv = generate(500, [&] { return vec2{random.between(0.1f, 0.9f), random.between(0.1f, 0.9f)}; });
    const double length = std::sqrt(9 * a * a + 4 * b * b + 36);
    for (const TextureResult& r : evaluate(t.scene, std::vector<uint>(uv.size(), 0), uv, std::vector<vec3>(uv.size()))) {
        /* A difference over a step of 0.0005 leaves four digits */
        ASSERT_NEAR(r.bumped.x, -3 * a / length, 1e-3);
        ASSERT_NEAR(r.bumped.y, -2 * b / length, 1e-3);
        ASSERT_NEAR(r.bumped.z, 6 / length, 1e-3);
        ASSERT_NEAR(r.mapped.x, 0.6, 1e-5);
        ASSERT_NEAR(r.mapped.y, 0, 1e-5);
        ASSERT_NEAR(r.mapped.z, 0.8, 1e-5);
    }
}

/// Where the normal is interpolated (`leaning`: n = (0.6, 0, 0.8) over the same plane), the derivatives are those of the smooth surface,
/// perpendicular to n. So a displacement without slopes gives n back.
TEST(Relief, KeepsInterpolatedNormals) {
    const glm::dvec3 n(0.6, 0, 0.8), u = glm::dvec3(2, 0, 0) - 1.2 * n, v(0, 3, 0);
    for (const glm::dvec2& slope : {glm::dvec2(0, 0), glm::dvec2(0.8, -0.5)}) {
        Textures t;
        t.image(1, 1, 3, format_float, wrap_clamp, filter_nearest, {0.5f, 0.5f, 1.0f});
        addSlope(t, slope.x, slope.y);
        const glm::dvec3 expected = glm::normalize(glm::cross(u + slope.x * n, v + slope.y * n));
        for (const TextureResult& r : evaluate(t.scene, {0}, {vec2{0.4f, 0.7f}}, {vec3{}})) {
            EXPECT_NEAR(r.leaning.x, expected.x, 1e-3);
            EXPECT_NEAR(r.leaning.y, expected.y, 1e-3);
            EXPECT_NEAR(r.leaning.z, expected.z, 1e-3);
        }
    }
}

}  // namespace
}  // namespace eikonal
