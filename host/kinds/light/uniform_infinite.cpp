// Uniform infinite light (kernels/light/uniform_infinite.clh). Also reads the directive "infinite" for lights with an image or a portal.

#include "kinds/light_packing.h"
#include "kinds/light_reading.h"

#include <algorithm>
#include <cmath>

namespace eikonal {

/// The corners of a portal. Throws SceneError if they do not form a rectangle.
static std::array<glm::dvec3, 4> readPortal(const pbrt::Arguments& arguments) {
    const std::vector<glm::dvec3> corners = arguments.points3("portal");
    if (corners.size() != 4)
        throw SceneError(arguments.whereOf("portal"), "a portal has 4 corners; here are " + std::to_string(corners.size()));
    const std::array<glm::dvec3, 4> p{corners[0], corners[1], corners[2], corners[3]};
    const glm::dvec3 x = p[3] - p[0], y = p[1] - p[0], across = p[2] - p[1], up = p[2] - p[3];
    const double size = std::max(glm::length(x), glm::length(y));
    const bool isRectangle = std::min(glm::length(x), glm::length(y)) > 0 && glm::length(across - x) <= 1e-3 * size &&
                             glm::length(up - y) <= 1e-3 * size && std::abs(glm::dot(x, y)) <= 1e-3 * glm::length(x) * glm::length(y);
    if (!isRectangle)
        throw SceneError(arguments.whereOf("portal"),
                         "the corners of a portal must form a rectangle, in order around its edge");
    return p;
}

static bool read(const pbrt::LightReading& in, Light& light) {
    const pbrt::Arguments& arguments = in.arguments;
    const std::optional<double> illuminance = strengthOf(in.reading, arguments, "illuminance");
    const bool hasImage = arguments.has("filename");
    if (hasImage && arguments.has("L"))
        throw SceneError(arguments.whereOf("L"), "light \"infinite\" has either \"L\" or \"filename\", not both");
    if (hasImage && !readImage(in, wrap_octahedral, light)) return false;
    light.spectrum = arguments.spectrum("L", whiteOf(arguments));
    if (hasImage) light.kind = &kindOf(kind_image_infinite_light);
    if (arguments.has("portal")) {
        light.kind = &kindOf(kind_portal_infinite_light);
        light.portal = readPortal(arguments);
    }
    if (hasImage) light.illuminance = illuminance;
    else if (illuminance) light.scale *= *illuminance / M_PI;
    return true;
}

static PackedLight pack(const LightPacking& in, const Light& d) {
    const double power = 4 * M_PI * M_PI * sceneRadius(in.context) * sceneRadius(in.context) * luminanceOf(d.spectrum, d.scale);
    return {newLight(kind_uniform_infinite_light, in.colors.emission(d.spectrum, d.scale)), power};
}

const LightTraits uniform_infinite_light{.directive = "infinite",
                                         .parameters = "spectrum L; file filename; float illuminance = -1; point3s portal",
                                         .read = read,
                                         .pack = pack,
                                         .isLeftToBsdfs = true};

}  // namespace eikonal
