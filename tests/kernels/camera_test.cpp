// Camera rays: through their pixel, through the lens, by the filter's importance.

#include "default_settings.h"
#include "device_function.h"
#include "lens_file.h"
#include "pack/lens.h"
#include "pack/motion.h"
#include "random_inputs.h"
#include "image/equal_area.h"
#include "read/pbrt/read_pbrt.h"
#include "stage.h"
#include "statistics.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace eikonal {
namespace {

struct CameraResult { vec3 o, d; float weight; };

/// n samples of pixel (x, y) of a scene without anything but a camera; o and d in camera space, d with d.z = 1, `ray` as it is.
struct CameraSample { glm::dvec3 o, d; double weight; glm::dvec3 ray; };
std::vector<CameraSample> drawRays(const std::string& head, uint x, uint y, size_t n) {
    const PackedScene scene = packText(head + "\nWorldBegin\nLightSource \"point\"\n");
    const DeviceFunction<CameraResult> function({.include = "camera/camera.clh", .type = "camera_result",
        .body = "camera_tables tables = BIND_CAMERA; camera_sample s = generate_ray(tables, frame, x, y, sample, 0u);"
                "result.o = s.ray.o; result.d = s.ray.d; result.weight = s.weight;",
        .inputs = {"uint x", "uint y", "uint sample"}, .declarations = "typedef struct { vec3 o, d; float weight; } camera_result;",
        .tables = "CAMERA_TABLES(TABLE) ARGUMENT(__global const settings *, frame)", .features = scene.features});
    std::vector<uint> samples(n);
    for (size_t i = 0; i < n; ++i) samples[i] = static_cast<uint>(i);
    const DeviceScene onDevice(testContext(), scene);
    const auto results = function.with(onDevice, std::vector<uint>(n, x), std::vector<uint>(n, y), samples);
    const affine& m = scene.frame().view.scene_from_camera;
    const glm::dmat4 inverse = glm::inverse(glm::dmat4(m.xx, m.yx, m.zx, 0, m.xy, m.yy, m.zy, 0, m.xz, m.yz, m.zz, 0, m.xw, m.yw, m.zw, 1));
    std::vector<CameraSample> rays;
    for (const CameraResult& r : results) {
        EXPECT_NEAR(dot(r.d, r.d), 1, 1e-5);
        const glm::dvec3 o = inverse * glm::dvec4(r.o.x, r.o.y, r.o.z, 1), d = inverse * glm::dvec4(r.d.x, r.d.y, r.d.z, 0);
        rays.push_back({o * scene.cameraUnit, d / d.z, static_cast<double>(r.weight), d});
    }
    return rays;
}

constexpr const char* view = R"(
    LookAt 3 1 -5  0 0.5 0  0 1 0
    Film "rgb" "integer xresolution" 40 "integer yresolution" 30
    PixelFilter "box" "float xradius" 0.5 "float yradius" 0.5
    Sampler "sobol" "integer pixelsamples" 65536
)";

/// Where a point of the plane z = 1 lies in the image, pixels from the upper left: 90 degrees over the shorter side are y in [-1, 1].
glm::dvec2 pixelOf(glm::dvec2 screen) { return {(screen.x * 15) + 20, 15 - screen.y * 15}; }

/// A pinhole: rays start at the eye, and cover their pixel uniformly.
TEST(Camera, PinholeRaysCoverTheirPixel) {
    for (const auto& [x, y] : {std::pair<uint, uint>{0, 0}, {39, 29}, {20, 11}}) {
        std::vector<double> counts(64), expected(64, 64.0);
        for (const CameraSample& r : drawRays(std::string(view) + "Camera \"perspective\" \"float fov\" 90", x, y, 4096)) {
            ASSERT_LT(glm::length(r.o), 1e-5);
            const glm::dvec2 p = pixelOf({r.d.x, r.d.y}) - glm::dvec2(x, y);
            ASSERT_GT(std::min(p.x, p.y), -1e-4);
            ASSERT_LT(std::max(p.x, p.y), 1 + 1e-4);
            ASSERT_EQ(r.weight, 1);
            counts[static_cast<size_t>(std::clamp(static_cast<int>(p.y * 8), 0, 7) * 8 + std::clamp(static_cast<int>(p.x * 8), 0, 7))] += 1;
        }
        const ChiSquare chi = testChiSquare(counts, expected);
        EXPECT_GT(chi.probability, significance) << chi.describe();
    }
}

