#include "pack/light_paths.h"

#include "kinds/camera_kind.h"
#include "kinds/material_kind.h"

#include <fmt/format.h>

#include <algorithm>

namespace eikonal {

std::string lightPathObstacle(const PackContext& context) {
    const Scene& scene = context.scene;
    const CameraKind& camera = kindOf(scene.camera);
    if (camera.rays == CameraRays::ANY) return fmt::format("they cannot be connected to a \"{}\" camera yet", camera.name);
    if (context.hasMedia) return "it has participating media, which light paths do not cross yet";
    if (std::ranges::any_of(scene.materials, [](const Material& m) { return m.interior || m.diffusion; }))
        return "it has subsurface scattering, which light paths do not enter yet";
    if (scene.film.spectrum) return "its film keeps spectra, which light paths do not add to yet";
    if (scene.integrator.regularize) return "it regularizes, which depends on where a path begins";
    return {};
}

}  // namespace eikonal
