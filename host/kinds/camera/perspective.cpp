// Perspective camera: a pinhole or a thin lens (kernels/camera/perspective.clh).

#include "kinds/camera_packing.h"
#include <cmath>

namespace eikonal {

static void read(const pbrt::CameraReading& in, CameraDescription& camera) { camera.fov = in.arguments.number("fov"); }

static void pack(const CameraPacking& in, const CameraDescription& description, camera& view) {
    packScreen(in.context, description, std::tan(glm::radians(description.fov) / 2), view);
}

static std::optional<glm::dvec2> project(const PackedScene&, glm::dvec3 p) {
    return p.z > 0 ? std::optional(glm::dvec2(p) / p.z) : std::nullopt;
}

const CameraTraits perspective_camera{
    .parameters = "float fov = 90 in (0, 180)", .read = read, .pack = pack, .project = project, .hasThinLens = true};

}  // namespace eikonal