/// A thin lens: origins are uniform over its disk, and every ray goes through the point of the plane in focus that its pixel sees
/// through the lens's centre.
TEST(Camera, LensRaysMeetInThePlaneOfFocus) {
    Accumulator radius;
    for (const CameraSample& r :
         drawRays(std::string(view) + "Camera \"perspective\" \"float fov\" 90 \"float lensradius\" 0.2 \"float focaldistance\" 4", 12, 7,
                  4096)) {
        const double distance = std::hypot(r.o.x, r.o.y);
        ASSERT_NEAR(r.o.z, 0, 1e-5);
        ASSERT_LE(distance, 0.2 + 1e-5);
        radius.add(distance * distance / 0.04);
        const glm::dvec3 focus = r.o + 4.0 * r.d;
        const glm::dvec2 p = pixelOf({focus.x / 4, focus.y / 4}) - glm::dvec2(12, 7);
        ASSERT_GT(std::min(p.x, p.y), -1e-3);
        ASSERT_LT(std::max(p.x, p.y), 1 + 1e-3);
    }
    EXPECT_NEAR(radius.estimate().mean, 0.5, 4 * radius.estimate().error);
}

/// Parallel rays, whose origins cover the pixel of a screen from -1 to 1 over the shorter side.
TEST(Camera, OrthographicRaysAreParallel) {
    for (const CameraSample& r : drawRays(std::string(view) + "Camera \"orthographic\"", 33, 4, 1024)) {
        ASSERT_LT(std::hypot(r.d.x, r.d.y), 1e-5);
        const glm::dvec2 p = pixelOf({r.o.x, r.o.y}) - glm::dvec2(33, 4);
        ASSERT_GT(std::min(p.x, p.y), -1e-4);
        ASSERT_LT(std::max(p.x, p.y), 1 + 1e-4);
    }
}

/// Both mappings of the sphere: the camera's y is up, longitudes run from x through z.
TEST(Camera, SphericalRaysAreThoseOfTheMapping) {
    for (const bool equalArea : {true, false}) {
        const std::string head =
            std::string(view) + "Camera \"spherical\" \"string mapping\" \"" + (equalArea ? "equalarea" : "equirectangular") + "\"";
        for (const auto& [x, y] : {std::pair<uint, uint>{0, 0}, {39, 29}, {20, 11}, {3, 28}})
            for (const CameraSample& r : drawRays(head, x, y, 256)) {
                ASSERT_LT(glm::length(r.o), 1e-5);
                const glm::dvec3 d = glm::normalize(r.ray), globe(d.x, d.z, d.y);
                const double longitude = std::atan2(globe.y, globe.x) / (2 * M_PI);
                const glm::dvec2 square = equalArea ? squareFromDirection(globe)
                                                    : glm::dvec2(longitude < 0 ? longitude + 1 : longitude, std::acos(globe.z) / M_PI);
                const glm::dvec2 p = square * glm::dvec2(40, 30) - glm::dvec2(x, y);
                ASSERT_GT(std::min(p.x, p.y), -1e-3) << x << " " << y;
                ASSERT_LT(std::max(p.x, p.y), 1 + 1e-3) << x << " " << y;
            }
    }
}

