#pragma once
// A part of an image that one of several machines renders.

#include "pack/tables.h"

namespace eikonal {

/// Part `index` of 1 ... count.
struct Tile { int index = 1, count = 1; };

/// Its pixels: some rows of `all`. Parts differ by a row at most. There must be as many rows as parts.
inline PixelRect rowsOf(const PixelRect& all, const Tile& tile) {
    const auto border = [&](int i) { return all.y0 + static_cast<int>(static_cast<long>(all.height()) * i / tile.count); };
    return {all.x0, border(tile.index - 1), all.x1, border(tile.index)};
}

}  // namespace eikonal
