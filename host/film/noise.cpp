#include "film/noise.h"

#include "names.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace eikonal {

NoiseSums& NoiseSums::operator+=(const NoiseSums& other) {
    fewest = pixels > 0 ? std::min(fewest, other.fewest) : other.fewest;
    pixels += other.pixels;
    brightness += other.brightness;
    half += other.half;
    quarter += other.quarter;
    eighth += other.eighth;
    squares += other.squares;
    suspicion += other.suspicion;
    return *this;
}

/// Of 4 samples, of which only the last two steps are known: their ratio is 1/2 for independent samples, 1/4 for V = 1/n^2.
static VarianceDecay decayOfNeighbours(const NoiseSums& sums) {
    if (!(sums.quarter > 0)) return {};
    const double ratio = std::clamp(sums.half / sums.quarter, 0.3, 0.55);
    const double geometric = ratio / (1 - ratio), mixture = 5.0 / 3 - 1 / (3 * ratio);
    return {(geometric + mixture) / 2 * sums.half / (sums.half + sums.quarter), std::max(std::log2(1 / ratio), 1.0)};
}

VarianceDecay decayOf(const NoiseSums& sums) {
    if (sums.fewest < 8) return decayOfNeighbours(sums);
    if (!(sums.eighth > 0)) return {};
    /* Independent samples: 1/4; the best nets: 1/64. A few samples have yet to become well spread, so the first steps fall faster */
    const double ratio = std::clamp(sums.half / sums.eighth, sums.fewest < 64 ? 0.09 : 1.0 / 64, 0.3);
    const double geometric = ratio / (1 - ratio), mixture = (22 * ratio - 1) / (3 * (14 * ratio + 1));
    return {ratio < 1.0 / 16 ? geometric : 0.6 * geometric + 0.4 * mixture, std::max(std::log2(1 / ratio) / 2, 1.0)};
}

double varianceScale(unsigned n, double exponent) {
    double sum = 0;
    for (unsigned rest = n, bit = 0; rest != 0; rest &= rest - 1) {
        bit = static_cast<unsigned>(std::countr_zero(rest));
        const double m = std::exp2(bit);
        sum += m / n * (m / n) * std::pow(std::bit_floor(n) / m, exponent);
    }
    return sum;
}

/// Estimates in which fewer pixels hold the error are not reliable.
constexpr double leastPixels = 8;
/// Of independent samples, a pixel's two steps are the squares of three normal numbers of one variance: the variance of their sum is this
/// share of the expectation of its square.
constexpr double shareOfSquares = 0.4;
/// Relative standard deviation of an error estimate from many pixels, whose model of the decay is not exact.
constexpr double modelDeviation = 0.085;

/// Whether squares of differences between luminances of about this mean fit single precision (film/quarters.clh), down to a thousandth of
/// it. relMSE has a floor, below which small ones do not count.
static bool hasSquares(double mean, ErrorMetric metric) {
    return std::abs(mean) < 1e16 && (std::abs(mean) > 1e-16 || metric == ErrorMetric::relmseRoot);
}

ErrorEstimate estimateError(const NoiseSums& sums, const VarianceDecay& decay, ErrorMetric metric) {
    ErrorEstimate e;
    if (sums.pixels == 0) return e;
    const double mean = sums.brightness / sums.pixels;
    const double steps = std::max(sums.half + sums.quarter, 0.0);
    e.error = std::sqrt(steps * decay.share / sums.pixels);
    if (metric == ErrorMetric::nrmse) e.error = mean > 0 ? e.error / mean : 0;
    const double sum = steps * decay.share, ofPixels = shareOfSquares * sums.squares * decay.share * decay.share;
    const double variance = ofPixels + sums.suspicion, mostVariance = shareOfSquares / leastPixels * sum * sum;
    /* Of what is not known at all, nothing more is said than that it may be seven times as much, or a seventh */
    constexpr double mostDeviation = 1;
    const double deviation = sum > 0 ? std::min(std::sqrt(variance) / sum / 2, mostDeviation) : 0;
    const double factor = std::exp(1.96 * std::hypot(deviation, modelDeviation));
    e.low = e.error / factor;
    e.high = e.error * factor;
    e.isKnown = sums.fewest > 1 && (sums.brightness == 0 || hasSquares(mean, metric));
    if (sums.fewest == 0) e.doubt = "a pixel has no sample";
    else if (sums.fewest < 4) e.doubt = fmt::format("a pixel has only {} sample{}", sums.fewest, sums.fewest == 1 ? "" : "s");
    else if (sums.brightness == 0) e.doubt = "no sample has found light";
    else if (!e.isKnown) e.doubt = "luminances are too large or too small for their squares in single precision";
    else if (ofPixels > mostVariance && sums.pixels > leastPixels) e.doubt = "very few pixels hold most of it";
    else if (variance > mostVariance) e.doubt = "single bright samples may hold most of it";
    return e;
}

std::string describe(const ErrorEstimate& e, ErrorMetric metric) {
    if (!e.isKnown) return fmt::format("error not known ({}): {}", nameIn(errorMetricNames, metric), e.doubt);
    return fmt::format("error about {:.3g} % ({}), 95 % within {:.3g} to {:.3g} %{}{}", 100 * e.error, nameIn(errorMetricNames, metric),
                       100 * e.low, 100 * e.high, e.doubt.empty() ? "" : "; not reliable: ", e.doubt);
}

}  // namespace eikonal
