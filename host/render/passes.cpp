#include "render/passes.h"

#include <array>
#include <bit>

namespace eikonal {

/// The fewest pixels of a block in uniform passes. Neighbouring pixels are traced together for coherence.
constexpr unsigned smallestBlock = 1024;

Pass uniformPass(const PixelRect& rect, SampleRange done, unsigned end, unsigned mostPaths) {
    const unsigned left = end - done.end;
    const unsigned long pixels = static_cast<unsigned long>(rect.width()) * static_cast<unsigned long>(rect.height());
    const unsigned fill = std::bit_floor(static_cast<unsigned>(std::max<unsigned long>(mostPaths / std::max(pixels, 1ul), 1)));
    const unsigned wanted = std::min(std::max(fill, std::bit_floor(done.length())), left);
    const unsigned blockPixels = std::bit_floor(std::max(mostPaths / wanted, std::min(smallestBlock, mostPaths)));
    const unsigned samples = std::min(left, std::bit_floor(std::max(mostPaths / blockPixels, 1u)));
    Pass pass{chooseBlockSize(rect, blockPixels), {}, samples};
    for (int y = rect.y0; y < rect.y1; y += pass.size.height())
        for (int x = rect.x0; x < rect.x1; x += pass.size.width()) pass.blocks.push_back({x, y, done.end, samples});
    return pass;
}

Pass cutBlocks(const std::vector<Block>& blocks, BlockSize size, const PixelRect& rect, unsigned mostPaths) {
    BlockSize small = size;
    while (small.pixels() > mostPaths) --(small.log2Height > small.log2Width ? small.log2Height : small.log2Width);
    Pass pass{small, {}, 0};
    for (const Block& b : blocks) {
        const PixelRect part = b.within(rect, size);
        for (int y = part.y0; y < part.y1; y += small.height())
            for (int x = part.x0; x < part.x1; x += small.width()) pass.blocks.push_back({x, y, b.firstSample, b.samples});
    }
    return pass;
}

namespace {

/// Finds squares of pixels with equally many samples, by log2 of their width.
class MissingSquares {
public:
    explicit MissingSquares(const Film& film) : film_(film), rect_(film.pixels()) {}

    void find(int x, int y, int log2Size, unsigned samples) {
        if (x >= rect_.x1 || y >= rect_.y1) return;
        const PixelRect part = Block{x, y}.within(rect_, {log2Size, log2Size});
        if (isUniform(part)) {
            const unsigned has = taken(part.x0, part.y0);
            if (has < samples) squares_[static_cast<size_t>(log2Size)].push_back({x, y, has, samples - has});
            return;
        }
        const int half = 1 << (log2Size - 1);
        for (const auto& [dx, dy] : {std::pair(0, 0), std::pair(half, 0), std::pair(0, half), std::pair(half, half)})
            find(x + dx, y + dy, log2Size - 1, samples);
    }

    std::vector<Pass> passes(unsigned mostPaths) const {
        std::vector<Pass> all;
        for (int log2Size = mostLog2Size; log2Size >= 0; --log2Size)
            if (const auto& blocks = squares_[static_cast<size_t>(log2Size)]; !blocks.empty())
                all.push_back(cutBlocks(blocks, {log2Size, log2Size}, rect_, mostPaths));
        return all;
    }

private:
    static constexpr int mostLog2Size = 15;
    unsigned taken(int x, int y) const {
        return film_.taken()[static_cast<size_t>(y - rect_.y0) * static_cast<size_t>(rect_.width()) + static_cast<size_t>(x - rect_.x0)];
    }
    bool isUniform(const PixelRect& part) const {
        const unsigned first = taken(part.x0, part.y0);
        for (int y = part.y0; y < part.y1; ++y)
            for (int x = part.x0; x < part.x1; ++x)
                if (taken(x, y) != first) return false;
        return true;
    }

    const Film& film_;
    const PixelRect& rect_;
    std::array<std::vector<Block>, mostLog2Size + 1> squares_;
};

}  // namespace

std::vector<Pass> missingPasses(const Film& film, std::span<const unsigned> samples, BlockSize size, unsigned mostPaths) {
    MissingSquares squares(film);
    const PixelRect& rect = film.pixels();
    size_t i = 0;
    for (int y = rect.y0; y < rect.y1; y += size.height())
        for (int x = rect.x0; x < rect.x1; x += size.width(), ++i)
            squares.find(x, y, size.log2Width, samples.size() == 1 ? samples.front() : samples[i]);
    return squares.passes(mostPaths);
}

}  // namespace eikonal
