#include "kinds/light_kind.h"
#include "read/obj/sky.h"

#include "image/equal_area.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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

}  // namespace

glm::dvec3 skyRadiance(glm::dvec3 d) {
    const glm::dvec3 sky = glm::mix(horizon, zenith, std::pow(std::max(d.z, 0.), 0.6));
    const glm::dvec3 background = glm::mix(ground, sky, smoothStep(-0.02, 0.02, d.z));
    const double angle = std::acos(std::clamp(glm::dot(d, sunDirection), -1., 1.));
    return background + sunColor * sunRadiance * (1 - smoothStep(0.85 * sunRadius, 1.15 * sunRadius, angle));
}

void addSky(Scene& scene, glm::dvec3 up, glm::dvec3 towardsViewer) {
    const glm::dvec3 z = glm::normalize(up);
    glm::dvec3 x = towardsViewer - glm::dot(towardsViewer, z) * z;
    if (glm::length(x) < 1e-6 * glm::length(towardsViewer))
        x = glm::cross(z, std::abs(z.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
    x = glm::normalize(x);

    ImageFile image{.path = "sky", .wrap = wrap_octahedral};
    image.pixels = std::make_shared<ImageData>(equalAreaImage(512, 3, skyRadiance));
    scene.images.push_back(std::move(image));
    Light light;
    light.kind = &kindOf(kind_image_infinite_light);
    light.image = static_cast<int>(scene.images.size()) - 1;
    light.worldFromLight = Transform(glm::dvec4(x, 0), glm::dvec4(glm::cross(z, x), 0), glm::dvec4(z, 0), glm::dvec4(0, 0, 0, 1));
    scene.lights.push_back(std::move(light));
}

}  // namespace eikonal
