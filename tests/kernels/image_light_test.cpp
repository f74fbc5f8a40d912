// Lights whose directions are an image's texels: goniometric and projection lights.

#include "device_function.h"
#include "pack/pack.h"
#include "pack/packer.h"
#include "random_inputs.h"
#include "scene/equal_area.h"
#include "statistics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace eikonal {
namespace {

glm::dvec3 toGlm(vec3 v) { return {v.x, v.y, v.z}; }

/// An image of very different texels, none of them black.
ImageFile imageFile(int width, int height) {
    auto pixels = std::make_shared<ImageData>();
    pixels->width = width;
    pixels->height = height;
    pixels->channels = 3;
    Random random(61);
    for (int i = 0; i < width * height * 3; ++i) pixels->floats.push_back(random.logBetween(0.01f, 10));
    ImageFile file;
    file.pixels = pixels;
    return file;
}

/// One light with one image.
PackedScene packLight(const Light& l, int width, int height) {
    Scene scene;
    scene.images.push_back(imageFile(width, height));
    scene.lights.push_back(l);
    Diagnostics diagnostics(LogLevel::silent);
    return packScene(scene, diagnostics);
}

struct ImageLightResult { spectrum L; vec3 wi; float pdf; int isDelta; };

/// A sample of light 0 at p.
std::vector<ImageLightResult> sample(const PackedScene& scene, const std::vector<vec3>& p, const std::vector<vec2>& v) {
    static const DeviceFunction<ImageLightResult> function({.include = "light/light.clh", .type = "image_light_result", .body = R"(
        light_tables tables = BIND_LIGHTS;
        color_tables color_set = BIND_COLORS;
        palette colors = path_palette(color_set, 0u, 0u);
        light_sample s = sample_light(tables, colors, 1u, p, 0.5f, v);
        result.L = s.L; result.wi = s.wi; result.pdf = s.pdf; result.is_delta = s.is_delta;)",
        .inputs = {"vec3 p", "vec2 v"},
        .declarations = "typedef struct { spectrum L; vec3 wi; float pdf; int is_delta; } image_light_result;",
        .tables = "LIGHT_ARGUMENTS COLOR_ARGUMENTS"});
    const DeviceScene onDevice(testContext(), scene);
    return function.with(onDevice, p, v);
}

/// A turned place for lights.
glm::dmat4 somewhere() {
    const double c = std::cos(0.7), s = std::sin(0.7);
    glm::dmat4 m(glm::dmat3(c, s, 0, -s, c, 0, 0, 0, 1) * glm::dmat3(1, 0, 0, 0, c, s, 0, -s, c));
    m[3] = {0.3, -0.2, 0.5, 1};
    return m;
}

/// I of a direction in light space: the mean of R, G and B of the texel there, in an image whose +z is +y of light space.
TEST(GoniometricLight, FollowsItsImage) {
    constexpr int n = 16;
    Light l;
    l.kind = GoniometricLight{Spectrum::rgb({1, 2, 3}, ColorSpace::srgb), 0};
    l.scale = 5;
    l.worldFromLight = somewhere();
    const PackedScene scene = packLight(l, n, n);
    const auto image = imageFile(n, n).pixels;
    Random random(62);
    const auto p = generate(4000, [&] { return random.box(3); });
    const auto results = sample(scene, p, std::vector<vec2>(p.size(), {0.5f, 0.5f}));
    int edges = 0;
    for (size_t i = 0; i < p.size(); ++i) {
        const glm::dvec3 w = glm::inverse(glm::dmat3(l.worldFromLight)) * (toGlm(p[i]) - glm::dvec3(l.worldFromLight[3]));
        const glm::dvec2 at = squareFromDirection({w.x, w.z, w.y}) * double(n);
        const int x = std::min(static_cast<int>(at.x), n - 1), y = std::min(static_cast<int>(at.y), n - 1);
        const double grey = (image->at(x, y, 0) + image->at(x, y, 1) + image->at(x, y, 2)) / 3., expected = 5 * 2 * grey / glm::dot(w, w);
        ASSERT_TRUE(results[i].isDelta);
        ASSERT_EQ(results[i].pdf, 1);
        if (std::abs(results[i].L.g / expected - 1) < 1e-4) continue;
        ++edges;
        const double dx = std::abs(at.x - std::round(at.x)), dy = std::abs(at.y - std::round(at.y));
        ASSERT_LT(std::min(dx, dy), 1e-3) << "the wrong texel, and not at its edge";
    }
    EXPECT_LT(edges, 20);
}

