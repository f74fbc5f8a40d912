// Textures of noise against what pbrt-v4 computes.

#include "random_inputs.h"
#include "texture_values.h"

#include <gtest/gtest.h>

#include <cmath>

namespace eikonal {
namespace {

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
    const std::vector<vec3> p{{0.5f, 0.25f, 0.75f},     {-3.3f, 7.9f, 12.6f},          {100.2f, -55.7f, 3.1f},
                              {255.5f, 255.75f, -0.4f}, {17.125f, -200.375f, 64.625f}, {-0.01f, 0.02f, -0.03f}};
    const double expected[] = {-0.3750786781311035,  -0.49674407678361576, 0.2907604656705517,
                               -0.45613892187500027, -0.18026559997770164, -0.04005991742216208};
    const auto values = evaluateSolid({solid(kind_fbm_texture, 1)}, p);
    for (size_t i = 0; i < p.size(); ++i) EXPECT_NEAR(values[i].g, expected[i], 2e-5) << i;

    const auto sums = evaluateSolid({solid(kind_fbm_texture, 8), solid(kind_fbm_texture, 3, 0.8f), solid(kind_wrinkled_texture, 8),
                                     solid(kind_windy_texture, 0), solid(kind_fbm_texture, 0)},
                                    {{0.7f, -1.3f, 2.2f}});
    const double sum[] = {-0.03889367715396539, -0.03474462060967182, 0.27048834280512046, -0.021699091825383918, 0};
    for (size_t i = 0; i < sums.size(); ++i) EXPECT_NEAR(sums[i].r, sum[i], 2e-5) << i;

    const auto marble = evaluateSolid({solid(kind_marble_texture, 8)}, {{0.7f, -1.3f, 2.2f}, {0.1f, 1.4f, 0.3f}, {3.1f, 4.2f, 1.1f}});
    const double red[] = {0.8698682202944114, 0.8652036747527256, 0.8615733043863156},
                 blue[] = {0.8998352753680143, 0.896592084692726, 0.8894666304828946};
    for (size_t i = 0; i < marble.size(); ++i) {
        EXPECT_NEAR(marble[i].r, red[i], 2e-5) << i;
        EXPECT_NEAR(marble[i].b, blue[i], 2e-5) << i;
    }
}

/// Zero at every lattice point, at most 1.04, the same 256 cells further on, and finite wherever a float may be.
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
        ASSERT_LE(std::abs(a[i].r), 1.04);
        ASSERT_LE(std::abs(b[i].r), 1.04);
        if (i < 500) { ASSERT_EQ(a[i].r, b[i].r); }
    }
}

}  // namespace
}  // namespace eikonal
