// Textures against double precision: images in every format, wrap and filter; the other kinds; mappings; bumps and normal maps.

#include "device_function.h"
#include "pack/colors.h"
#include "random_inputs.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace eikonal {
namespace {

struct TextureResult { spectrum value; vec3 bumped, mapped; };

/// Values of programs at points: program[i] at uv[i], p[i]; and the plane z = 0 with dpdu = 2 x, dpdv = 3 y bumped by the program,
/// and turned by the normal map in image 0.
std::vector<TextureResult> evaluate(const PackedScene& scene, const std::vector<uint>& program, const std::vector<vec2>& uv, const std::vector<vec3>& p) {
    static const DeviceFunction<TextureResult> function({.include = "texture/relief.clh", .type = "texture_result", .body = R"(
        texture_tables tables = BIND_TEXTURES;
        color_tables colors = BIND_COLORS;
        surface at;
        at.p = p; at.uv = uv;
        at.error = at.dndu = at.dndv = make_vec3(0.0f, 0.0f, 0.0f);
        at.ng = at.ns = make_vec3(0.0f, 0.0f, 1.0f);
        at.dpdu = make_vec3(2.0f, 0.0f, 0.0f);
        at.dpdv = make_vec3(0.0f, 3.0f, 0.0f);
        result.value = eval_texture(tables, path_palette(colors, 0u, 0u), program, at);
        result.bumped = displace_normal(tables, program, at).ns;
        result.mapped = map_normal(tables, 0u, at).ns;)",
        .inputs = {"uint program", "vec2 uv", "vec3 p"}, .declarations = "typedef struct { spectrum value; vec3 bumped, mapped; } texture_result;", .tables = "TEXTURE_ARGUMENTS COLOR_ARGUMENTS"});
    const DeviceScene onDevice(testContext(), scene);
    return function.with(onDevice, program, uv, p);
}

/// Tables of textures, filled by hand.
struct Textures {
    PackedScene scene;
    Textures() { scene.tables.frame.resize(1); }

    uint program(std::vector<texture_instruction> code) {
        SceneTables& t = scene.tables;
        t.programs.push_back({static_cast<uint>(t.instructions.size()), static_cast<uint>(code.size())});
        t.instructions.insert(t.instructions.end(), code.begin(), code.end());
        return static_cast<uint>(t.programs.size() - 1);
    }
    static texture_instruction instruction(texture_kind kind, float value = 1) {
        texture_instruction i{};
        i.kind = kind;
        i.mapping = mapping_uv;
        i.image = NONE;
        i.value = packNumber(value);
        i.texture_from_scene.xx = i.texture_from_scene.yy = i.texture_from_scene.zz = 1;
        return i;
    }
    static texture_instruction constant(spectrum s) { texture_instruction i = instruction(kind_constant_texture); i.value = packRgb({s.r, s.g, s.b}); return i; }
    texture_instruction lookup(uint image) { texture_instruction i = instruction(kind_imagemap_texture); i.image = image; return i; }

    /// An image of given texels (in [0, 1]; 8-bit formats keep 255 levels), channels interleaved.
    uint image(uint width, uint height, uint channels, image_format format, image_wrap wrap, image_filter filter, const std::vector<float>& texels) {
        eikonal::image im{width, height, channels, static_cast<uint>(format), static_cast<uint>(wrap), static_cast<uint>(filter), 0};
        SceneTables& t = scene.tables;
        if (format == format_float) {
            im.first = static_cast<uint>(t.float_texels.size());
            t.float_texels.insert(t.float_texels.end(), texels.begin(), texels.end());
        } else {
            im.first = static_cast<uint>(t.byte_texels.size() * 4);
            t.byte_texels.resize(t.byte_texels.size() + (texels.size() + 3) / 4);
            for (size_t i = 0; i < texels.size(); ++i) t.byte_texels[im.first / 4 + i / 4] |= static_cast<uint>(std::lround(texels[i] * 255)) << (8 * (i % 4));
        }
        t.srgb_levels = srgbLevels();
        t.images.push_back(im);
        return static_cast<uint>(t.images.size() - 1);
    }
};

double decode(double x) { return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); }

struct ImageCase { uint width, height, channels; image_format format; image_wrap wrap; image_filter filter; std::vector<float> texels; };