/// The slide fills a pyramid around +z; its top is at +y, its left side at -x.
TEST(ProjectionLight, ProjectsItsImage) {
    for (const auto& [width, height] : {std::pair{12, 8}, std::pair{6, 10}}) {
        Light l;
        l.kind = ProjectionLight{0, 50};
        l.scale = 5;
        l.worldFromLight = somewhere();
        const PackedScene scene = packLight(l, width, height);
        const auto image = imageFile(width, height).pixels;
        const double opposite = std::tan(glm::radians(25.)), shorter = std::min(width, height);
        Random random(63);
        const auto p = generate(8000, [&] { return random.box(3); });
        const auto results = sample(scene, p, std::vector<vec2>(p.size(), {0.5f, 0.5f}));
        int lit = 0;
        for (size_t i = 0; i < p.size(); ++i) {
            const glm::dvec3 w = glm::inverse(glm::dmat3(l.worldFromLight)) * (toGlm(p[i]) - glm::dvec3(l.worldFromLight[3]));
            const glm::dvec2 at(width * (0.5 + w.x / w.z / opposite * shorter / width / 2), height * (0.5 - w.y / w.z / opposite * shorter / height / 2));
            const double dx = std::abs(at.x - std::round(at.x)), dy = std::abs(at.y - std::round(at.y));
            if (std::min(dx, dy) < 1e-3 || std::abs(w.z) < 0.01) continue;
            const bool inside = w.z > 0 && at.x > 0 && at.x < width && at.y > 0 && at.y < height;
            const double expected = inside ? 5 * image->at(static_cast<int>(at.x), static_cast<int>(at.y), 1) / glm::dot(w, w) : 0;
            ASSERT_NEAR(results[i].L.g, expected, 1e-4 * expected);
            lit += inside;
        }
        EXPECT_GT(lit, 100);
    }
}

/// A sky of radiance L gives E = pi L; pbrt-v4 measures half of that, and so makes it twice as bright as its "illuminance" says.
TEST(ImageLights, AnIlluminanceIsHalfOfWhatArrives) {
    Scene scene;
    ImageFile file = imageFile(16, 16);
    file.pixels = std::make_shared<ImageData>(equalAreaImage(16, 1, [](glm::dvec3) { return glm::dvec3(0.3); }));
    scene.images.push_back(file);
    scene.lights.resize(1);
    scene.lights[0].kind = ImageInfiniteLight{0};
    scene.lights[0].illuminance = 10;
    Diagnostics diagnostics(LogLevel::silent);
    for (float texel : packScene(scene, diagnostics).tables.environment_texels) ASSERT_NEAR(texel, 20 / M_PI, 0.02);
}

/// With a "power" the luminance, integrated over all directions, is that.
TEST(ImageLights, EmitTheirPower) {
    Light lamp, slide;
    lamp.kind = GoniometricLight{Spectrum::constant(1), 0};
    slide.kind = ProjectionLight{0, 70};
    for (Light l : {lamp, slide}) {
        l.power = 30;
        const PackedScene scene = packLight(l, 12, 12);
        Random random(64);
        const auto p = generate(100000, [&] { return random.direction(); });
        Accumulator flux;
        for (const ImageLightResult& r : sample(scene, p, std::vector<vec2>(p.size(), {0.5f, 0.5f}))) flux.add(4 * M_PI * (0.2126 * r.L.r + 0.7152 * r.L.g + 0.0722 * r.L.b));
        EXPECT_NEAR(flux.estimate().mean, 30, 4 * flux.estimate().error);
    }
}

}  // namespace
}  // namespace eikonal
