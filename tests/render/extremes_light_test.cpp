// Lights at the extremes: a strong light that is hidden, a light just above a floor. The camera looks at the origin of the floor y = 0
// (lit_floor.h).

#include "lit_floor.h"

#include <fmt/format.h>

#include <cmath>

namespace eikonal {
namespace {

const std::string smallFloor = "Material \"diffuse\" \"rgb reflectance\" [.5 .5 .5]\n"
    "Shape \"trianglemesh\" \"point3 P\" [-2 0 -2  2 0 -2  2 0 2  -2 0 2] \"integer indices\" [0 1 2 0 2 3]\n";

// Two equal lights at (+-1, 1, 0), but one is 1e9 times as strong, and in a black ball: the other one alone lights the origin. By power as
// by the tree it gets half of LEAST_SHARE of the samples, p, so the relative variance of a sample is 1 / p - 1.
TEST(ExtremeLights, AStrongHiddenOneLeavesTheOthersTheirShare) {
    const std::string lights = R"(LightSource "point" "rgb I" [1 1 1] "point3 from" [-1 1 0]
        LightSource "point" "rgb I" [1e9 1e9 1e9] "point3 from" [1 1 0]
        AttributeBegin Material "diffuse" "rgb reflectance" [0 0 0] Translate 1 1 0 Shape "sphere" "float radius" .1 AttributeEnd
        )";
    View view = atTheOrigin(1);
    view.samples = 1024;
    /* I cos / d^2, at 45 degrees and d^2 = 2 */
    const double expected = rho / pi * std::sqrt(0.5) / 2, samples = view.samples * 256., p = LEAST_SHARE / 2.;
    for (const char* sampler : {"", "\"string lightsampler\" \"power\"", "\"string lightsampler\" \"bvh\""}) {
        SCOPED_TRACE(sampler);
        view.more = fmt::format("Integrator \"path\" \"integer maxdepth\" 1 {}", sampler);
        const Rendered r = render(sceneText(view, lights + smallFloor));
        expectRadiance(r, expected, 0.03);
        /* The standard error is known to 1 / sqrt(2 * 255) of itself from 256 pixels */
        const double error = expected * std::sqrt((1 / p - 1) / samples);
        EXPECT_NEAR(estimate(r.image).error.g, error, standardErrors * error / std::sqrt(510));
    }
}

// A point light of intensity h^2 at height h above a floor, seen in the square of side 2 w = 20 h below it, away from the centre of the
// scene. The mean irradiance of the square is the intensity times the solid angle that the square subtends, which is
// 4 atan(w^2 / (h sqrt(h^2 + 2 w^2))), over its area. All sizes get the same random numbers, so but for rounding they are the same image.
// Points of this scene, of size 2, are rounded by 2^-24 twice: a millionth of h = .1, and all of h = 1e-7.
TEST(ExtremeLights, JustAboveAFloor) {
    const auto below = [](double h, int samples) {
        const double w = 10 * h;
        View view = atTheOrigin(1);
        view.samples = samples;
        view.lookAt = ".3 .5 -.4  .3 0 -.4  0 0 1";
        view.fov = 2 * std::atan(w / .5) * 180 / pi;
        const std::string light = fmt::format("LightSource \"point\" \"rgb I\" [{0:.17g} {0:.17g} {0:.17g}] "
                                              "\"point3 from\" [.3 {1:.17g} -.4]\n", h * h, h);
        const double solidAngle = 4 * std::atan(w * w / (h * std::sqrt(h * h + 2 * w * w)));
        const Estimate seen = estimate(render(sceneText(view, light + smallFloor)).image);
        return seen.mean.g / (rho / pi * h * h * solidAngle / (4 * w * w));
    };
    /* The square's 16 x 16 pixels stratify it; 4,096 samples in each leave 0.1 % */
    EXPECT_NEAR(below(1e-2, 4096), 1, 0.004);
    const double reference = below(1e-2, 64);
    for (double h : {1e-3, 1e-4, 1e-5, 1e-6}) EXPECT_NEAR(below(h, 64), reference, (1e-5 + std::ldexp(4., -24) / h) * reference) << h;
}

}  // namespace
}  // namespace eikonal
