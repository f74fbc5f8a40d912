#include "pack/light_paths.h"

#include "kind_features.h"
#include "kinds/integrator_kind.h"
#include "pack/light_media.h"
#include "pack/light_vertices.h"
#include "pack/missed_light.h"

#include <fmt/format.h>

#include <algorithm>

namespace eikonal {

/// Where a scene contradicts itself about its media, as a clause; empty: nowhere that was looked at.
static std::string contradictionOf(const Scene& scene) {
    const auto found = LightMedia(scene).contradiction();
    if (!found) return {};
    const auto name = [&](int medium) {
        return medium == none ? "vacuum" : fmt::format("medium \"{}\"", scene.media[static_cast<size_t>(medium)].name);
    };
    return fmt::format("by its MediumInterface, the shape at {} has {} on its side towards the camera, and rays from the camera come "
                       "through {}",
                       found->boundary->where.toString(), name(found->said), name(found->found));
}

std::string lightPathObstacle(const PackContext& context) {
    const Scene& scene = context.scene;
    if (context.hasMedia && scene.forcesDiffuse) return "it has participating media and \"forcediffuse\"";
    if (context.hasMedia)
        if (const std::string contradiction = contradictionOf(scene); !contradiction.empty()) return contradiction;
    if (scene.film.spectrum) return "its film keeps spectra, which light paths do not add to yet";
    constexpr double leastRadius = 0.1;   // pixels
    if (std::min(scene.filter.xRadius, scene.filter.yRadius) < leastRadius)
        return "its filter is so narrow that light paths hardly hit what pixels show";
    if (scene.integrator.regularize) return "it regularizes, which depends on where a path begins";
    return {};
}

void requireLightPaths(const PackContext& context, const std::string& why) {
    context.require(Feature::LIGHT_PATHS, why);
    if (context.hasMedia || (!context.scene.forcesDiffuse && std::ranges::any_of(context.scene.materials, &Material::isWalked)))
        context.require(KindFeature::BSDF_HENYEY_GREENSTEIN, why);
    /* Paths that are to find a moving camera know their time */
    if (context.scene.camera.worldFromCameraAtEnd) context.require(Feature::MOTION, why);
}

void chooseLightPaths(const PackContext& context, PackedScene& packed) {
    if (!context.scene.integrator.kind->mayTraceLightPaths) return;
    const std::vector<std::string> missed = lightForLightPaths(packed);
    if (missed.empty() || !lightPathObstacle(context).empty()) return;
    requireLightPaths(context, "otherwise " + missed.front());
    /* What is then seen by way of smooth surfaces, too */
    if (const std::vector<std::string> more = lightForLightPaths(packed); !more.empty())
        requireMerging(context, packed.frame(), "otherwise " + more.front());
}

}  // namespace eikonal
