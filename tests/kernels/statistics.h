#pragma once
// Tests of statistical hypotheses. All are meant for fixed seeds: they pass or fail alike every time.

#include <cstddef>
#include <string>
#include <vector>

namespace eikonal {

/// P(X >= chi2) for X with the chi-square distribution of that many degrees of freedom.
double chiSquareProbability(double chi2, int degrees);

/// Pearson's test that `counts` were drawn with the expected frequencies. Cells are merged, in the order of their expected
/// frequency, until every merged one expects at least 5.
struct ChiSquare {
    double chi2 = 0, probability = 1;
    int degrees = 0;
    std::string describe() const;
};
ChiSquare testChiSquare(const std::vector<double>& counts, const std::vector<double>& expected);

/// Mean and its standard error.
struct Estimate {
    double mean = 0, error = 0;
    size_t count = 0;
};
class Accumulator {
public:
    void add(double x) { ++n_; const double d = x - mean_; mean_ += d / static_cast<double>(n_); m2_ += d * (x - mean_); }
    Estimate estimate() const;

private:
    size_t n_ = 0;
    double mean_ = 0, m2_ = 0;
};

/// With a correct program and so many tests in the suite, a hypothesis at this level is hardly ever rejected.
constexpr double significance = 1e-5;

}  // namespace eikonal
