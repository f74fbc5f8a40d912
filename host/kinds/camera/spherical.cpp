// Spherical camera: all directions around a point, by one of two mappings to the image (kernels/camera/spherical.clh).

#include "kinds/camera_packing.h"
#include "image/equal_area.h"

#include <cmath>

namespace eikonal {

static void read(const pbrt::CameraReading& in, CameraDescription& camera) {
    camera.equalArea = in.arguments.text("mapping") == "equalarea";
}

static void pack(const CameraPacking& in, const CameraDescription& description, camera& view) {
    view.step_x = 1 / static_cast<float>(in.context.scene.film.width);
    view.step_y = 1 / static_cast<float>(in.context.scene.film.height);
    view.equal_area = description.equalArea;
}

static std::optional<glm::dvec2> project(const PackedScene& scene, glm::dvec3 p) {
    if (p == glm::dvec3(0)) return std::nullopt;
    if (scene.frame().view.equal_area) return squareFromDirection({p.x, p.z, p.y});
    const double turn = std::atan2(p.z, p.x) / (2 * M_PI);
    return glm::dvec2(turn - std::floor(turn), std::acos(glm::clamp(p.y / glm::length(p), -1.0, 1.0)) / M_PI);
}

static bool wrapsAround(const camera& view) { return !view.equal_area; }

const CameraTraits spherical_camera{
    .parameters = "string mapping = equalarea in {equalarea, equirectangular}",
    .read = read, .pack = pack, .project = project, .wrapsAround = wrapsAround,
    .version3Name = "environment"};

}  // namespace eikonal