double texelOf(const ImageCase& c, int x, int y, uint channel) {
    const int w = static_cast<int>(c.width), h = static_cast<int>(c.height);
    if (c.wrap == wrap_black && (x < 0 || y < 0 || x >= w || y >= h)) return 0;
    if (c.wrap == wrap_clamp) { x = std::clamp(x, 0, w - 1); y = std::clamp(y, 0, h - 1); }
    x = ((x % w) + w) % w; y = ((y % h) + h) % h;
    const float t = c.texels[static_cast<size_t>(y * w + x) * c.channels + (c.channels == 1 ? 0 : channel)];
    const double stored = c.format == format_float ? static_cast<double>(t) : std::lround(t * 255) / 255.0;
    return c.format == format_srgb8 ? decode(stored) : stored;
}

/// (s, t) = (0, 0) is the lower left corner; texel centres lie at half-integers.
double lookUp(const ImageCase& c, double s, double t, uint channel) {
    double x = s * c.width, y = (1 - t) * c.height;
    if (c.filter == filter_nearest) return texelOf(c, static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y)), channel);
    x -= 0.5; y -= 0.5;
    const int ix = static_cast<int>(std::floor(x)), iy = static_cast<int>(std::floor(y));
    const double fx = x - ix, fy = y - iy;
    return (1 - fy) * ((1 - fx) * texelOf(c, ix, iy, channel) + fx * texelOf(c, ix + 1, iy, channel)) +
           fy * ((1 - fx) * texelOf(c, ix, iy + 1, channel) + fx * texelOf(c, ix + 1, iy + 1, channel));
}

/// Every format, number of channels, wrap mode and filter, well inside of the image and far outside.
TEST(Imagemap, IsWhatTheImageSays) {
    Textures textures;
    Random random(80);
    std::vector<ImageCase> cases;
    for (image_format format : {format_srgb8, format_linear8, format_float})
        for (uint channels : {1u, 3u, 4u})
            for (image_wrap wrap : {wrap_repeat, wrap_black, wrap_clamp})
                for (image_filter filter : {filter_nearest, filter_bilinear}) {
                    ImageCase c{5, 3, channels, format, wrap, filter, generate(15 * channels, [&] { return random.unit(); })};
                    textures.program({textures.lookup(textures.image(c.width, c.height, channels, format, wrap, filter, c.texels))});
                    cases.push_back(c);
                }
    std::vector<uint> program;
    std::vector<vec2> uv;
    for (uint k = 0; k < cases.size(); ++k)
        for (int i = 0; i < 400; ++i) {
            program.push_back(k);
            uv.push_back(i % 4 ? random.square() : vec2{random.between(-3, 3), random.between(-3, 3)});
        }
    const auto results = evaluate(textures.scene, program, uv, std::vector<vec3>(uv.size()));
    for (size_t i = 0; i < results.size(); ++i) {
        const ImageCase& c = cases[program[i]];
        const double x = static_cast<double>(uv[i].x) * c.width, y = (1 - static_cast<double>(uv[i].y)) * c.height;
        if (c.filter == filter_nearest && (std::abs(x - std::round(x)) < 1e-5 || std::abs(y - std::round(y)) < 1e-5)) continue;
        const float got[3] = {results[i].value.r, results[i].value.g, results[i].value.b};
        for (uint channel = 0; channel < 3; ++channel)
            ASSERT_NEAR(got[channel], lookUp(c, uv[i].x, uv[i].y, channel), 2e-5) << "format " << c.format << " channels " << c.channels << " wrap " << c.wrap << " filter "
                                                                                  << c.filter << " at " << uv[i].x << " " << uv[i].y;
    }
}

