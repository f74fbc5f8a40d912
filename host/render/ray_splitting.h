#pragma once
// The host's side of ray splitting (Feature::RAY_SPLITTING, kernels/shade/ray_splitting.clh).

#include "device/kernel.h"
#include "pack/tables.h"

#include <algorithm>
#include <vector>

namespace eikonal {

/// The number of rays that a camera path may split into. Several rays may leave a hit, and each has its own path state.
/// The defaults mean no splitting: a path is one ray with one state.
struct RaySplitting {
    unsigned splits = 0;         ///< log2 of the path states, and of the most rays, of a camera path
    unsigned raysPerHit = 1;     ///< the most rays that leave a hit
    unsigned shadingPasses = 1;  ///< shading passes per bounce: the larger number of rays per hit and sampled lights

    static RaySplitting of(const PackedScene& scene);

    /// Camera paths that can begin at once with room for `rays` rays; at least one.
    unsigned pathsIn(unsigned rays) const { return std::max(rays >> splits, 1u); }
    unsigned statesOf(unsigned paths) const { return paths << splits; }
    /// Batches in flight: `most`, or one if paths split.
    unsigned batches(unsigned most) const { return splits ? 1 : most; }
    /// New paths begin only if at least this many of `slots` slots are free. If paths split, all must be free, since the number of rays is
    /// not known in advance.
    unsigned leastRoom(unsigned slots) const { return splits ? slots : slots / 16; }
    /// If paths split, zeroes the path states, because a ray tree writes only the states that its rays reach. Enqueues.
    void clearStates(const Context& context, Buffer& paths) const;
    /// The arguments of each shading pass over `hits` slots. `rays` is the queue of this bounce, which is no longer read.
    std::vector<Bindings> passes(unsigned hits, const Buffer& rays) const;
};

}  // namespace eikonal
