#pragma once
// The error of an image, estimated from its own samples: how far the means of parts of a pixel's samples lie apart.

#include <optional>
#include <string>
#include <utility>

namespace eikonal {

/// What the error of an image is: with e the error of a pixel's luminance and r its true luminance, means being over the pixels,
/// relmseRoot: sqrt(mean(e^2 / (r^2 + 0.01))); scaledRelmseRoot: sqrt(mean(e^2 / (r^2 + 0.01 mean(r)^2))); mseRoot: sqrt(mean(e^2));
/// nrmse: sqrt(mean(e^2)) / mean(r).
enum class ErrorMetric { relmseRoot, scaledRelmseRoot, mseRoot, nrmse };
inline constexpr std::pair<const char*, ErrorMetric> errorMetricNames[] = {{"relmse-root", ErrorMetric::relmseRoot},
                                                                           {"relmse-scaled", ErrorMetric::scaledRelmseRoot},
                                                                           {"mse-root", ErrorMetric::mseRoot},
                                                                           {"nrmse", ErrorMetric::nrmse}};

/// Sums over pixels. A pixel's *half square* is the squared distance of its mean from that of half of its samples, weighted as the metric
/// weights squared errors; its expectation is V(n/2) - V(n), where V(n) is the variance of the mean of n samples.
struct NoiseSums {
    double pixels = 0, brightness = 0;   ///< count, and sum of luminances
    double half = 0;                     ///< half squares, scaled to the samples that a pixel has
    double quarter = 0;                  ///< half squares of each half, V(n/4) - V(n/2), scaled as `half`
    double eighth = 0;                   ///< half squares of each quarter, V(n/8) - V(n/4), scaled as `half`; 0 below 8 samples
    double squares = 0;                  ///< of the sums of half and quarter
    double suspicion = 0;                ///< variance of the squared errors, for it is not known how dark pixels of one bright sample are
    unsigned fewest = 0;                 ///< samples per pixel
    NoiseSums& operator+=(const NoiseSums& other);
};

/// How the variance falls with the number of samples n.
struct VarianceDecay {
    double share = 1. / 3; ///< V(n) / (V(n/4) - V(n)); 1/3 for independent samples, less for Sobol' samples
    double exponent = 1;   ///< near n, V falls as n^-exponent
};
/// V(n) is the sum of all later steps V(m) - V(2m), m = n, 2n, 4n ..., which the last two extrapolate. If the ratio of steps two apart,
/// V(n/2) - V(n) and V(n/8) - V(n/4), stays what it is, this is a geometric series; if V is a mixture of 1/n and 1/n^2, the ratio rises. A
/// mean of both is taken. Ratios of neighbouring steps would mislead: nets in base 4 gain more from 2 * 4^k to 4^(k + 1) samples than from
/// 4^k to 2 * 4^k. Of fewer than 8 samples only neighbours are known.
VarianceDecay decayOf(const NoiseSums& sums);

/// V(n) / V(m), where m is the largest power of two that is at most n. The samples are aligned runs of 2^b samples, one for each bit of
/// n, whose errors are taken as uncorrelated.
double varianceScale(unsigned n, double exponent);

struct ErrorEstimate {
    double error = 0, low = 0, high = 0;   ///< the true error is within [low, high] with a probability of about 95 %
    std::string doubt;                     ///< why the estimate is not reliable; empty: it is
    bool isKnown = true;                   ///< false: it says nothing of the true error, as doubt explains
};
ErrorEstimate estimateError(const NoiseSums& sums, const VarianceDecay& decay, ErrorMetric metric);

/// "error about 2.1 % (relmse-root), 95 % within 1.8 to 2.4 %; not reliable: ...", or "error not known (relmse-root): ...".
std::string describe(const ErrorEstimate& estimate, ErrorMetric metric);

}  // namespace eikonal
