#pragma once
// What trees of rays need on the host (Feature::RAY_SPLITTING, kernels/shade/ray_splitting.clh).

#include "device/kernel.h"
#include "pack/tables.h"

#include <algorithm>
#include <vector>

namespace eikonal {

/// How many rays a camera path may become: several rays may leave a hit, and each ray of a tree has a path state of its own.
/// The defaults are those of a scene without trees: a path is one ray with one state.
struct RaySplitting {
    unsigned splits = 0;         ///< times that a path may split on its way: it has 2^splits states and at most as many rays
    unsigned raysPerHit = 1;     ///< rays that may leave a hit
    unsigned shadingPasses = 1;  ///< shading runs once for each of these rays and for each light that is sampled, whichever are more

    static RaySplitting of(const PackedScene& scene);

    /// Camera paths that begin at once if there is room for `rays`, at least one.
    unsigned pathsIn(unsigned rays) const { return std::max(rays >> splits, 1u); }
    unsigned statesOf(unsigned paths) const { return paths << splits; }
    /// Batches in flight: one, if paths split.
    unsigned batches(unsigned most) const { return splits ? 1 : most; }
    /// The fewest free slots, of `slots` in all, in which new paths begin. If paths split, all must be free: how many rays they become
    /// is not known.
    unsigned leastRoom(unsigned slots) const { return splits ? slots : slots / 16; }
    /// Zeroes the path states, if paths split: a tree writes only the states that its rays reach. Enqueues.
    void clearStates(const Context& context, Buffer& paths) const;
    /// The arguments of each shading pass over `hits` slots. `rays` is the queue of this bounce, which is no longer read.
    std::vector<Bindings> passes(unsigned hits, const Buffer& rays) const;
};

}  // namespace eikonal
