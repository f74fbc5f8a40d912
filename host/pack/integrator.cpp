// What the integrator makes of a scene: which of its parts count, and the numbers that its stages read.

#include "kinds/integrator_kind.h"
#include "pack/pack.h"
#include "pack/packer.h"

#include <fmt/format.h>

#include <algorithm>

namespace eikonal {

static std::string titleOf(const IntegratorDescription& d) { return fmt::format("integrator \"{}\"", d.kind->name); }

bool countsMedia(const IntegratorDescription& d) { return d.kind->countsMedia; }
bool countsMaterials(const IntegratorDescription& d) { return d.kind->countsMaterials; }
bool samplesLights(const IntegratorDescription& d) { return !d.kind->samplesLights || d.kind->samplesLights(d); }
bool followsBsdfs(const IntegratorDescription& d) { return d.kind->followsBsdfs && d.kind->followsBsdfs(d); }

void packIntegrator(Packer& packer, bool hasUnusedMedia) {
    const IntegratorDescription& integrator = packer.scene.integrator;
    const std::string title = titleOf(integrator), why = integrator.where.toString() + ": " + title;
    if (!integrator.standsFor.empty())
        packer.diagnostics.unsupported(
            "integrator", integrator.where,
            fmt::format("integrator \"{}\" is not rendered; \"volpath\" computes the same by its own means", integrator.standsFor));
    if (hasUnusedMedia)
        packer.diagnostics.warn(
            integrator.where, title + " leaves out participating media (as in pbrt-v4), and the scene has some; \"volpath\" renders them");

    settings& frame = packer.packed.frame();
    frame.max_depth = static_cast<uint>(std::clamp(integrator.maxDepth, integrator.kind->leastDepth, integrator.kind->mostDepth));
    if (integrator.kind->pack) integrator.kind->pack(packer, integrator, why);
    packer.packed.roulette = integrator.roulette;
    setRoulette(frame, integrator.roulette.value_or(Roulette()));
}

void setRoulette(settings& frame, const Roulette& roulette) {
    frame.roulette_root = roulette.rule == RouletteRule::root;
    frame.roulette_scale = static_cast<float>(roulette.scale);
    frame.roulette_depth = static_cast<uint>(roulette.depth);
}

}  // namespace eikonal
