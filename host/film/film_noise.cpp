// FilmTotals::noise and FilmTotals::error: what the pixels' quarters of samples say about their error.

#include "film/planes.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

namespace eikonal {

/// Radius of the neighbourhood of a pixel, for its luminance.
constexpr int reach = 3;
/// Where a few samples make a pixel bright, it is more often brighter than the truth than darker.
constexpr double most = 0.75;

std::optional<double> FilmTotals::relativeFloor(ErrorMetric metric) const {
    if (metric == ErrorMetric::relmseRoot) return 0.01;
    if (metric != ErrorMetric::scaledRelmseRoot) return std::nullopt;
    const Planes planes(*this);
    double sum = 0;
    for (size_t i = 0; i < plane(); ++i) sum += luminance(planes.color(i));
    const double mean = sum / static_cast<double>(plane());
    return std::max(0.01 * mean * mean, 1e-30);
}

/// The luminance that squared errors are relative to. A pixel whose mean is due to a few samples is brighter than the truth, and its error
/// would seem small. It is replaced by the mean of its neighbours, but at least that of its three darker quarters, and at most `most` of
/// the way from there to its own.
FilmTotals::ExpectedLuminance FilmTotals::expectedLuminance(const Planes& planes, int x, int y, double floor) const {
    const size_t i = index(x, y);
    const glm::vec3 color = planes.color(i);
    const double own = luminance(color), low = std::clamp<double>(planes.low(i), std::min(0.0, own), own);
    /* The part of the mean that is in doubt: all of it where a third of it is noise */
    const double doubt = own > 0 ? std::min(8 * planes.variance(i, color) / (own * own), 1.0) : 0;
    if (doubt < 0.01) return {own, 0};
    double around = 0;
    int count = 0;
    for (int v = std::max(y - reach, pixels_.y0); v <= std::min(y + reach, pixels_.y1 - 1); ++v)
        for (int u = std::max(x - reach, pixels_.x0); u <= std::min(x + reach, pixels_.x1 - 1); ++u) {
            if (u == x && v == y) continue;
            around += luminance(planes.color(index(u, v)));
            ++count;
        }
    /* If one sample of n found a lamp of luminance L, which is a = L / n in the mean, the lamp's share c of the pixel has the density n^2 c
       at small c. The squared error, a^2 / (c L + b)^2 for the pixel's other luminance b, has then a mean square of a^2 / (6 b^2) */
    const double above = own - low;
    return {own - doubt * (own - std::clamp(count ? around / count : own, low, low + most * above)),
            doubt * above * above / (6 * (low * low + floor))};
}

NoiseSums FilmTotals::noise(const PixelRect& part, std::optional<double> floor, double decay) const {
    const Planes planes(*this);
    NoiseSums sums;
    unsigned samples = 0;
    double scale = 1;
    for (int y = part.y0; y < part.y1; ++y)
        for (int x = part.x0; x < part.x1; ++x) {
            const size_t i = index(x, y);
            if (planes.count[i] != samples) {
                samples = planes.count[i];
                scale = varianceScale(samples, decay);
            }
            /* Too few samples for quarters: take them as independent */
            const glm::vec3 color = planes.color(i);
            const double independent = samples < 4 ? planes.variance(i, color) : 0;
            double half = samples < 4 ? independent : planes.halfSquare[i] * scale,
                   quarter = samples < 4 ? 2 * independent : planes.quarterSquare[i] * scale, eighth = planes.eighthSquare[i] * scale;
            /* Light paths of different samples are independent */
            if (samples >= 4) {
                const double splatted = planes.splatVariance(i);
                half += splatted;
                quarter += 2 * splatted;
                eighth += 4 * splatted;
            }
            double suspicion = 0;
            if (floor && half + quarter + eighth > 0) {
                const ExpectedLuminance expected = expectedLuminance(planes, x, y, *floor);
                const double weight = 1 / (expected.luminance * expected.luminance + *floor);
                half *= weight;
                quarter *= weight;
                eighth *= weight;
                suspicion = expected.suspicion;
            }
            sums += {1, luminance(color), half, quarter, eighth, (half + quarter) * (half + quarter), suspicion, samples};
        }
    return sums;
}

ErrorEstimate FilmTotals::error(ErrorMetric metric) const {
    const std::optional<double> floor = relativeFloor(metric);
    const auto total = [&](double decay) {
        std::vector<NoiseSums> rows(static_cast<size_t>(pixels_.height()));
        tbb::parallel_for(size_t(0), rows.size(), [&](size_t row) {
            const int y = pixels_.y0 + static_cast<int>(row);
            rows[row] = noise({pixels_.x0, y, pixels_.x1, y + 1}, floor, decay);
        });
        NoiseSums sums;
        for (const NoiseSums& row : rows) sums += row;
        return sums;
    };
    const NoiseSums sums = total(1);
    const VarianceDecay decay = decayOf(sums);
    /* The exponent matters only between powers of two */
    const uint* counts = numbers("count");
    const bool isEven = std::all_of(counts, counts + plane(), [](uint n) { return std::has_single_bit(n); });
    return estimateError(isEven ? sums : total(decay.exponent), decay, metric);
}

}  // namespace eikonal