/// The octahedral wrap folds each edge onto itself: just outside of it lies what is just inside, mirrored along the edge.
TEST(Imagemap, OctahedralEdgesFoldOntoThemselves) {
    Textures textures;
    Random random(81);
    textures.program({textures.lookup(textures.image(8, 8, 3, format_float, wrap_octahedral, filter_bilinear, generate(8 * 8 * 3, [&] { return random.unit(); })))});
    std::vector<vec2> out, in;
    for (int i = 0; i < 500; ++i) {
        const float s = random.between(0.1f, 0.9f), e = random.between(0, 0.06f);
        const std::array<std::pair<vec2, vec2>, 4> edges{{{{s, -e}, {1 - s, e}}, {{s, 1 + e}, {1 - s, 1 - e}}, {{-e, s}, {e, 1 - s}}, {{1 + e, s}, {1 - e, 1 - s}}}};
        out.push_back(edges[static_cast<size_t>(i % 4)].first);
        in.push_back(edges[static_cast<size_t>(i % 4)].second);
    }
    const std::vector<uint> program(out.size(), 0);
    const std::vector<vec3> p(out.size());
    const auto a = evaluate(textures.scene, program, out, p), b = evaluate(textures.scene, program, in, p);
    for (size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(a[i].value.g, b[i].value.g, 1e-5) << out[i].x << " " << out[i].y;
}

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
        const int flat = floorOf(4 * u + 0.25) + floorOf(2 * v), solid = floorOf(3 * p[i].x + 0.1) + floorOf(3 * p[i].y + 0.2) + floorOf(3 * p[i].z + 0.3);
        switch (program[i]) {
            case 0: same(0.16, 0.05, 0.36); break;
            case 1: same(0.7 * 0.2 + 0.3 * 0.8, 0.7 * 0.5 + 0.3 * 0.1, 0.7 * 0.9 + 0.3 * 0.4); break;
            case 2: same(std::sqrt(0.2), std::sqrt(0.5), std::sqrt(0.9)); break;
            case 3: same(metal(0.2), metal(0.5), metal(0.9)); break;
            case 4: if (std::abs(4 * u + 0.25 - std::round(4 * u + 0.25)) > 1e-5) { flat & 1 ? same(b.r, b.g, b.b) : same(a.r, a.g, a.b); } break;
            case 5: solid & 1 ? same(b.r, b.g, b.b) : same(a.r, a.g, a.b); break;
            case 6: same(0.75, 0.5, 0); break;
            case 7: same(std::pow(0.9, 8), std::pow(0.9, 8), std::pow(0.9, 8)); break;
        }
    }
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
        const auto between = [&](float a, float b, float c, float d) { return (1 - s) * (1 - v) * a + (1 - s) * v * b + s * (1 - v) * c + s * v * d; };
        const spectrum got = results[i].value;
        const spectrum expected = program[i] == 0 ? spectrum{static_cast<float>(between(v00.r, v01.r, v10.r, v11.r)), static_cast<float>(between(v00.g, v01.g, v10.g, v11.g)),
                                                             static_cast<float>(between(v00.b, v01.b, v10.b, v11.b))}
                                  : program[i] == 1 ? spectrum{0.6f * v00.r, 0.4f * v01.g, 0.6f * v00.b + 0.4f * v01.b} : spectrum{0, 0.5f, 1};
        ASSERT_NEAR(got.r, expected.r, 1e-5) << "program " << program[i];
        ASSERT_NEAR(got.g, expected.g, 1e-5) << "program " << program[i];
        ASSERT_NEAR(got.b, expected.b, 1e-5) << "program " << program[i];
    }
}

/// Values of fbm of one octave, which is the noise itself, of each program at each point.
std::vector<spectrum> evaluateSolid(const std::vector<texture_instruction>& kinds, const std::vector<vec3>& points) {
    Textures t;
    for (const texture_instruction& kind : kinds) t.program({kind});
    std::vector<uint> program;
    std::vector<vec3> p;
    for (const vec3& point : points)
        for (uint k = 0; k < kinds.size(); ++k) { program.push_back(k); p.push_back(point); }
    std::vector<spectrum> values;
    for (const TextureResult& r : evaluate(t.scene, program, std::vector<vec2>(p.size()), p)) values.push_back(r.value);
    return values;
}
texture_instruction solid(texture_kind kind, uint octaves, float roughness = 0.5f) {
    texture_instruction i = Textures::instruction(kind);
    i.octaves = octaves;
    i.roughness = roughness;
    i.variation = 0.2f;
    return i;
}

