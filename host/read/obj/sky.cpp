#include "kinds/light_kind.h"
#include "read/obj/sky.h"

#include "image/equal_area.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace eikonal {
namespace {

using std::numbers::pi;

// 45 degrees high, 50 degrees to the left of the viewer's direction, as seen by the viewer.
const glm::dvec3 sunDirection{std::cos(pi / 4) * std::cos(50 * pi / 180), -std::cos(pi / 4) * std::sin(50 * pi / 180), std::sin(pi / 4)};
constexpr double sunRadius = 5 * pi / 180;

// Irradiance on a horizontal surface: pi * 0.45 from the sun, about pi * 0.35 from the sky.
const glm::dvec3 sunColor{1.08, 1.0, 0.86};
const double sunRadiance = 0.45 / (std::sin(pi / 4) * std::pow(std::sin(sunRadius), 2));

const glm::dvec3 zenith{0.16, 0.27, 0.5}, horizon{0.62, 0.7, 0.78}, ground{0.2, 0.18, 0.16};

double smoothStep(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0., 1.);
    return t * t * (3 - 2 * t);
}

/// Of the sky and the ground at a height z of the direction, without the sun.
glm::dvec3 backgroundRadiance(double z) {
    const double skyShare = smoothStep(-0.02, 0.02, z);
    if (skyShare == 0) return ground;
    return glm::mix(ground, glm::mix(horizon, zenith, std::pow(std::max(z, 0.), 0.6)), skyShare);
}

}  // namespace

glm::dvec3 skyRadiance(glm::dvec3 d) {
    const double angle = std::acos(std::clamp(glm::dot(d, sunDirection), -1., 1.));
    return backgroundRadiance(d.z) + sunColor * sunRadiance * (1 - smoothStep(0.85 * sunRadius, 1.15 * sunRadius, angle));
}

/// The image of skyRadiance. Without the sun it is symmetric, so an eighth of it is computed, and the rest where the sun is.
static ImageData skyImage() {
    constexpr SquareGrid grid{.resolution = 512, .samples = 3};
    constexpr int n = grid.resolution;
    ImageData image{.width = n, .height = n, .channels = 3, .format = format_float};
    image.floats.resize(std::size_t(3) * n * n);
    const auto set = [&](int x, int y, const glm::dvec3& value) {
        for (int c = 0; c < 3; ++c) image.floats[(std::size_t(y) * n + x) * 3 + c] = static_cast<float>(value[c]);
    };
    tbb::parallel_for(0, n / 2, [&](int y) {
        for (int x = y; x < n / 2; ++x) {
            const glm::dvec3 value = texelOfSquare(grid, x, y, [](glm::dvec2 p) { return backgroundRadiance(heightFromSquare(p)); });
            for (const auto& [i, j] : {std::pair(x, y), {y, x}})
                for (const int column : {i, n - 1 - i})
                    for (const int row : {j, n - 1 - j}) set(column, row, value);
        }
    });
    /* A disc of the sun's solid angle has this radius in the square; the map stretches no direction to twice that of the area */
    const double radius = 2 * std::sqrt(std::pow(std::sin(1.15 * sunRadius / 2), 2) / pi);
    const glm::dvec2 sun = squareFromDirection(sunDirection);
    const glm::ivec2 low((sun - radius) * double(n)), high((sun + radius) * double(n));
    tbb::parallel_for(low.y, high.y + 1, [&](int y) {
        for (int x = low.x; x <= high.x; ++x)
            set(x, y, texelOfSquare(grid, x, y, [](glm::dvec2 p) { return skyRadiance(directionFromSquare(p)); }));
    });
    return image;
}

void addSky(Scene& scene, glm::dvec3 up, glm::dvec3 towardsViewer) {
    const glm::dvec3 z = glm::normalize(up);
    glm::dvec3 x = towardsViewer - glm::dot(towardsViewer, z) * z;
    if (glm::length(x) < 1e-6 * glm::length(towardsViewer))
        x = glm::cross(z, std::abs(z.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
    x = glm::normalize(x);

    ImageFile image{.path = "sky", .wrap = wrap_octahedral};
    image.pixels = std::make_shared<ImageData>(skyImage());
    scene.images.push_back(std::move(image));
    Light light;
    light.kind = &kindOf(kind_image_infinite_light);
    light.image = static_cast<int>(scene.images.size()) - 1;
    light.worldFromLight = Transform(glm::dvec4(x, 0), glm::dvec4(glm::cross(z, x), 0), glm::dvec4(z, 0), glm::dvec4(0, 0, 0, 1));
    scene.lights.push_back(std::move(light));
}

}  // namespace eikonal
