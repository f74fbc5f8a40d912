#include "film/splats.h"

#include <algorithm>

namespace eikonal {

/// Both lists in order, and joined where they touch; nothing if they overlap.
static std::vector<SampleRange> united(std::vector<SampleRange> all, const std::vector<SampleRange>& more) {
    all.insert(all.end(), more.begin(), more.end());
    std::ranges::sort(all);
    std::vector<SampleRange> joined;
    for (const SampleRange& range : all) {
        if (!joined.empty() && range.first < joined.back().end) return {};
        if (!joined.empty() && range.first == joined.back().end) joined.back().end = range.end;
        else joined.push_back(range);
    }
    return joined;
}

bool addSplats(SplatRow& row, const SplatRow& more) {
    if (more.samples.empty()) return true;
    std::vector<SampleRange> samples = united(row.samples, more.samples);
    if (samples.empty()) return false;
    row.samples = std::move(samples);
    for (size_t i = 0; i < row.words.size(); ++i) row.words[i] += more.words[i];
    return true;
}

SplatSums::SplatSums(const PixelRect& pixels, bool hasPasses) : pixels_(pixels), hasPasses_(hasPasses) {
    const size_t inRow = words() * static_cast<size_t>(pixels.width());
    for (int y = pixels.y0; y < pixels.y1; ++y) rows_.push_back({y, pixels.x0, pixels.x1, {}, std::vector<std::uint64_t>(inRow)});
}

unsigned SplatSums::end() const {
    unsigned end = ~0u;
    for (const SplatRow& row : rows_) end = std::min(end, row.samples.empty() ? 0u : row.samples.back().end);
    return end;
}

void SplatSums::add(SampleRange samples, std::span<const uint> halves) {
    const size_t width = static_cast<size_t>(pixels_.width()), plane = width * rows_.size();
    for (SplatRow& row : rows_) {
        SplatRow more{row.y, row.x0, row.x1, {samples}, std::vector<std::uint64_t>(row.words.size())};
        for (size_t word = 0; word < words(); ++word)
            for (size_t x = 0; x < width; ++x) {
                const size_t low = 2 * word * plane + static_cast<size_t>(row.y - pixels_.y0) * width + x;
                more.words[word * width + x] = halves[low] | static_cast<std::uint64_t>(halves[low + plane]) << 32;
            }
        addSplats(row, more);
    }
}

void SplatSums::join(std::span<uint> halves, std::span<const uint> more, const PixelRect& part) {
    const size_t plane = static_cast<size_t>(part.width()) * static_cast<size_t>(part.height());
    for (size_t word = 0; word < halves.size(); word += 2 * plane)   // low halves of all pixels, then the high ones
        for (size_t low = word; low < word + plane; ++low) {
            const uint before = halves[low];
            halves[low] += more[low];
            halves[low + plane] += more[low + plane] + (halves[low] < before ? 1u : 0u);
        }
}

size_t SplatSums::halves() const { return 2 * words() * static_cast<size_t>(pixels_.width()) * rows_.size(); }

}  // namespace eikonal
