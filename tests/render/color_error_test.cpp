// What is predicted of RGB rendering, against what it does.

#include "rendering.h"

#include "diagnostics.h"
#include "pack/rgb_error.h"
#include "pack/scene_bounds.h"
#include "read/pbrt/read_pbrt.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace eikonal {
namespace {

/// Of the image's mean, the channel that is most off, as it is defined for the prediction: a channel may be negative, outside of sRGB.
double measured(const std::string& text) {
    const glm::dvec3 rgb = estimate(render(packScene(text, ColorMode::rgb)).image).mean,
                     spectral = estimate(render(packScene(text, ColorMode::spectral)).image).mean;
    const glm::dvec3 off = glm::abs(rgb - spectral) / glm::max(spectral, 0.02 * std::max({spectral.x, spectral.y, spectral.z}));
    return std::max({off.x, off.y, off.z});
}

double predicted(const std::string& text) {
    Diagnostics diagnostics(LogLevel::silent, true);
    const Scene scene = readPbrtText(text, "test.pbrt", ".", diagnostics);
    return predictRgbError(scene, {}, boundsOf(scene).near).worst;
}

std::string ball(const std::string& sun, const std::string& material) {
    View view;
    view.lookAt = "0 0 -3  0 0 0  0 1 0";
    view.width = view.height = 16;
    view.samples = 256;
    view.sampler = "zsobol";
    return sceneText(view, "LightSource \"infinite\" \"rgb L\" " + sun + "\n" + material + "\nShape \"sphere\" \"float radius\" 1.5");
}

std::string diffuse(const std::string& color) { return "Material \"diffuse\" \"rgb reflectance\" " + color; }

// From grey to saturated, a ball that fills the view under light of ever more colour: RGB is further off each time, and the prediction is
// right to a third of the error and the noise of 65,536 samples, 1 %.
TEST(ColorError, IsAsPredicted) {
    double before = -1;
    for (const auto& [sun, color] : {std::pair("[3 2 1]", "[.5 .5 .5]"), std::pair("[1 .8 .6]", "[.4 .5 .6]"),
                                     std::pair("[1 .5 .2]", "[.3 .6 .3]"), std::pair("[1 .1 .05]", "[.1 .6 .05]")}) {
        const std::string scene = ball(sun, diffuse(color));
        const double expected = predicted(scene), found = measured(scene);
        EXPECT_NEAR(expected, found, 0.01 + found / 3) << sun << " on " << color;
        EXPECT_GT(expected, before) << sun << " on " << color;
        before = expected;
    }
    EXPECT_GT(before, 0.1);
}

}  // namespace
}  // namespace eikonal
