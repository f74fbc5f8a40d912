#pragma once
// A row of pixels of a film.

#include <cstddef>

namespace eikonal {

/// Pixels in a row: word w of pixel i is first[w * stride + i].
template <class Word> struct PixelRow {
    Word* first;
    std::size_t stride;
};

}  // namespace eikonal
