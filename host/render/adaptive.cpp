#include "render/adaptive.h"

#include <tbb/parallel_for.h>

#include <cmath>

namespace eikonal {

double expectedError(std::span<const BlockNoise> blocks) {
    double sum = 0, pixels = 0;
    for (const BlockNoise& b : blocks) {
        sum += b.pixels * b.variance / b.samples;
        pixels += b.pixels;
    }
    return pixels > 0 ? sum / pixels : 0;
}

/// `samples` times the power of two that comes closest to `wanted` (by ratio), at most `most`.
static unsigned doubled(unsigned samples, double wanted, unsigned most) {
    double n = samples;
    while (n < most && n * std::sqrt(2.0) < wanted) n *= 2;
    return static_cast<unsigned>(std::min<double>(n, most));
}

std::vector<unsigned> planSamples(std::span<const BlockNoise> blocks, double target, unsigned most, double decay) {
    const auto plan = [&](double factor) {
        std::vector<BlockNoise> planned(blocks.begin(), blocks.end());
        for (BlockNoise& b : planned) {
            const double before = b.samples;
            b.samples = doubled(b.samples, factor * b.suspected, most);
            b.variance *= std::pow(before / b.samples, decay - 1);
        }
        return planned;
    };
    /* Bisect for the least factor that meets the target; the error falls as the factor grows */
    double low = -60, high = 120;   // log2 of the factor
    for (int i = 0; i < 40; ++i) {
        const double middle = (low + high) / 2;
        (expectedError(plan(std::exp2(middle))) > target ? low : high) = middle;
    }
    std::vector<unsigned> samples;
    for (const BlockNoise& b : plan(expectedError(blocks) > target ? std::exp2(high) : 0)) samples.push_back(b.samples);
    return samples;
}

/// Every block's estimate is at least this share of the image's mean.
constexpr double leastShare = 0.5;

void suspectNoise(std::span<BlockNoise> blocks, int across) {
    const int down = static_cast<int>(blocks.size()) / across;
    double image = 0, pixels = 0;
    for (const BlockNoise& b : blocks) {
        image += b.pixels * std::sqrt(b.variance);
        pixels += b.pixels;
    }
    for (int y = 0; y < down; ++y)
        for (int x = 0; x < across; ++x) {
            double around = 0, count = 0;
            for (int v = std::max(y - 1, 0); v <= std::min(y + 1, down - 1); ++v)
                for (int u = std::max(x - 1, 0); u <= std::min(x + 1, across - 1); ++u) {
                    around += std::sqrt(blocks[static_cast<size_t>(v * across + u)].variance);
                    ++count;
                }
            BlockNoise& b = blocks[static_cast<size_t>(y * across + x)];
            b.suspected = std::max({std::sqrt(b.variance), around / count, leastShare * image / pixels});
        }
}

AdaptiveSampling::AdaptiveSampling(const PixelRect& rect, std::span<const unsigned> samples, unsigned most, double targetError,
                                   ErrorMetric metric)
    : rect_(rect),
      most_(most),
      metric_(metric),
      targetError_(targetError),
      across_((rect.width() + blockSize.width() - 1) / blockSize.width()) {
    for (int y = rect.y0; y < rect.y1; y += blockSize.height())
        for (int x = rect.x0; x < rect.x1; x += blockSize.width())
            blocks_.push_back({x, y, 0, samples.size() == 1 ? samples.front() : samples[blocks_.size()]});
}

std::vector<unsigned> AdaptiveSampling::samples() const {
    std::vector<unsigned> all;
    for (const Block& b : blocks_) all.push_back(b.samples);
    return all;
}

std::vector<Block> AdaptiveSampling::nextPass(const Film& film) {
    const FilmTotals totals = film.totals();
    std::vector<NoiseSums> sums(blocks_.size());
    const std::optional<double> floor = totals.relativeFloor(metric_);
    tbb::parallel_for(size_t(0), blocks_.size(), [&](size_t i) { sums[i] = totals.noise(blocks_[i].within(rect_, blockSize), floor); });
    NoiseSums image;
    for (const NoiseSums& s : sums) image += s;
    const VarianceDecay decay = decayOf(image);
    const ErrorEstimate estimate = estimateError(image, decay, metric_);
    error_ = estimate.error;
    std::vector<BlockNoise> noise;
    for (size_t i = 0; i < blocks_.size(); ++i) {
        const unsigned samples = blocks_[i].samples;
        noise.push_back(
            {samples, static_cast<unsigned>(sums[i].pixels), (sums[i].half + sums[i].quarter) * decay.share * samples / sums[i].pixels, 0});
    }
    suspectNoise(noise, across_);
    /* What the squared error, which the blocks' variances add up to, has to come down to */
    const double relative = error_ > 0 ? targetError_ / error_ : 1;
    const std::vector<unsigned> planned =
        estimate.isKnown ? planSamples(noise, relative * relative * expectedError(noise), most_, decay.exponent)
                         : std::vector<unsigned>(blocks_.size(), most_);
    plannedSamples_ = 0;
    std::vector<Block> pass;
    for (size_t i = 0; i < blocks_.size(); ++i) {
        const unsigned has = blocks_[i].samples;
        plannedSamples_ += static_cast<double>(planned[i]) * noise[i].pixels;
        if (planned[i] <= has) continue;
        pass.push_back({blocks_[i].x, blocks_[i].y, has, std::min(has, most_ - has)});
        blocks_[i].samples += pass.back().samples;
    }
    return pass;
}

}  // namespace eikonal
