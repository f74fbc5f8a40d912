#include "statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace eikonal {

/// The upper regularised incomplete gamma function: a series for small x, Lentz's continued fraction otherwise
/// (Press et al., "Numerical Recipes", section 6.2).
static double upperGamma(double a, double x) {
    if (x <= 0) return 1;
    const double front = std::exp(-x + a * std::log(x) - std::lgamma(a));
    if (x < a + 1) {
        double term = 1 / a, sum = term;
        for (int n = 1; n < 10000 && term > sum * 1e-15; ++n) { term *= x / (a + n); sum += term; }
        return 1 - front * sum;
    }
    double b = x + 1 - a, c = 1e300, d = 1 / b, h = d;
    for (int n = 1; n < 10000; ++n) {
        const double an = -n * (n - a);
        b += 2;
        d = 1 / (an * d + b);
        c = b + an / c;
        h *= d * c;
        if (std::abs(d * c - 1) < 1e-15) break;
    }
    return front * h;
}

double chiSquareProbability(double chi2, int degrees) { return upperGamma(degrees / 2.0, chi2 / 2); }

ChiSquare testChiSquare(const std::vector<double>& counts, const std::vector<double>& expected) {
    std::vector<size_t> order(counts.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return expected[a] < expected[b]; });
    ChiSquare result;
    int cells = 0;
    double seen = 0, wanted = 0;
    const auto close = [&] { result.chi2 += (seen - wanted) * (seen - wanted) / wanted; ++cells; seen = wanted = 0; };
    for (size_t i : order) {
        seen += counts[i];
        wanted += expected[i];
        if (wanted >= 5) close();
    }
    /* What is left over expects less than five, and counts as another cell if it has more than rounding could explain */
    if (seen > 0 && wanted < 1e-3) result.chi2 += seen * seen / std::max(wanted, 1e-3);
    result.degrees = std::max(cells - 1, 1);
    result.probability = chiSquareProbability(result.chi2, result.degrees);
    return result;
}

std::string ChiSquare::describe() const {
    return fmt::format("chi-square {:.1f} with {} degrees of freedom: probability {:.2g}", chi2, degrees, probability);
}

Estimate Accumulator::estimate() const {
    const double n = static_cast<double>(n_);
    return {mean_, n_ > 1 ? std::sqrt(m2_ / (n - 1) / n) : 0, n_};
}

}  // namespace eikonal
