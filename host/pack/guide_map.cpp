#include "pack/guide_map.h"

#include "eikonal/light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace eikonal {

/// Writes a sum into its half of a word.
static void writeSum(std::span<uint> words, size_t i, uint sum) { words[i / 2] = i % 2 ? words[i / 2] | sum << 16 : sum; }

void writeGuideMap(std::span<uint> words, std::span<const double> weights) {
    /* Whole units; what rounding leaves goes to the largest, which has at least a share of 1 / GUIDE_OPENINGS */
    std::array<int, GUIDE_OPENINGS> units;
    const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
    std::ranges::transform(weights, units.begin(),
                           [&](double w) { return w > 0 ? std::max(static_cast<int>(w / total * GUIDE_UNITS), 1) : 0; });
    *std::ranges::max_element(units) += GUIDE_UNITS - std::accumulate(units.begin(), units.end(), 0);

    uint sum = 0;
    for (size_t i = 0; i < units.size(); ++i) {
        writeSum(words, GUIDE_SIDE + i, sum);
        if (i % GUIDE_SIDE == 0) writeSum(words, i / GUIDE_SIDE, sum);
        sum += static_cast<uint>(units[i]);
    }
}

/* All sums are those of all units */
void writeDarkGuideMap(std::span<uint> words) { std::ranges::fill(words, ~0u); }

double openingProbability(std::span<const uint> words, size_t opening) {
    const auto sumBefore = [&](size_t i) {
        if (i == GUIDE_OPENINGS) return uint{GUIDE_UNITS};
        const uint pair = words[(GUIDE_SIDE + i) / 2];
        return i % 2 ? pair >> 16 : pair & 0xffffu;
    };
    return (sumBefore(opening + 1) - sumBefore(opening)) / double{GUIDE_UNITS};
}

}  // namespace eikonal
