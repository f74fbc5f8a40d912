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

/// Clips at the depths 0.01 and 1000.
static glm::dmat4 screenFromCamera(const CameraDescription& camera) {
    constexpr double near = 1e-2, far = 1000;
    const double scale = 1 / std::tan(glm::radians(camera.fov) / 2);
    return {{scale, 0, 0, 0}, {0, scale, 0, 0}, {0, 0, far / (far - near), 1}, {0, 0, -far * near / (far - near), 0}};  // columns
}

const CameraTraits perspective_camera{.parameters = "float fov = 90 in (0, 180)",
                                      .read = read,
                                      .pack = pack,
                                      .project = project,
                                      .screenFromCamera = screenFromCamera,
                                      .hasThinLens = true};

}  // namespace eikonal
