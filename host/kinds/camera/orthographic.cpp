// Orthographic camera: parallel rays through a screen (kernels/camera/orthographic.clh).

#include "kinds/camera_packing.h"

namespace eikonal {

static void pack(const CameraPacking& in, const CameraDescription& description, camera& view) {
    packScreen(in.context, description, 1 / in.unit, view);
}

static std::optional<glm::dvec2> project(const PackedScene&, glm::dvec3 p) { return p.z > 0 ? std::optional(glm::dvec2(p)) : std::nullopt; }

/// Clips at the depths 0 and 1.
static glm::dmat4 screenFromCamera(const CameraDescription&) { return glm::dmat4(1); }

const CameraTraits orthographic_camera{
    .parameters = "", .pack = pack, .project = project, .screenFromCamera = screenFromCamera, .hasThinLens = true};

}  // namespace eikonal
