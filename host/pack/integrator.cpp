#include "pack/integrator.h"

#include "kinds/integrator_kind.h"
#include "pack/pack.h"

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

void setRoulette(settings& frame, const Roulette& roulette) {
    frame.roulette_root = roulette.rule == RouletteRule::root;
    frame.roulette_scale = static_cast<float>(roulette.scale);
    frame.roulette_depth = static_cast<uint>(roulette.depth);
}

}  // namespace eikonal
