#include "pack/sampler.h"

#include <algorithm>
#include <bit>

namespace eikonal {

void packSampler(const PackContext& context, settings& frame) {
    const SamplerDescription& sampler = context.scene.sampler;
    frame.seed = static_cast<uint>(sampler.seed);
    if (sampler.kind == SamplerKind::zsobol) {
        /* The indices of a tile's samples fit in 32 bits */
        frame.sequence_sample_bits = static_cast<uint>(std::bit_width(static_cast<uint>(std::max(sampler.pixelSamples, 1)) - 1));
        frame.sequence_tile_bits = std::min(8u, (32 - frame.sequence_sample_bits) / 2);
    }
    if (sampler.kind != SamplerKind::independent) context.require(Feature::SOBOL, sampler.where.toString());
    if (sampler.kind == SamplerKind::sobol || sampler.kind == SamplerKind::zsobol)
        context.require(Feature::JOINT_PAIRS, sampler.where.toString());
}

}  // namespace eikonal
