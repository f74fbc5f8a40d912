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
    if (!integrator.standsFor.empty())
        in.context.diagnostics.unsupported(
            "integrator", integrator.where,
            fmt::format("integrator \"{}\" is not rendered; \"volpath\" computes the same by its own means", integrator.standsFor));
    if (hasUnusedMedia)
        in.context.diagnostics.warn(
            integrator.where, title + " leaves out participating media (as in pbrt-v4), and the scene has some; \"volpath\" renders them");

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
