#include "app/efficiency.h"

#include "median.h"

#include <cmath>
#include <numbers>
#include <numeric>

namespace eikonal {

/// Standard error of the median of normally distributed values; 0 for a single value.
static double standardErrorOfMedian(const std::vector<double>& values) {
    const double n = static_cast<double>(values.size()), mean = std::reduce(values.begin(), values.end()) / n;
    double squares = 0;
    for (double v : values) squares += (v - mean) * (v - mean);
    return n > 1 ? std::sqrt(std::numbers::pi / 2 * squares / (n - 1) / n) : 0;
}

Efficiency efficiencyOf(const Estimate& relativeVariance, const std::vector<double>& seconds) {
    const double time = median(seconds), value = 1 / (relativeVariance.value * time);
    const double error = std::hypot(relativeVariance.standardError / relativeVariance.value, standardErrorOfMedian(seconds) / time);
    return {value, value * std::exp(-1.96 * error), value * std::exp(1.96 * error)};
}

}  // namespace eikonal
