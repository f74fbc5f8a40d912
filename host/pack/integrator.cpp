// What the integrator makes of a scene: which of its parts count, and the numbers that its stages read.

#include "names.h"
#include "pack/pack.h"
#include "pack/packer.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace eikonal {

static_assert(mostTreeRays == MOST_TREE_RAYS);

static std::string titleOf(const IntegratorDescription& integrator) {
    return fmt::format("integrator \"{}\"", nameIn(integratorNames, integrator.kind));
}

bool countsMedia(const IntegratorDescription& integrator) { return integrator.kind == IntegratorKind::volpath; }
bool countsMaterials(const IntegratorDescription& integrator) { return integrator.kind != IntegratorKind::ambientOcclusion; }
bool samplesLights(const IntegratorDescription& integrator) {
    if (integrator.kind == IntegratorKind::randomWalk) return false;
    return integrator.kind != IntegratorKind::simplePath || integrator.sampleLights;
}
bool followsBsdfs(const IntegratorDescription& integrator) {
    switch (integrator.kind) {
        case IntegratorKind::volpath: case IntegratorKind::path: case IntegratorKind::direct: return true;
        case IntegratorKind::simplePath: return integrator.sampleBsdf;
        case IntegratorKind::whitted: case IntegratorKind::ambientOcclusion: case IntegratorKind::randomWalk: return false;
    }
    return false;
}

/// The most scattering events that the field `depth` of a ray has room for beside the number of its branch (kernels/math/dimension.clh).
constexpr int mostTreeDepth = 0xffff;

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
    int depth = std::max(integrator.maxDepth, 0);
    switch (integrator.kind) {
        case IntegratorKind::volpath: case IntegratorKind::path: break;
        case IntegratorKind::direct: depth = std::min(depth, 1); break;
        case IntegratorKind::ambientOcclusion:
            depth = 1;
            packer.packed.require(Feature::AMBIENT_OCCLUSION, why);
            frame.ambient = packEmission(packer, Spectrum::rgb(glm::dvec3(1), integrator.colorSpace));
            frame.ambient_distance = integrator.maxDistance > 0
                                         ? static_cast<float>(std::min(integrator.maxDistance * packer.space.scale, double{FAR_AWAY}))
                                         : FAR_AWAY;
            frame.ambient_cosine = integrator.cosine;
            break;
        case IntegratorKind::simplePath: case IntegratorKind::randomWalk:
            if (integrator.kind == IntegratorKind::randomWalk || !integrator.sampleBsdf)
                packer.packed.require(Feature::UNIFORM_DIRECTIONS, why);
            break;
        case IntegratorKind::whitted:
            depth = std::min(depth, mostTreeDepth);
            packer.packed.require(Feature::TREE, why);
            frame.tree_splits = static_cast<uint>(std::countr_zero(static_cast<unsigned>(integrator.rays)));
            frame.rough_splits = integrator.bundle ? static_cast<uint>(std::countr_zero(static_cast<unsigned>(integrator.bundle))) : NONE;
            frame.tree_threshold = static_cast<float>(integrator.threshold);
            break;
    }
    frame.max_depth = static_cast<uint>(depth);
    packer.packed.roulette = integrator.roulette;
    setRoulette(frame, integrator.roulette.value_or(Roulette()));
}

void setRoulette(settings& frame, const Roulette& roulette) {
    frame.roulette_root = roulette.rule == RouletteRule::root;
    frame.roulette_scale = static_cast<float>(roulette.scale);
    frame.roulette_depth = static_cast<uint>(roulette.depth);
}

}  // namespace eikonal
