#pragma once
// Learns the path guide of a scene from pilot paths.

#include "pack/tables.h"
#include "render/wave.h"

#include <optional>

namespace eikonal {

/// What is learned for one device serves the others.
struct LearnedPathGuide {
    LightTables tables;   ///< path_guide_nodes and path_guide_aliases; empty: nothing was learned
    /// The variance of paths without the guide over that of paths with it, as far as a few thousand paths tell. Of an optional guide
    /// (PackedScene::isGuideOptional), if the pilot came to its end.
    std::optional<double> gain{};
    bool isEmpty() const { return tables.path_guide_nodes.empty(); }
};

/// How guided paths end, unless the scene has a rule. Throughput says less of what they are worth, so the rules that pilot paths choose
/// from lose more than they gain.
inline constexpr Roulette guidedRoulette{.depth = 8};

/// Learns the guide of a scene that has one (Feature::PATH_GUIDE), and uses it from then on: from a few percent of the paths of the whole
/// image, in rounds of which each is guided by those before. Does nothing for short renders. The result depends on the scene, its
/// resolution and its samples, but not on the seed or on the part of the image that is rendered. `wave` renders `scene`.
LearnedPathGuide pilotPathGuide(const Context& context, DeviceScene& scene, const PackedScene& packed, Wave& wave);

/// Uses what was learned on another device.
void usePathGuide(const Context& context, DeviceScene& scene, const LearnedPathGuide& guide);

}  // namespace eikonal