/// Numbers from pbrt-v4's formulas in double precision (util/noise.cpp, textures.cpp), with every octave.
TEST(Noise, IsThatOfPbrt) {
    const std::vector<vec3> p{{0.5f, 0.25f, 0.75f}, {-3.3f, 7.9f, 12.6f}, {100.2f, -55.7f, 3.1f}, {255.5f, 255.75f, -0.4f}, {17.125f, -200.375f, 64.625f}, {-0.01f, 0.02f, -0.03f}};
    const double expected[] = {-0.3750786781311035, -0.49674407678361576, 0.2907604656705517, -0.45613892187500027, -0.18026559997770164, -0.04005991742216208};
    const auto values = evaluateSolid({solid(kind_fbm_texture, 1)}, p);
    for (size_t i = 0; i < p.size(); ++i) EXPECT_NEAR(values[i].g, expected[i], 2e-5) << i;

    const auto sums = evaluateSolid({solid(kind_fbm_texture, 8), solid(kind_fbm_texture, 3, 0.8f), solid(kind_wrinkled_texture, 8), solid(kind_windy_texture, 0), solid(kind_fbm_texture, 0)},
                                    {{0.7f, -1.3f, 2.2f}});
    const double sum[] = {-0.03889367715396539, -0.03474462060967182, 0.27048834280512046, -0.021699091825383918, 0};
    for (size_t i = 0; i < sums.size(); ++i) EXPECT_NEAR(sums[i].r, sum[i], 2e-5) << i;

    const auto marble = evaluateSolid({solid(kind_marble_texture, 8)}, {{0.7f, -1.3f, 2.2f}, {0.1f, 1.4f, 0.3f}, {3.1f, 4.2f, 1.1f}});
    const double red[] = {0.8698682202944114, 0.8652036747527256, 0.8615733043863156}, blue[] = {0.8998352753680143, 0.896592084692726, 0.8894666304828946};
    for (size_t i = 0; i < marble.size(); ++i) {
        EXPECT_NEAR(marble[i].r, red[i], 2e-5) << i;
        EXPECT_NEAR(marble[i].b, blue[i], 2e-5) << i;
    }
}

/// Zero at every lattice point, never above 1, the same 256 cells further on, and finite wherever a float may be.
TEST(Noise, IsBoundedAndRepeats) {
    Random random(86);
    std::vector<vec3> lattice, near, far;
    for (int i = 0; i < 500; ++i) {
        const auto whole = [&] { return std::floor(random.between(-300, 300)); };
        lattice.push_back({whole(), whole(), whole()});
        /* Multiples of 1/16: adding 256 rounds nothing */
        const auto part = [&] { return std::floor(random.between(-2000, 2000)) / 16; };
        near.push_back({part(), part(), part()});
        far.push_back({near.back().x + 256, near.back().y - 512, near.back().z + 1024});
    }
    for (float x : {1e10f, -3e20f, 1e30f, -1e37f}) far.push_back({x, -x, x * 0.7f});
    near.insert(near.end(), 4, {0, 0, 0});
    const std::vector<texture_instruction> noise{solid(kind_fbm_texture, 1)};
    for (const spectrum& value : evaluateSolid(noise, lattice)) ASSERT_NEAR(value.r, 0, 1e-6);
    const auto a = evaluateSolid(noise, near), b = evaluateSolid(noise, far);
    for (size_t i = 0; i < a.size(); ++i) {
        ASSERT_LE(std::abs(a[i].r), 1);
        ASSERT_LE(std::abs(b[i].r), 1);
        if (i < 500) { ASSERT_EQ(a[i].r, b[i].r); }
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
        for (uint x = 0; x < n; ++x) for (float c : {(static_cast<float>(x) + 0.5f) / n, 1 - (static_cast<float>(y) + 0.5f) / n, 0.0f}) ramp.push_back(c);
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
        const double s = program[i] == 0 ? std::acos(z / std::sqrt(x * x + y * y + z * z)) / M_PI : program[i] == 1 ? phi / (2 * M_PI) + 0.5 : x;
        const double v = program[i] == 0 ? turn : program[i] == 1 ? z : y;
        const double low = 0.5 / n, high = 1 - low;
        ASSERT_NEAR(results[i].value.r, std::clamp(s, low, high), 1e-4) << "mapping " << program[i];
        ASSERT_NEAR(results[i].value.g, std::clamp(v, low, high), 1e-4) << "mapping " << program[i];
    }
}

/// Over the plane with dpdu = 2 x and dpdv = 3 y, a displacement that rises by a in u and b in v turns the normal to
/// (dpdu + a n) x (dpdv + b n) = (-3 a, -2 b, 6); a normal map says the normal in the frame along dpdu.
TEST(Relief, TurnsNormals) {
    Textures t;
    t.image(1, 1, 3, format_float, wrap_clamp, filter_nearest, {0.5f + 0.5f * 0.6f, 0.5f, 0.5f + 0.5f * 0.8f});
    constexpr uint n = 16;
    const double a = 0.8, b = -0.5;
    std::vector<float> slope;
    for (uint y = 0; y < n; ++y)
        for (uint x = 0; x < n; ++x) slope.push_back(static_cast<float>(a * (x + 0.5) / n + b * (1 - (y + 0.5) / n)));
    t.program({t.lookup(t.image(n, n, 1, format_float, wrap_clamp, filter_bilinear, slope))});
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

}  // namespace
}  // namespace eikonal
