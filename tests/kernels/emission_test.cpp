// Paths that begin at lights, and their connections to cameras: both are held to what paths from the camera say of the same light.

#include "eikonal/lights.h"
#include "device_function.h"
#include "lens_file.h"
#include "pack/alias_table.h"
#include "random_inputs.h"
#include "stage.h"
#include "statistics.h"
#include "test_paths.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace eikonal {
namespace {

struct Emitted {
    vec3 p, d;
    float beta, arrival;
};
struct Received {
    float light;
};

glm::dvec3 toGlm(vec3 v) { return {v.x, v.y, v.z}; }

/// A scene whose only lights are those of `text`, for an integrator that traces light paths, around a ball.
PackedScene lit(const std::string& text) {
    return packText(
        "LookAt 0 0 -5  0 0 0  0 1 0 Camera \"perspective\" Film \"rgb\" Sampler \"independent\" Integrator \"bdpt\"\nWorldBegin\n" + text +
        "\nMaterial \"diffuse\" Shape \"sphere\"\n");
}

std::vector<Emitted> emit(const PackedScene& scene, size_t n) {
    const DeviceFunction<Emitted> function(
        {.include = "light/emission.clh",
         .type = "emitted",
         .body = "light_tables tables = BIND_LIGHTS; color_tables color_set = BIND_COLORS;"
                 "emission e = sample_emission(tables, emission_aliases, path_wavelengths(color_set, 0u, 0u), lights_of_scene, 7u, sample);"
                 "result.p = e.from.p; result.d = e.d; result.beta = e.beta.g; result.arrival = e.arrival;",
         .inputs = {"uint sample", "uint lights_of_scene"},
         .declarations = "typedef struct { vec3 p, d; float beta, arrival; } emitted;",
         .tables = "GEOMETRY_TABLES(TABLE) TEXTURE_TABLES(TABLE) LIGHT_TABLES(TABLE) EMISSION_TABLES(TABLE) COLOR_TABLES(TABLE)"});
    std::vector<uint> samples(n);
    for (size_t i = 0; i < n; ++i) samples[i] = static_cast<uint>(i);
    return function.with(DeviceScene(testContext(), scene), samples, std::vector<uint>(n, static_cast<uint>(scene.tables.lights.size())));
}

/// The light that light samples say arrives at points of a surface, over the density of the sample.
std::vector<Received> receive(PackedScene scene, const std::vector<vec3>& points, vec3 n, Random& random) {
    /* All are as likely, also a sky that is left to the BSDFs */
    scene.tables.light_aliases = makeAliasTable(std::vector<double>(scene.tables.lights.size(), 1));
    for (light& l : scene.tables.lights) l.pmf = 1 / static_cast<float>(scene.tables.lights.size());
    const DeviceFunction<Received> function({.include = "trace/route_items.clh",
                                             .type = "received",
                                             .body =
                                                 "light_tables tables = BIND_LIGHTS; color_tables color_set = BIND_COLORS;"
                                                 "alias_sample lot = sample_light_index(tables, lights_of_scene, u);"
                                                 "light_choice found = choose_this_light(tables, no_choice(), (uint)lot.i);"
                                                 "light_sample s = sample_light(tables, path_wavelengths(color_set, 0u, 0u), found, p, v);"
                                                 "result.light = s.pdf > 0.0f ? s.L.g * max1(dot3(s.wi, n), 0.0f) / s.pdf : 0.0f;",
                                             .inputs = {"vec3 p", "vec3 n", "float u", "vec2 v", "uint lights_of_scene"},
                                             .declarations = "typedef struct { float light; } received;",
                                             .tables = "LIGHT_TABLES(TABLE) COLOR_TABLES(TABLE)"});
    return function.with(DeviceScene(testContext(), scene), points, std::vector<vec3>(points.size(), n),
                         generate(points.size(), [&] { return random.unit(); }), generate(points.size(), [&] { return random.square(); }),
                         std::vector<uint>(points.size(), static_cast<uint>(scene.tables.lights.size())));
}

struct EmissionCase {
    std::string name, text;
};
void PrintTo(const EmissionCase& c, std::ostream* out) { *out << c.name; }
class Emission : public testing::TestWithParam<EmissionCase> {};

/// The flux through a disk, by the paths that begin at the light and cross it, is the disk's area times the mean irradiance by light
/// samples at points of it: within 4 standard errors of both, which may be 3 % together.
TEST_P(Emission, SendsTheFluxThatLightSamplesReceive) {
    const PackedScene scene = lit(GetParam().text);
    ASSERT_TRUE(scene.features.has(Feature::LIGHT_PATHS));
    const glm::dvec3 center(0.05, 0.1, -0.1), n = glm::normalize(glm::dvec3(0.2, 1, -0.3)), x = glm::normalize(glm::cross(n, {0, 0, 1})),
                                              y = glm::cross(n, x);
    constexpr double radius = 0.25;
    Accumulator sent, received;
    for (const Emitted& e : emit(scene, 1 << 18)) {
        const glm::dvec3 p = toGlm(e.p) - center, d = toGlm(e.d);
        const double facing = glm::dot(d, n), t = -glm::dot(p, n) / facing;
        const bool crosses = facing < 0 && t > 0 && glm::length(p + t * d) < radius;
        sent.add(crosses ? static_cast<double>(e.beta) : 0);
    }
    Random random(5);
    const auto points = generate(1 << 16, [&] {
        const double r = radius * std::sqrt(random.unit()), phi = 2 * M_PI * static_cast<double>(random.unit());
        const glm::dvec3 p = center + r * std::cos(phi) * x + r * std::sin(phi) * y;
        return vec3{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    });
    const vec3 normal{static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
    for (const Received& r : receive(scene, points, normal, random)) received.add(M_PI * radius * radius * static_cast<double>(r.light));
    const Estimate a = sent.estimate(), b = received.estimate();
    const double error = std::hypot(a.error, b.error);
    EXPECT_GT(b.mean, 0);
    EXPECT_NEAR(a.mean, b.mean, 4 * error + 1e-5 * b.mean);
    EXPECT_LT(error, 0.03 * b.mean) << "too few samples to tell";
}

std::string area(const std::string& shape) {
    return "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [1 2 3] " + shape + " AttributeEnd\n";
}
const std::string tiles = "\"string filename\" \"" EIKONAL_SOURCE_DIR "/scenes/assets/tiles.png\"";

const std::vector<EmissionCase> emissionCases{
    {"point", "LightSource \"point\" \"rgb I\" [1 2 3] \"point3 from\" [.4 1.5 -.2]"},
    {"spot", "LightSource \"spot\" \"rgb I\" [1 2 3] \"point3 from\" [.6 1.5 -.2] \"float coneangle\" 25 \"float conedeltaangle\" 15"},
    {"distant", "LightSource \"distant\" \"rgb L\" [1 2 3] \"point3 from\" [1 2 -1]"},
    {"goniometric", "AttributeBegin Translate .4 1.5 -.2 LightSource \"goniometric\" \"string filename\" \"" EIKONAL_SOURCE_DIR
                    "/scenes/assets/sky.exr\" AttributeEnd"},
    {"projection",
     "AttributeBegin Translate 0 1.5 -.3 Rotate 80 1 0 0 LightSource \"projection\" \"float fov\" 60 " + tiles + " AttributeEnd"},
    {"uniform_infinite", "LightSource \"infinite\" \"rgb L\" [1 2 3]"},
    {"image_infinite", "LightSource \"infinite\" \"string filename\" \"" EIKONAL_SOURCE_DIR "/scenes/assets/sky.exr\""},
    {"triangle", area("Shape \"trianglemesh\" \"point3 P\" [-.5 1.3 -.4  .6 1.5 -.5  .1 1.2 .6]")},
    {"triangle_two_sided",
     "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [1 2 3] \"bool twosided\" true "
     "Shape \"trianglemesh\" \"point3 P\" [-.5 1.3 -.4  .1 1.2 .6  .6 1.5 -.5] AttributeEnd"},
    {"bilinear", area("Shape \"bilinearmesh\" \"point3 P\" [-.5 1.3 -.4  .6 1.5 -.5  -.5 1.2 .6  .3 1.6 .5]")},
    {"sphere", area("Translate .3 1.6 -.3 Shape \"sphere\" \"float radius\" .3")},
    {"ellipsoid", area("Translate .3 1.6 -.3 Scale .5 .2 .3 Shape \"sphere\"")},
    {"disk", area("Translate .3 1.5 -.3 Rotate 90 1 0 0 Scale 1 .6 1 Shape \"disk\" \"float radius\" .4 \"float innerradius\" .1")},
    {"cylinder", area("Translate .3 1.6 -.3 Rotate 40 1 0 1 Shape \"cylinder\" \"float radius\" .2 \"float zmin\" -.4 \"float zmax\" .4")}};
INSTANTIATE_TEST_SUITE_P(Kinds, Emission, testing::ValuesIn(emissionCases), [](const auto& info) { return info.param.name; });

/// Every kind at which light paths may begin is above. The others say that none does.
TEST(EmissionList, IsCovered) {
    std::set<std::string> tested;
    for (const EmissionCase& c : emissionCases) tested.insert(c.name);
#define EXPECT_TESTED(name, FEATURE, PLACE) \
    EXPECT_NE(tested.count(#name) > 0, std::string(#name) == "implicit" || std::string(#name) == "portal_infinite") << #name;
    LIGHTS(EXPECT_TESTED)
#undef EXPECT_TESTED
}

struct Connection {
    vec3 o, lens;
    float density, inverse, importance, expected;
    vec2 raster, image;
};
constexpr const char* declaration =
    "typedef struct { vec3 o, lens; float density, inverse, importance, expected; vec2 raster, image; } connection;";

/// A camera ray, and the connection of a point on it to the camera by the same point of the lens: both are the same line, at the same place
/// in the image, and the density of one is 1 over the inverse density that the other carries.
TEST(Importance, ConnectsPointsAlongTheRaysOfTheCamera) {
    const LensFile lens("30 5 1.6 24\n80 3 1 24\n0 3 0 14\n-25 1.5 1.7 16\n40 2 1 18\n60 4 1.65 20\n-35 30 1 20\n");
    const std::string realistic = lens.camera() + " \"float aperturediameter\" 9 \"float focusdistance\" 3";
    for (const std::string& camera :
         {std::string("\"perspective\" \"float fov\" 50"), std::string("\"orthographic\""),
          std::string("\"perspective\" \"float lensradius\" .3 \"float focaldistance\" 4"),
          std::string("\"orthographic\" \"float lensradius\" .3 \"float focaldistance\" 4"), std::string("\"spherical\""),
          std::string("\"spherical\" \"string mapping\" \"equirectangular\""), realistic})
        for (const std::string stretch : {"", "Scale 1 2 .5 ", "Scale -3 3 3 "}) {
            SCOPED_TRACE(camera + stretch);
            const PackedScene scene = packText(
                stretch + "LookAt 3 1 -5  0 .5 0  0 1 0\nCamera " + camera +
                "\nFilm \"rgb\" \"integer xresolution\" 40 \"integer yresolution\" 30\nPixelFilter \"box\"\nSampler \"independent\"\n"
                "Integrator \"bdpt\"\nWorldBegin\nLightSource \"point\"\nMaterial \"diffuse\" Shape \"sphere\"\n");
            const DeviceFunction<Connection> function(
                {.include = "camera/camera.clh",
                 .type = "connection",
                 .body =
                     "camera_tables tables = BIND_CAMERA;"
                     "camera_sample of_camera = generate_ray(tables, frame, x, y, sample, 0u);"
                     "ray_item r = of_camera.ray;"
                     "vec3 p = mul_add(r.d, distance, r.o);"
                     "affine m = frame->view.scene_from_camera; vec3 own = transform_point(invert(m), r.o);"
                     "vec2 of_lens = make_vec2(own.x, own.y), at = sample_2d(r.seed, r.sample, dimension_lens);"
                     "camera_connection c = frame->view.element_count > 0u ? connect_to_lens(tables, frame, m, p, of_lens)"
                     "                                                     : connect_to_camera(tables, frame, 0.0f, p, at);"
                     "vec2 u = sample_2d(r.seed, r.sample, dimension_pixel);"
                     "result.o = r.o; result.lens = c.o; result.density = c.density; result.raster = c.raster;"
                     "result.inverse = r.t_max > 0.0f ? r.d_vcm : -1.0f;"
                     "result.importance = c.importance; result.expected = of_camera.importance;"
                     "result.image = make_vec2((float)x + u.x, (float)y + u.y);",
                 .inputs = {"uint x", "uint y", "uint sample", "float distance"},
                 .declarations = declaration,
                 .tables = "CAMERA_TABLES(TABLE) ARGUMENT(__global const settings *, frame)",
                 .features = scene.features});
            Random random(9);
            constexpr size_t n = 4096;
            const auto distance = generate(n, [&] { return random.between(0.3f, 3); });
            size_t met = 0, unequal = 0;
            const auto found =
                function.with(DeviceScene(testContext(), scene), generate(n, [&] { return random.below(40); }),
                              generate(n, [&] { return random.below(30); }), generate(n, [&] { return random.below(64); }), distance);
            for (size_t i = 0; i < n; ++i) {
                const Connection& c = found[i];
                if (c.inverse < 0) continue; /* blocked by the lens */
                ++met;
                /* On the rim of a face, rounding decides what passes; and a few rays leave beside the disk that light paths aim at */
                if (c.density == 0 || c.inverse == 0) { ++unequal; continue; }
                const double away = scene.frame().view.is_parallel ? 1 : std::pow(static_cast<double>(distance[i]), 2);
                ASSERT_LT(glm::length(toGlm(c.o) - toGlm(c.lens)), 1e-5);
                /* Near a pole, longitudes are close together */
                const bool isGlobe = camera.find("equirect") != std::string::npos;
                const double apart = isGlobe ? std::sin(M_PI * static_cast<double>(c.image.y) / 30) : 1;
                /* Each face of a lens adds its rounding */
                const double pixels = scene.frame().view.element_count > 0 ? 2e-2 : 2e-3;
                ASSERT_NEAR(c.raster.x, c.image.x, pixels / std::max(apart, 1e-3));
                ASSERT_NEAR(c.raster.y, c.image.y, pixels);
                /* At a border between two pupils, rounding decides which one a film point has */
                const double ratio = static_cast<double>(c.density) * away * static_cast<double>(c.inverse);
                ASSERT_NEAR(ratio, 1, scene.frame().view.element_count > 0 ? 0.05 : 1e-3);
                unequal += std::abs(ratio - 1) > 1e-3;
                ASSERT_NEAR(c.importance, c.expected, 0.05 * c.expected);
            }
            EXPECT_GT(met, n / 3);
            EXPECT_LE(unequal, scene.frame().view.element_count > 0 ? n / 500 : 0);
        }
}

/// The density of connections is that of rays: over the part of a sphere around a pinhole that the image shows, it integrates to 1. Points
/// are taken uniformly from the cone around it, down to a cosine of `widest`.
struct Look { std::string camera; double widest; };
void PrintTo(const Look& l, std::ostream* out) { *out << l.camera; }
class ImportanceOf : public testing::TestWithParam<Look> {};

TEST_P(ImportanceOf, IntegratesToOneOverTheImage) {
    const PackedScene scene = packText(
        "LookAt 0 0 0  0 0 1  0 1 0\nCamera " + GetParam().camera + "\nFilm \"rgb\" \"integer xresolution\" 40 \"integer "
        "yresolution\" 30\n"
        "PixelFilter \"box\"\nSampler \"independent\"\nIntegrator \"bdpt\"\nWorldBegin\nLightSource \"point\"\nMaterial \"diffuse\" Shape "
        "\"sphere\"\n");
    const DeviceFunction<Connection> function(
        {.include = "camera/camera.clh",
         .type = "connection",
         .body = "camera_tables tables = BIND_CAMERA;"
                 "camera_connection c = connect_to_camera(tables, frame, 0.0f, p, make_vec2(0.0f, 0.0f));"
                 "result.lens = c.o; result.density = c.density; result.raster = c.raster;",
         .inputs = {"vec3 p"},
         .declarations = declaration,
         .tables = "CAMERA_TABLES(TABLE) ARGUMENT(__global const settings *, frame)",
         .features = scene.features});
    /* The eye is at the origin of a scene of one ball around it */
    Random random(3);
    const double widest = GetParam().widest;
    const auto points = generate(1 << 18, [&] {
        const double z = 1 - (1 - widest) * static_cast<double>(random.unit()), r = std::sqrt(1 - z * z),
                     phi = 2 * M_PI * static_cast<double>(random.unit());
        return vec3{static_cast<float>(r * std::cos(phi)), static_cast<float>(r * std::sin(phi)), static_cast<float>(z)};
    });
    Accumulator total;
    for (const Connection& c : function.with(DeviceScene(testContext(), scene), points)) {
        const bool inImage = c.raster.x >= 0 && c.raster.x < 40 && c.raster.y >= 0 && c.raster.y < 30;
        total.add(inImage ? static_cast<double>(c.density) * 2 * M_PI * (1 - widest) : 0);
    }
    EXPECT_NEAR(total.estimate().mean, 1, 4 * total.estimate().error + 1e-6);
    EXPECT_LT(total.estimate().error, 0.005);
}
INSTANTIATE_TEST_SUITE_P(Cameras, ImportanceOf,
                         /* 25 degrees over the shorter side, 37.8 in the corners */
                         testing::Values(Look{"\"perspective\" \"float fov\" 50", 0.7}, Look{"\"spherical\"", -1},
                                         Look{"\"spherical\" \"string mapping\" \"equirectangular\"", -1}));

}  // namespace
}  // namespace eikonal
