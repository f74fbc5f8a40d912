#pragma once
// What light paths have added to the pixels of a film (include/eikonal/film.h), and which light paths that were.

#include "eikonal/film.h"
#include "film/sample_nodes.h"
#include "pack/tables.h"

#include <cstdint>
#include <span>
#include <vector>

namespace eikonal {

/// Of the pixels x0 <= x < x1 of row y: word w of pixel x is words[w * (x1 - x0) + x - x0]. The light paths are those of all pixels of the
/// whole image, of the samples `samples`: ranges in order, none empty, none that touch.
struct SplatRow {
    int y = 0, x0 = 0, x1 = 0;
    std::vector<SampleRange> samples;
    std::vector<std::uint64_t> words;
};

/// Adds `more` to `row`, which is of the same pixels. Returns false, and changes nothing, if both have a sample.
bool addSplats(SplatRow& row, const SplatRow& more);

class SplatSums {
public:
    explicit SplatSums(const PixelRect& pixels);

    const PixelRect& pixels() const { return pixels_; }
    const std::vector<SplatRow>& rows() const { return rows_; }
    /// The end of the samples that every row has.
    unsigned end() const;
    /// Adds what the light paths of `samples` have left on the device: 32-bit words as kernels/film/splat.clh has them.
    void add(SampleRange samples, std::span<const uint> halves);
    /// Whether a row of a file is one of these.
    bool fits(const SplatRow& row) const {
        return row.y >= pixels_.y0 && row.y < pixels_.y1 && row.x0 == pixels_.x0 && row.x1 == pixels_.x1;
    }
    /// Adds a row that fits. False: some of its samples are there already.
    bool add(const SplatRow& row) { return addSplats(rows_[static_cast<size_t>(row.y - pixels_.y0)], row); }
    /// 32-bit words of all pixels on the device.
    size_t halves() const;
    /// Bytes of a pixel on the host.
    static constexpr size_t bytesPerPixel = splat_words * sizeof(std::uint64_t);

private:
    PixelRect pixels_;
    std::vector<SplatRow> rows_;
};

}  // namespace eikonal
