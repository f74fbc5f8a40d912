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
    /// hasPasses: also by render pass.
    SplatSums(const PixelRect& pixels, bool hasPasses);

    const PixelRect& pixels() const { return pixels_; }
    const std::vector<SplatRow>& rows() const { return rows_; }
    /// The end of the samples that every row has.
    unsigned end() const;
    /// Adds what the light paths of `samples` have left on the device: 32-bit words as kernels/film/splat.clh has them.
    void add(SampleRange samples, std::span<const uint> halves);
    /// Adds what another device has left for the pixels of `part` to `halves`, which has the same form.
    static void join(std::span<uint> halves, std::span<const uint> more, const PixelRect& part);
    /// Of each pixel.
    size_t words() const { return wordsPerPixel(hasPasses_); }
    /// Whether a row of a file is one of these.
    bool fits(const SplatRow& row) const {
        return row.y >= pixels_.y0 && row.y < pixels_.y1 && row.x0 == pixels_.x0 && row.x1 == pixels_.x1 &&
               row.words.size() == words() * static_cast<size_t>(pixels_.width());
    }
    /// Adds a row that fits. False: some of its samples are there already.
    bool add(const SplatRow& row) { return addSplats(rows_[static_cast<size_t>(row.y - pixels_.y0)], row); }
    /// 32-bit words of all pixels on the device.
    size_t halves() const;
    /// Bytes of a pixel on the host.
    static size_t bytesPerPixel(bool hasPasses) { return wordsPerPixel(hasPasses) * sizeof(std::uint64_t); }

private:
    static size_t wordsPerPixel(bool hasPasses) { return hasPasses ? splat_words_with_passes : splat_words; }
    PixelRect pixels_;
    bool hasPasses_;
    std::vector<SplatRow> rows_;
};

}  // namespace eikonal
