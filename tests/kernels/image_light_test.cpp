// Lights whose directions are an image's texels: goniometric and projection lights, and infinite lights with a portal.

#include "kinds/light_kind.h"
#include "device_function.h"
#include "pack/pack.h"
#include "read/formats/image.h"
#include "random_inputs.h"
#include "image/equal_area.h"
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

struct ImageLightResult { spectrum L; vec3 wi; float pdf; int isDelta; spectrum Le; float pdfHere; };

/// A sample of light 0 at p, and what a portal is found to send along it.
std::vector<ImageLightResult> sample(const PackedScene& scene, const std::vector<vec3>& p, const std::vector<vec2>& v) {
    static const DeviceFunction<ImageLightResult> function(
        {.include = "light/choose.clh",
         .type = "image_light_result",
         .body = R"(
        light_tables tables = BIND_LIGHTS;
        color_tables color_set = BIND_COLORS;
        sampled_wavelengths colors = path_wavelengths(color_set, 0u, 0u);
        light l = fetch(tables.lights);
        light_choice found = no_choice();
        found.pmf = 1.0f;
        if (l.kind == kind_portal_infinite_light) found = sample_portal(tables, l, p, v, found);
        light_sample s = sample_light(tables, colors, found, p, v);
        light_emission seen = eval_portal_infinite_light(tables, colors, l, eval_color(colors, l.L), p, s.wi, 0u);
        result.L = s.L; result.wi = s.wi; result.pdf = s.pdf; result.is_delta = s.is_delta; result.Le = seen.Le;
            result.pdf_here = seen.pdf;)",
         .inputs = {"vec3 p", "vec2 v"},
         .declarations =
             "typedef struct { spectrum L; vec3 wi; float pdf; int is_delta; spectrum Le; float pdf_here; } image_light_result;",
         .tables = "LIGHT_TABLES(TABLE) COLOR_TABLES(TABLE)"});
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
    l.kind = &kindOf(kind_goniometric_light);
    l.spectrum = Spectrum::rgb({1, 2, 3}, ColorSpace::srgb);
    l.image = 0;
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
        l.kind = &kindOf(kind_projection_light);
        l.image = 0;
        l.fov = 50;
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
            const glm::dvec2 at(width * (0.5 + w.x / w.z / opposite * shorter / width / 2),
                                height * (0.5 - w.y / w.z / opposite * shorter / height / 2));
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
    ImageFile file = imageFile(128, 128);
    file.pixels = std::make_shared<ImageData>(equalAreaImage(128, 1, [](glm::dvec3) { return glm::dvec3(0.3); }));
    scene.images.push_back(file);
    scene.lights.resize(1);
    scene.lights[0].kind = &kindOf(kind_image_infinite_light);
    scene.lights[0].image = 0;
    scene.lights[0].illuminance = 10;
    Diagnostics diagnostics(LogLevel::silent);
    for (float texel : packScene(scene, diagnostics).tables.environment_texels) ASSERT_NEAR(texel, 20 / M_PI, 0.02);
}

/// With a "power" the luminance, integrated over all directions, is that.
TEST(ImageLights, EmitTheirPower) {
    Light lamp, slide;
    lamp.kind = &kindOf(kind_goniometric_light);
    lamp.spectrum = Spectrum::constant(1);
    lamp.image = 0;
    slide.kind = &kindOf(kind_projection_light);
    slide.image = 0;
    slide.fov = 70;
    for (Light l : {lamp, slide}) {
        l.power = 30;
        const PackedScene scene = packLight(l, 12, 12);
        Random random(64);
        const auto p = generate(100000, [&] { return random.direction(); });
        Accumulator flux;
        for (const ImageLightResult& r : sample(scene, p, std::vector<vec2>(p.size(), {0.5f, 0.5f})))
            flux.add(4 * M_PI * (0.2126 * r.L.r + 0.7152 * r.L.g + 0.0722 * r.L.b));
        EXPECT_NEAR(flux.estimate().mean, 30, 4 * flux.estimate().error);
    }
}

// ---- portals ------------------------------------------------------------------------------------------------------------

