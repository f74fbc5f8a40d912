#include "pack/sampler.h"

#include <algorithm>
#include <bit>
#include <stdexcept>

namespace eikonal {

/// How the numbers of paths are generated (kernels/math/random.clh).
struct Sequences {
    SamplerKind kind;
    bool isSobol;          ///< Sobol' sequences; otherwise independent numbers
    bool hasJointPairs;    ///< the most important pairs of dimensions are stratified jointly
    bool hasTiles;         ///< neighbouring pixels share one sequence
};
static constexpr Sequences sequences[] = {
    {SamplerKind::independent, false, false, false},
    {SamplerKind::paddedsobol, true, false, false},
    {SamplerKind::sobol, true, true, false},
    {SamplerKind::zsobol, true, true, true},
};
static_assert(std::ranges::all_of(samplerNames, [](const auto& named) {
    return std::ranges::count(sequences, named.second, &Sequences::kind) == 1;
}));

static const Sequences& sequencesOf(SamplerKind kind) {
    const auto found = std::ranges::find(sequences, kind, &Sequences::kind);
    if (found == std::end(sequences)) throw std::logic_error("this sampler has no line in `sequences`");
    return *found;
}

void packSampler(const PackContext& context, settings& frame) {
    const SamplerDescription& sampler = context.scene.sampler;
    const Sequences& use = sequencesOf(sampler.kind);
    frame.seed = static_cast<uint>(sampler.seed);
    if (use.hasTiles) {
        /* The indices of a tile's samples fit in 32 bits */
        frame.sequence_sample_bits = static_cast<uint>(std::bit_width(static_cast<uint>(std::max(sampler.pixelSamples, 1)) - 1));
        frame.sequence_tile_bits = std::min(8u, (32 - frame.sequence_sample_bits) / 2);
    }
    if (use.isSobol) context.require(Feature::SOBOL, sampler.where.toString());
    if (use.hasJointPairs) context.require(Feature::JOINT_PAIRS, sampler.where.toString());
}

}  // namespace eikonal
