#include "film/tile.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace eikonal {

PixelRect rowsOf(const PixelRect& all, const Tile& tile, std::span<const std::uint64_t> costs) {
    std::vector<std::uint64_t> before(costs.size() + 1, 0);   // of all rows above each
    std::partial_sum(costs.begin(), costs.end(), before.begin() + 1);
    /* The border i has about i / count of the cost above it, and leaves a row for each part above and below */
    const auto border = [&](int i) {
        const std::uint64_t wanted = before.back() * static_cast<std::uint64_t>(i) / static_cast<std::uint64_t>(tile.count);
        auto row = std::ranges::lower_bound(before, wanted);
        if (row != before.begin() && wanted - *std::prev(row) < *row - wanted) --row;
        const int rows = static_cast<int>(row - before.begin());
        return i == 0 ? 0 : i == tile.count ? all.height() : std::clamp(rows, i, all.height() - (tile.count - i));
    };
    /* Where cheap rows would make borders fall together, each is a row below the one before */
    int top = 0, bottom = 0;
    for (int i = 1; i <= tile.index; ++i) {
        top = bottom;
        bottom = std::max(border(i), top + 1);
    }
    return {all.x0, all.y0 + top, all.x1, all.y0 + bottom};
}

}  // namespace eikonal
