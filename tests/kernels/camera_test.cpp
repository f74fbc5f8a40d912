// Camera rays: through their pixel, through the lens, by the filter's importance.

#include "device_function.h"
#include "random_inputs.h"
#include "stage.h"
#include "statistics.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace eikonal {
namespace {

struct CameraResult { vec3 o, d; float weight; };

/// n samples of pixel (x, y) of a scene without anything but a camera; o and d in camera space, in double precision d.z = 1.
struct CameraSample { glm::dvec3 o, d; double weight; };
std::vector<CameraSample> drawRays(const std::string& head, uint x, uint y, size_t n) {
    const PackedScene scene = packText(head + "\nWorldBegin\nLightSource \"point\"\n");
    const DeviceFunction<CameraResult> function({.include = "camera/camera.clh", .type = "camera_result",
        .body = "camera_tables tables = BIND_CAMERA; camera_sample s = generate_ray(tables, frame, x, y, sample, 0u);"
                "result.o = s.ray.o; result.d = s.ray.d; result.weight = s.weight;",
        .inputs = {"uint x", "uint y", "uint sample"}, .declarations = "typedef struct { vec3 o, d; float weight; } camera_result;",
        .tables = "CAMERA_ARGUMENTS __global const settings *frame,", .features = scene.features});
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
        rays.push_back({o, d / d.z, static_cast<double>(r.weight)});
    }
    return rays;
}

constexpr const char* view = R"(
    LookAt 3 1 -5  0 0.5 0  0 1 0
    Film "rgb" "integer xresolution" 40 "integer yresolution" 30
    PixelFilter "box" "float xradius" 0.5 "float yradius" 0.5
    Sampler "sobol"
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
    for (const CameraSample& r : drawRays(std::string(view) + "Camera \"perspective\" \"float fov\" 90 \"float lensradius\" 0.2 \"float focaldistance\" 4", 12, 7, 4096)) {
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

struct FilterCase { std::string name, text; double radius; std::function<double(double)> value; };
void PrintTo(const FilterCase& c, std::ostream* out) { *out << c.name; }
class Filters : public testing::TestWithParam<FilterCase> {};

/// Offsets follow the size of the filter, weights its sign: chi-square over the offset along x, and the mean weight is the
/// integral of the filter over that of its size, for both axes together.
TEST_P(Filters, AreSampledByImportance) {
    const FilterCase& f = GetParam();
    const std::string head = std::string(view) + f.text + "\nCamera \"perspective\" \"float fov\" 90";
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
    /* The device holds 64 cells of constant density: what 48 cells expect of it differs by their slopes, as little as the tolerance below */
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

INSTANTIATE_TEST_SUITE_P(Kinds, Filters, testing::Values(
    FilterCase{"box", "PixelFilter \"box\" \"float xradius\" 1 \"float yradius\" 1", 1, [](double) { return 1.0; }},
    FilterCase{"triangle", "PixelFilter \"triangle\" \"float xradius\" 2 \"float yradius\" 2", 2, [](double x) { return 2 - std::abs(x); }},
    FilterCase{"gaussian", "PixelFilter \"gaussian\" \"float xradius\" 1.5 \"float yradius\" 1.5 \"float sigma\" 0.5", 1.5,
               [](double x) { return std::exp(-2 * x * x) - std::exp(-2 * 2.25); }},
    FilterCase{"mitchell", "PixelFilter \"mitchell\" \"float xradius\" 2 \"float yradius\" 2", 2, mitchell},
    FilterCase{"sinc", "PixelFilter \"sinc\" \"float xradius\" 4 \"float yradius\" 4 \"float tau\" 3", 4, [](double x) { return std::abs(x) < 4 ? sinc(x) * sinc(x / 3) : 0; }}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace eikonal
