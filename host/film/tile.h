#pragma once
// A part of an image that one of several machines renders.

#include "pack/tables.h"

#include <cstdint>
#include <span>
#include <utility>

namespace eikonal {

/// Part `index` of 1 ... count.
struct Tile { int index = 1, count = 1; };

/// Its pixels: some rows of `all`. Parts differ by a row at most. There must be as many rows as parts.
inline PixelRect rowsOf(const PixelRect& all, const Tile& tile) {
    const auto border = [&](int i) { return all.y0 + static_cast<int>(static_cast<long>(all.height()) * i / tile.count); };
    return {all.x0, border(tile.index - 1), all.x1, border(tile.index)};
}

/// By what parts are alike: the number of rows, or the cost of all their rows.
enum class TilesBy { rows, cost };
inline constexpr std::pair<const char*, TilesBy> tilesByNames[] = {{"rows", TilesBy::rows}, {"cost", TilesBy::cost}};

/// The rows of a part, of which each has at least one, by the costs of all rows of `all`. Every part that has the same costs agrees.
PixelRect rowsOf(const PixelRect& all, const Tile& tile, std::span<const std::uint64_t> costs);

}  // namespace eikonal
