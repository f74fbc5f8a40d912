#pragma once
// Every stage of a scene's first bounces, run with several sets of math flags on the same queues.

#include "flags/ulps.h"
#include "pack/tables.h"

#include <string>
#include <vector>

namespace eikonal {

/// The differences of what a stage writes from what it writes with the first set of flags.
struct StageFigures {
    std::string stage, flags;
    UlpTally floats;          ///< of fields whose items decide alike; a vector counts as one, in ulp of its largest component
    std::size_t items = 0;    ///< that the stage has changed
    std::size_t decided = 0;  ///< of them: with another integer, or alive in only one of the two
};

/// Traces a block of 32 x 32 pixels, 16 samples each, with the first set of flags; before each stage goes on, it also runs with the other
/// sets. The scene must be at most 32 x 32 pixels. No environment guide, no ray splitting.
std::vector<StageFigures> compareStages(const PackedScene& scene, const std::vector<std::string>& flagSets);

}  // namespace eikonal