/// Filters reach beyond the edges of the sphere's image: on over the sphere, not back.
TEST(Camera, SphericalRaysGoOnBeyondTheEdge) {
    const DeviceFunction<vec2> wrap({.include = "math/equal_area.clh",
                                     .type = "vec2",
                                     .body = "result = equal_area_square(equal_area_sphere(wrap_equal_area(p)));",
                                     .inputs = {"vec2 p"}});
    const std::vector<vec2> outside{{-0.01f, 0.3f}, {1.02f, 0.9f}, {0.4f, -0.03f}, {0.7f, 1.01f}, {0.2f, 0.6f}};
    const std::vector<vec2> expected{{0.01f, 0.7f}, {0.98f, 0.1f}, {0.6f, 0.03f}, {0.3f, 0.99f}, {0.2f, 0.6f}};
    const auto results = wrap(outside);
    for (size_t i = 0; i < results.size(); ++i) {
        EXPECT_NEAR(results[i].x, expected[i].x, 1e-5);
        EXPECT_NEAR(results[i].y, expected[i].y, 1e-5);
    }
}

struct LensResult { vec3 o, d; float importance; };

/// A lens, element by element from the scene to the film, on the device and on the host in double precision; each ray counts
/// cos^4 / z^2 / density.
static void compareLensWithHost(const std::string& elements, const std::string& parameters) {
    const LensFile file(elements);
    const std::string head = std::string(view) + "Camera " + file.camera() + " " + parameters;
    Diagnostics diagnostics(LogLevel::silent);
    const Scene described = readPbrtText(head + "\nWorldBegin\n", "test.pbrt", ".", diagnostics);
    const LensSystem lens(described.camera, described.film.diagonal);
    const PackedScene scene = packText(head + "\nWorldBegin\nLightSource \"point\"\n");
    const camera& view = scene.frame().view;

    const DeviceFunction<LensResult> function(
        {.include = "camera/camera.clh",
         .type = "lens_result",
         .body = "camera_tables tables = BIND_CAMERA; camera_ray r = generate_realistic(tables, frame, film.x, film.y, u); result.o = r.o; "
                 "result.d = r.d; result.importance = r.importance;",
         .inputs = {"vec2 film", "vec2 u"},
         .declarations = "typedef struct { vec3 o, d; float importance; } lens_result;",
         .tables = "CAMERA_TABLES(TABLE) ARGUMENT(__global const settings *, frame)",
         .features = scene.features});
    constexpr size_t n = 8192;
    Random random(2);
    const auto film = generate(n, [&] { return vec2{random.between(-0.014f, 0.014f), random.between(-0.0105f, 0.0105f)}; });
    const auto u = generate(n, [&] { return random.square(); });
    const DeviceScene onDevice(testContext(), scene);
    const double unit = scene.cameraUnit;   /* of lengths on the device */
    auto filmOnDevice = film;
    for (vec2& p : filmOnDevice) p = {p.x / static_cast<float>(unit), p.y / static_cast<float>(unit)};
    const auto results = function.with(onDevice, filmOnDevice, u);

    size_t passed = 0, edges = 0, aside = 0;
    for (size_t i = 0; i < n; ++i) {
        const double x = static_cast<double>(film[i].x), y = static_cast<double>(film[i].y), distance = std::hypot(x, y);
        const double fromCentre = distance / unit / static_cast<double>(view.film_radius);
        const size_t interval = std::min<size_t>(static_cast<size_t>(fromCentre * PUPIL_INTERVALS), PUPIL_INTERVALS - 1);
        const pupil_bounds& b = scene.tables.pupils[interval];
        const glm::dvec2 size = unit * glm::dvec2(static_cast<double>(b.high_x - b.low_x), static_cast<double>(b.high_y - b.low_y));
        const glm::dvec2 p(static_cast<double>(b.low_x) * unit + static_cast<double>(u[i].x) * size.x,
                           static_cast<double>(b.low_y) * unit + static_cast<double>(u[i].y) * size.y);
        const glm::dvec3 rear(p.x * x / distance - p.y * y / distance, p.x * y / distance + p.y * x / distance, lens.rearZ()),
            start(x, y, 0);
        const auto out = lens.fromFilm({start, rear - start});
        const bool passes = results[i].importance > 0;
        passed += passes;
        if (out.has_value() != passes) { ++edges; continue; }
        if (!out) continue;
        const double cosine = glm::normalize(rear - start).z;
        ASSERT_NEAR(results[i].importance, std::pow(cosine, 4) * size.x * size.y / (lens.rearZ() * lens.rearZ()),
                    1e-4 * results[i].importance);
        /* It leaves through the plane in front of the glass */
        const glm::dvec3 left = out->o + (unit * static_cast<double>(view.front_z) - out->o.z) / out->d.z * out->d;
        ASSERT_LT(glm::length(unit * glm::dvec3(results[i].o.x, results[i].o.y, results[i].o.z) - left), 1e-6);
        ASSERT_GE(left.z, out->o.z);
        aside += std::hypot(left.x, left.y) > unit * static_cast<double>(view.lens_radius);
        ASSERT_LT(glm::length(glm::dvec3(results[i].d.x, results[i].d.y, results[i].d.z) - out->d), 1e-5);
    }
    EXPECT_GT(passed, n / 3) << "bounds that are that loose waste samples";
    EXPECT_LT(edges, n / 500) << "single precision may only matter at the edges";
    EXPECT_LT(aside, n / 500) << "light paths go through a disk, which few rays may miss";
}

