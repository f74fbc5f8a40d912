#include "pack/light_paths.h"

#include "kinds/camera_kind.h"
#include "kinds/integrator_kind.h"
#include "pack/light_vertices.h"
#include "pack/missed_light.h"

#include <fmt/format.h>

#include <algorithm>

namespace eikonal {

std::string lightPathObstacle(const PackContext& context) {
    const Scene& scene = context.scene;
    const CameraKind& camera = kindOf(scene.camera);
    if (camera.rays == CameraRays::ANY) return fmt::format("they cannot be connected to a \"{}\" camera yet", camera.name);
    if (context.hasMedia) return "it has participating media, which light paths do not cross yet";
    if (!scene.forcesDiffuse && std::ranges::any_of(scene.materials, [](const Material& m) { return m.interior || m.diffusion; }))
        return "it has subsurface scattering, which light paths do not enter yet";
    if (scene.film.spectrum) return "its film keeps spectra, which light paths do not add to yet";
    if (scene.integrator.regularize) return "it regularizes, which depends on where a path begins";
    return {};
}

void requireLightPaths(const PackContext& context, const std::string& why) {
    context.require(Feature::LIGHT_PATHS, why);
    /* Paths that are to find a moving camera know their time */
    if (context.scene.camera.worldFromCameraAtEnd) context.require(Feature::MOTION, why);
}

void chooseLightPaths(const PackContext& context, PackedScene& packed) {
    if (!context.scene.integrator.kind->mayTraceLightPaths) return;
    const std::vector<std::string> missed = missedLight(packed);
    if (missed.empty() || !lightPathObstacle(context).empty()) return;
    requireLightPaths(context, "otherwise " + missed.front());
    /* What is then seen by way of smooth surfaces, too */
    if (const std::vector<std::string> more = missedLight(packed); !more.empty() && mergingObstacle(context).empty())
        requireMerging(context, packed.frame(), "otherwise " + more.front());
}

}  // namespace eikonal
