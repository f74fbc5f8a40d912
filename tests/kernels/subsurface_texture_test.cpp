// What textures of a body's coefficients are turned into, against the host's table in double precision.

#include "random_inputs.h"
#include "color/diffuse_albedo.h"
#include "texture_values.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

namespace eikonal {
namespace {

struct BodyCase { float sigmaA, sigmaS, g; size_t table; };

/// Programs that make an albedo and a free path of constants, case by case: 2 i and 2 i + 1.
Textures texturesOf(const std::vector<BodyCase>& cases, const std::vector<DiffuseAlbedoTable>& tables) {
    Textures t;
    for (const DiffuseAlbedoTable& table : tables)
        t.image(static_cast<uint>(table.albedos().size()), 1, 1, format_float, wrap_repeat, filter_bilinear,
                {table.albedos().begin(), table.albedos().end()});
    for (const BodyCase& c : cases) {
        texture_instruction albedo = Textures::instruction(kind_diffusealbedo_texture, c.g);
        albedo.image = static_cast<uint>(c.table);
        const texture_instruction a = Textures::constant({c.sigmaA, c.sigmaA, c.sigmaA}),
                                  s = Textures::constant({c.sigmaS, c.sigmaS, c.sigmaS});
        t.program({a, s, albedo});
        t.program({a, s, Textures::instruction(kind_freepath_texture, c.g)});
    }
    return t;
}

std::vector<std::pair<double, double>> albedosAndPaths(const std::vector<BodyCase>& cases, const std::vector<DiffuseAlbedoTable>& tables) {
    std::vector<uint> program;
    for (uint i = 0; i < 2 * cases.size(); ++i) program.push_back(i);
    const auto values =
        evaluate(texturesOf(cases, tables).scene, program, std::vector<vec2>(program.size()), std::vector<vec3>(program.size()));
    std::vector<std::pair<double, double>> results;
    for (size_t i = 0; i < cases.size(); ++i) results.emplace_back(values[2 * i].value.g, values[2 * i + 1].value.g);
    return results;
}

TEST(SubsurfaceTexture, IsTheHostsAlbedoAndFreePath) {
    const std::vector<DiffuseAlbedoTable> tables{{0, 1.33}, {-0.5f, 1}, {0.9f, 1.5}};
    constexpr float g[] = {0, -0.5f, 0.9f};
    Random random(86);
    std::vector<BodyCase> cases;
    for (size_t i = 0; i < 600; ++i) {
        const size_t table = i % 3;
        cases.push_back({std::exp(random.between(-9, 6)), std::exp(random.between(-6, 6)), g[table], table});
    }
    const auto results = albedosAndPaths(cases, tables);
    for (size_t i = 0; i < cases.size(); ++i) {
        const auto& [a, s, mean, table] = cases[i];
        const double sigmaA = a, sigmaS = s, path = 1 / (sigmaA + (1.0 - mean) * sigmaS);
        ASSERT_NEAR(results[i].first, tables[table].diffuse(sigmaS / (sigmaA + sigmaS)), 1e-5) << a << " " << s;
        ASSERT_NEAR(results[i].second, path, 1e-5 * path) << a << " " << s;
    }
}

/// What is empty or only absorbs gives nothing back, what only scatters gives all; and numbers that no coefficient has stay finite.
TEST(SubsurfaceTexture, KnowsItsEnds) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const std::vector<BodyCase> cases{{0, 0, 0.5f, 0},         {2, 0, 0.5f, 0},  {0, 2, 0.5f, 0},
                                      {-1, 2, 0.5f, 0},        {2, -1, 0.5f, 0}, {infinity, infinity, 0.5f, 0},
                                      {1e20f, 1e-20f, 0.5f, 0}};
    const std::vector<std::pair<double, double>> expected{
        {0, 1e9}, {0, 0.5}, {1, 1}, {1, 1}, {0, 0.5}, {DiffuseAlbedoTable(0.5, 1.33).diffuse(0.5), 0}, {0, 0}};
    const auto results = albedosAndPaths(cases, {DiffuseAlbedoTable(0.5, 1.33)});
    for (size_t i = 0; i < cases.size(); ++i) {
        EXPECT_NEAR(results[i].first, expected[i].first, 1e-6) << "case " << i;
        EXPECT_NEAR(results[i].second, expected[i].second, 1e-6 * (1 + expected[i].second)) << "case " << i;
    }
}

/// Images of coefficients hold what is larger than 1, and nothing below 0.
TEST(SubsurfaceTexture, ImagesOfCoefficientsHaveNoUpperBound) {
    Textures t;
    texture_instruction lookup = t.lookup(t.image(1, 1, 3, format_float, wrap_clamp, filter_nearest, {7, 0.25f, -3}));
    lookup.flags = texture_unbounded;
    lookup.value.scale = 2;
    t.program({lookup});
    const spectrum value = evaluate(t.scene, {0}, {{0.5f, 0.5f}}, std::vector<vec3>(1)).front().value;
    EXPECT_NEAR(value.r, 14, 1e-5);
    EXPECT_NEAR(value.g, 0.5, 1e-6);
    EXPECT_EQ(value.b, 0);
}

}  // namespace
}  // namespace eikonal