/// A turned rectangle, from which x cross y points away from the points below.
constexpr double portalWidth = 1.3, portalHeight = 0.8;
struct Portal { std::array<glm::dvec3, 4> corners; glm::dvec3 x, y, n; };
Portal portal() {
    const glm::dmat3 turn(somewhere());
    const glm::dvec3 x = turn[0], y = turn[1], at(0.2, 0.4, 0.1);
    return {{at, at + portalHeight * y, at + portalHeight * y + portalWidth * x, at + portalWidth * x}, x, y, glm::cross(x, y)};
}
PackedScene portalScene(int n) {
    Light l;
    l.kind = &kindOf(kind_portal_infinite_light);
    l.spectrum = Spectrum::constant(2);
    l.image = n > 0 ? 0 : none;
    l.portal = portal().corners;
    l.scale = 3;
    l.worldFromLight = glm::inverse(somewhere());
    return packLight(l, std::max(n, 1), std::max(n, 1));
}

/// Functions of direction whose integrals over the portal, as seen from a point, are compared.
constexpr size_t momentCount = 6;
std::array<double, momentCount> moments(glm::dvec3 w) { return {1, w.x, w.y, w.z, w.x * w.y, w.z * w.z}; }

/// Near, far, to the side, in the portal's plane nearly, and so far that the window is a small part of a texel.
std::vector<glm::dvec3> portalPoints() {
    const Portal p = portal();
    const glm::dvec3 middle = (p.corners[0] + p.corners[2]) / 2.;
    return {middle - 0.3 * p.n, middle - 2. * p.n + 0.7 * p.x, middle - 0.05 * p.n + 1.5 * p.x + 0.2 * p.y, middle - 30. * p.n + 3. * p.y};
}

/// The mean of f / pdf is the integral of f over the portal's solid angle (by the midpoint rule: dw = cos / d^2 dA), the sample lies in the
/// portal, and its density and radiance are those which a path finds that goes the same way by itself.
TEST(PortalEnvironment, SamplesFollowTheWindow) {
    const Portal at = portal();
    Random random(65);
    const auto v = generate(40000, [&] { return random.square(); });
    for (int n : {0, 1, 8, 64}) {
        SCOPED_TRACE(n);
        const PackedScene scene = portalScene(n);
        for (const glm::dvec3& p : portalPoints()) {
            std::array<Accumulator, momentCount> estimates;
            int elsewhere = 0;
            for (const ImageLightResult& r : sample(scene, std::vector<vec3>(v.size(), toVec3(p)), v)) {
                ASSERT_GT(r.pdf, 0);
                ASSERT_NEAR(glm::length(toGlm(r.wi)), 1, 1e-5);
                const auto m = moments(toGlm(r.wi));
                for (size_t k = 0; k < momentCount; ++k) estimates[k].add(m[k] / r.pdf);
                const double way = glm::dot(at.corners[0] - p, at.n) / glm::dot(toGlm(r.wi), at.n);
                const glm::dvec3 q = p + way * toGlm(r.wi) - at.corners[0];
                const double slack = 1e-5 * (1 + way * way);
                ASSERT_GT(way, 0);
                ASSERT_TRUE(glm::dot(q, at.x) > -slack && glm::dot(q, at.x) < portalWidth + slack && glm::dot(q, at.y) > -slack &&
                            glm::dot(q, at.y) < portalHeight + slack);
                if (!(std::abs(r.pdfHere / r.pdf - 1) < 1e-3 && r.Le.g == r.L.g)) ++elsewhere;
            }
            EXPECT_LT(elsewhere, 200) << "at edges of texels and of the window only";
            std::array<double, momentCount> expected{};
            constexpr int steps = 300;
            for (int i = 0; i < steps * steps; ++i) {
                const glm::dvec3 q =
                    at.corners[0] + (i % steps + 0.5) / steps * portalWidth * at.x + (i / steps + 0.5) / steps * portalHeight * at.y;
                const glm::dvec3 to = q - p;
                const double d = glm::length(to), solid = glm::dot(to / d, at.n) / (d * d) * portalWidth * portalHeight / (steps * steps);
                const auto m = moments(to / d);
                for (size_t k = 0; k < momentCount; ++k) expected[k] += m[k] * solid;
            }
            for (size_t k = 0; k < momentCount; ++k) {
                const Estimate e = estimates[k].estimate();
                EXPECT_NEAR(e.mean, expected[k], 4 * e.error + 1e-3 * expected[0])
                    << "moment " << k << " from " << p.x << " " << p.y << " " << p.z;
            }
        }
    }
}