TEST(Camera, RealisticRaysGoThroughEachElement) {
    compareLensWithHost("30 5 1.6 24\n80 3 1 24\n0 3 0 14\n-25 1.5 1.7 16\n40 2 1 18\n60 4 1.65 20\n-35 30 1 20\n",
                        "\"float aperturediameter\" 9 \"float focusdistance\" 3");
}

/// The rim of the face behind the stop is in front of it by 3.1 mm: rays that leave the face there do not meet the stop.
TEST(Camera, RealisticRaysNeverGoBackToTheStop) {
    compareLensWithHost("30 5 1.6 24\n80 3 1 24\n0 1 0 20\n-12 5 1.6 18\n-14 60 1 22\n",
                        "\"float aperturediameter\" 20 \"float focusdistance\" 3");
}

/// The stop in front, and a hollow front face, whose rim is in front of its middle.
TEST(Camera, RealisticRaysLeaveByAnyFrontElement) {
    compareLensWithHost("0 2 0 12\n50 6 1.5 24\n-50 40 1 24\n", "\"float aperturediameter\" 10 \"float focusdistance\" 3");
    compareLensWithHost("-200 3 1.5 24\n-40 1 1 24\n0 1 0 14\n60 4 1.6 20\n-60 40 1 20\n",
                        "\"float aperturediameter\" 12 \"float focusdistance\" 3");
}

/// A camera that moves is where the motion is at the sample's time, which is spread evenly over the shutter's.
TEST(Camera, MovingRaysStartWhereTheCameraIs) {
    const std::string head =
        "TransformTimes 1 3 ActiveTransform EndTime Translate 0 0 -4 ActiveTransform All\n" + std::string(view) +
        "Camera \"orthographic\" \"float screenwindow\" [ -1e-6 1e-6 -1e-6 1e-6 ] \"float shutteropen\" 1.5 \"float shutterclose\" 2.5";
    std::vector<double> counts(16), expected(16, 256.0);
    for (const CameraSample& r : drawRays(head, 5, 5, 4096)) {
        /* In the space of where it starts: it goes 4 units along its own axis in all */
        const double way = glm::length(r.o) / 4;
        ASSERT_GT(way, 0.25 - 1e-4);
        ASSERT_LT(way, 0.75 + 1e-4);
        counts[static_cast<size_t>(std::clamp(static_cast<int>((way - 0.25) * 32), 0, 15))] += 1;
    }
    const ChiSquare chi = testChiSquare(counts, expected);
    EXPECT_GT(chi.probability, significance) << chi.describe();
}

struct FilterCase { std::string name, text; double radius; std::function<double(double)> value; };
void PrintTo(const FilterCase& c, std::ostream* out) { *out << c.name; }
class Filters : public testing::TestWithParam<FilterCase> {};

