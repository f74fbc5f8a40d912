#include "pack/integrator.h"

#include "kinds/integrator_kind.h"
#include "pack/pack.h"
#include "pack/path_guide.h"

#include <fmt/format.h>

#include <algorithm>

namespace eikonal {

static std::string titleOf(const IntegratorDescription& d) { return fmt::format("integrator \"{}\"", d.kind->name); }

void packIntegrator(const IntegratorPacking& in, bool hasUnusedMedia) {
    const IntegratorDescription& integrator = in.context.scene.integrator;
    const std::string title = titleOf(integrator), why = integrator.where.toString() + ": " + title;
    if (hasUnusedMedia)
        in.context.diagnostics.warn(
            integrator.where, title + " ignores the participating media of the scene (as in pbrt-v4); \"volpath\" renders them");

    in.frame.max_depth = static_cast<uint>(std::clamp(integrator.maxDepth, integrator.kind->leastDepth, integrator.kind->mostDepth));
    if (integrator.kind->pack) integrator.kind->pack(in, integrator, why);
    setRoulette(in.frame, integrator.roulette.value_or(Roulette()));
}

/// Half of the directions: as good as either alone within a factor of two.
constexpr float guidedShare = 0.5f;
/// Paths of a render for which it pays to find out whether a guide does: pilot paths are less than a hundredth of them.
constexpr double leastPathsToTry = 0x1p25;

void packPathGuide(const PackContext& context, PackedScene& packed) {
    const IntegratorDescription& integrator = context.scene.integrator;
    if (integrator.guiding == PathGuiding::off) return;
    packed.isGuideOptional = integrator.guiding == PathGuiding::automatic;
    const double paths = packed.paths();
    /* Layered BSDFs are not guided, so the pilot cannot tell what their directions gain */
    if (packed.isGuideOptional && (paths < leastPathsToTry || context.has(Feature::LAYERS))) return;
    const char* obstacle = !followsBsdfs(integrator)                ? "this integrator does not sample BSDFs along paths"
                           : context.has(Feature::LIGHT_PATHS)      ? "paths from the lights must know how all others are sampled"
                           : packed.frame().max_depth <= 1          ? "paths have one vertex"
                           : guidePilotPaths(paths) == 0            ? "there is too little to learn from so few paths"
                                                                    : nullptr;
    if (obstacle && packed.isGuideOptional) return;
    if (obstacle) {
        context.diagnostics.warn({}, fmt::format("--guiding has no effect here: {}", obstacle));
        return;
    }
    context.require(Feature::PATH_GUIDE, "--guiding");
    packUnlearnedPathGuide(packed.tables);
    packed.frame().guided_share = guidedShare;
}

void dropPathGuide(PackedScene& packed) {
    /* Its tables and settings stay, which make the identity of a render */
    packed.features = packed.features.without(Feature::PATH_GUIDE);
}

void setRoulette(settings& frame, const Roulette& roulette) {
    frame.roulette_root = roulette.rule == RouletteRule::root;
    frame.roulette_scale = static_cast<float>(roulette.scale);
    frame.roulette_depth = static_cast<uint>(roulette.depth);
}

}  // namespace eikonal
