// Light from infinitely far away, all around: samples follow what the environment looks like.

#include "kinds/integrator_kind.h"
#include "kinds/light_kind.h"
#include "light_sampling.h"
#include "pack/pack.h"
#include "random_inputs.h"
#include "image/equal_area.h"
#include "read/formats/image.h"
#include "statistics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace eikonal {
namespace {

TEST(ConstantEnvironment, IsUniformOverTheSphere) {
    Random random(45);
    const auto v = generate(65536, [&] { return random.square(); });
    std::vector<double> counts(256), expected(256, 256.0);
    for (const LightResult& r : sample(sceneOf(newLight(kind_uniform_infinite_light)), {0, 0, 0}, std::vector<float>(v.size(), 0.5f), v)) {
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
    l.kind = &kindOf(kind_image_infinite_light);
    l.image = 0;
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
    const Table<float>& texels = scene.tables.environment_texels;
    for (float channel : texels) total += channel;
    for (size_t i = 0; i < n * n; ++i)
        expected[i] = (texels[3 * i] + texels[3 * i + 1] + texels[3 * i + 2]) / total * static_cast<double>(v.size());
    Accumulator red;
    int elsewhere = 0;
    for (const LightResult& r : results) {
        const glm::dvec3 d(dot(r.wi, l.a), dot(r.wi, l.b), dot(r.wi, l.n));
        const glm::dvec2 square = squareFromDirection(d);
        const size_t x = std::min(static_cast<size_t>(square.x * n), size_t{n - 1}),
                     y = std::min(static_cast<size_t>(square.y * n), size_t{n - 1});
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
        l.spectrum = Spectrum::constant(1);
        l.kind = &kindOf(i == 0 ? kind_point_light : i == 1 ? kind_uniform_infinite_light : kind_image_infinite_light);
        if (i == 0) l.from = {0, 0, 5};
        if (i == 2) l.image = 0;
        description.lights.push_back(l);
    }
    description.integrator.kind = &simplepath_integrator;
    description.integrator.sampleBsdf = false;   /* so that all are sampled */
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
    sky.kind = &kindOf(kind_image_infinite_light);
    slide.kind = &kindOf(kind_projection_light);
    lamp.kind = &kindOf(kind_goniometric_light);
    window.kind = &kindOf(kind_portal_infinite_light);
    sky.image = 0;
    slide.image = lamp.image = window.image = 1;
    lamp.spectrum = window.spectrum = Spectrum::constant(1);
    window.portal = {glm::dvec3{-1, -1, 2}, {-1, 1, 2}, {1, 1, 2}, {1, -1, 2}};
    description.lights = {slide, sky, lamp, window};
    description.integrator.lightSampler = LightSampler::power;
    Diagnostics diagnostics(LogLevel::silent);
    const PackedScene scene = packScene(description, diagnostics);
    Random random(52);
    const auto u = generate(4096, [&] { return random.unit(); });
    const auto v = generate(4096, [&] { return random.square(); });
    for (const LightResult& r : sample(scene, {0, 0, -1}, u, v))
        ASSERT_TRUE(std::isfinite(r.pdf) && std::isfinite(r.L.r) && std::isfinite(r.Le.r) && std::isfinite(r.pdfEnvironment));
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
        const glm::dvec3 back =
            directionFromSquare({std::clamp<double>(mapped[i].square.x, 0, 1), std::clamp<double>(mapped[i].square.y, 0, 1)});
        ASSERT_LT(glm::length(back - glm::normalize(toGlm(d[i]))), 4e-4) << d[i].x << " " << d[i].y << " " << d[i].z;
        if (std::abs(d[i].z) < 0.999f && d[i].z > -0.9f) {
            const glm::dvec2 square = squareFromDirection(toGlm(d[i]));
            const double near = std::min({std::abs(d[i].x), std::abs(d[i].y), std::abs(d[i].z)});
            if (near > 1e-3) {
                ASSERT_LT(std::max(std::abs(square.x - mapped[i].square.x), std::abs(square.y - mapped[i].square.y)), 2e-6)
                    << d[i].x << " " << d[i].y << " " << d[i].z;
            }
        }
    }
}

}  // namespace
}  // namespace eikonal