/// Offsets follow the size of the filter, weights its sign: chi-square over the offset along x, and the mean weight is the
/// integral of the filter over that of its size, for both axes together.
TEST_P(Filters, AreSampledByImportance) {
    const FilterCase& f = GetParam();
    const std::string head = defaultSettings(view, f.text) + f.text + "\nCamera \"perspective\" \"float fov\" 90";
    const auto rays = drawRays(head, 20, 15, 65536);
    constexpr int cells = 48, fine = 64;
    std::vector<double> counts(cells), expected(cells);
    double integral = 0, size = 0;
    for (int i = 0; i < cells * fine; ++i) {
        const double value = f.value(((i + 0.5) / (cells * fine) * 2 - 1) * f.radius);
        expected[static_cast<size_t>(i / fine)] += std::abs(value);
        integral += value;
        size += std::abs(value);
    }
    /* The device holds 64 cells of constant density: 48 cells expect something else only by their slopes, less than the tolerance below. */
    Accumulator weight, x;
    for (const CameraSample& r : rays) {
        const double offset = pixelOf({r.d.x, r.d.y}).x - 20.5;
        ASSERT_LT(std::abs(offset), f.radius + 1e-4);
        counts[static_cast<size_t>(std::clamp(static_cast<int>((offset / f.radius + 1) / 2 * cells), 0, cells - 1))] += 1;
        weight.add(r.weight);
        x.add(offset);
    }
    for (size_t i = 0; i < counts.size(); ++i) {
        const double want = expected[i] / size;
        EXPECT_NEAR(counts[i] / 65536, want, 4 * std::sqrt(want / 65536) + 0.01 / cells + 0.02 * want) << "cell " << i;
    }
    const double ratio = integral / size;
    EXPECT_NEAR(weight.estimate().mean, ratio * ratio, 4 * weight.estimate().error + 5e-3);
    EXPECT_NEAR(x.estimate().mean, 0, 4 * x.estimate().error);
}

double sinc(double x) { return x == 0 ? 1 : std::sin(M_PI * x) / (M_PI * x); }
double mitchell(double x) {
    const double t = std::abs(x), B = 1. / 3, C = 1. / 3;   /* on [-2, 2] */
    if (t < 1) return ((12 - 9 * B - 6 * C) * t * t * t + (-18 + 12 * B + 6 * C) * t * t + 6 - 2 * B) / 6;
    return ((-B - 6 * C) * t * t * t + (6 * B + 30 * C) * t * t + (-12 * B - 48 * C) * t + 8 * B + 24 * C) / 6;
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, Filters,
    testing::Values(FilterCase{"box", "PixelFilter \"box\" \"float xradius\" 1 \"float yradius\" 1", 1, [](double) { return 1.0; }},
                    FilterCase{"triangle", "PixelFilter \"triangle\" \"float xradius\" 2 \"float yradius\" 2", 2,
                               [](double x) { return 2 - std::abs(x); }},
                    FilterCase{"gaussian", "PixelFilter \"gaussian\" \"float xradius\" 1.5 \"float yradius\" 1.5 \"float sigma\" 0.5", 1.5,
                               [](double x) { return std::exp(-2 * x * x) - std::exp(-2 * 2.25); }},
                    FilterCase{"narrow_for_its_radius",
                               "PixelFilter \"gaussian\" \"float xradius\" 9 \"float yradius\" 9 \"float sigma\" 0.4", 9,
                               [](double x) { return std::exp(-x * x / 0.32); }},
                    FilterCase{"mitchell", "PixelFilter \"mitchell\" \"float xradius\" 2 \"float yradius\" 2", 2, mitchell},
                    FilterCase{"sinc", "PixelFilter \"sinc\" \"float xradius\" 4 \"float yradius\" 4 \"float tau\" 3", 4,
                               [](double x) { return std::abs(x) < 4 ? sinc(x) * sinc(x / 3) : 0; }}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace eikonal