/// Radiance of every direction, in light space, where it varies slowly: the portal shows the environment, neither turned nor mirrored.
TEST(PortalEnvironment, ShowsTheEnvironment) {
    const auto radiance = [](glm::dvec3 d) { return glm::dvec3(2 + d.x, 2 + d.y, 2 + d.z); };
    Scene description;
    ImageFile file;
    file.pixels = std::make_shared<ImageData>(equalAreaImage(64, 2, radiance));
    description.images.push_back(file);
    Light l;
    l.kind = &kindOf(kind_portal_infinite_light);
    l.spectrum = Spectrum::constant(1);
    l.image = 0;
    l.portal = portal().corners;
    l.scale = 3;
    l.worldFromLight = glm::inverse(somewhere());
    description.lights.push_back(l);
    Diagnostics diagnostics(LogLevel::silent);
    const PackedScene scene = packScene(description, diagnostics);
    Random random(66);
    const auto v = generate(2000, [&] { return random.square(); });
    for (const ImageLightResult& r : sample(scene, std::vector<vec3>(v.size(), toVec3(portalPoints()[0])), v)) {
        const glm::dvec3 expected = 3. * radiance(glm::dmat3(somewhere()) * toGlm(r.wi));
        ASSERT_NEAR(r.L.r, expected.x, 0.15);
        ASSERT_NEAR(r.L.g, expected.y, 0.15);
        ASSERT_NEAR(r.L.b, expected.z, 0.15);
    }
    for (const ImageLightResult& r : sample(portalScene(0), std::vector<vec3>(v.size(), toVec3(portalPoints()[0])), v))
        ASSERT_NEAR(r.L.g, 3 * 2, 1e-5);
}

/// Behind it, and beside it, all is dark.
TEST(PortalEnvironment, IsDarkElsewhere) {
    const Portal at = portal();
    const PackedScene scene = portalScene(8);
    Random random(67);
    const auto v = generate(200, [&] { return random.square(); });
    for (const ImageLightResult& r : sample(scene, std::vector<vec3>(v.size(), toVec3(at.corners[0] + 0.3 * at.n)), v)) ASSERT_EQ(r.pdf, 0);
    static const DeviceFunction<float> here({.include = "light/choose.clh",
                                             .type = "float",
                                             .body = R"(
        light_tables tables = BIND_LIGHTS;
        color_tables color_set = BIND_COLORS;
        light_emission seen = eval_portal_infinite_light(tables, path_wavelengths(color_set, 0u, 0u), fetch(tables.lights),
            uniform_spectrum(1.0f), p, d, 0u);
        result = seen.pdf + max_component(seen.Le);)",
                                             .inputs = {"vec3 p", "vec3 d"},
                                             .tables = "LIGHT_TABLES(TABLE) COLOR_TABLES(TABLE)"});
    const DeviceScene onDevice(testContext(), scene);
    const glm::dvec3 p = portalPoints()[0];
    std::vector<vec3> d;
    std::vector<bool> through;
    for (int i = 0; i < 2000; ++i) {
        d.push_back(random.direction());
        const double way = glm::dot(at.corners[0] - p, at.n) / glm::dot(toGlm(d.back()), at.n);
        const glm::dvec3 q = p + way * toGlm(d.back()) - at.corners[0];
        through.push_back(way > 0 && glm::dot(q, at.x) > 0 && glm::dot(q, at.x) < portalWidth && glm::dot(q, at.y) > 0 &&
                          glm::dot(q, at.y) < portalHeight);
    }
    const auto results = here.with(onDevice, std::vector<vec3>(d.size(), toVec3(p)), d);
    for (size_t i = 0; i < d.size(); ++i) ASSERT_EQ(results[i] > 0, through[i]);
}

}  // namespace
}  // namespace eikonal
