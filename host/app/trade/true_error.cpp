#include "app/trade/true_error.h"

#include "error.h"
#include "image/relative_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace eikonal {
namespace {

void checkSize(const FilmImage& image, size_t pixels) {
    if (image.pixelCount() != pixels)
        throw Error(ExitCode::scene, fmt::format("a render of {} pixels cannot be compared with one of {}", image.pixelCount(), pixels));
}

/// Calls f(a, first, second, weight, pixel, channel) for each channel of each pixel; weight turns squares into relative ones, over the
/// number of values.
template <class F>
void forEachValue(const FilmImage& a, const References& r, F&& f) {
    checkSize(a, r.first.pixelCount());
    checkSize(a, r.second.pixelCount());
    const double mean = (meanOf(r.first) + meanOf(r.second)) / 2, count = 3 * static_cast<double>(a.pixelCount());
    for (size_t i = 0; i < a.pixelCount(); ++i)
        for (int c = 0; c < 3; ++c) {
            const double first = r.first.color[i][c], second = r.second.color[i][c];
            f(static_cast<double>(a.color[i][c]), first, second, relativeSquare(1, (first + second) / 2, mean) / count, i, c);
        }
}

/// The two-sided 95 % quantile of Student's t distribution (Abramowitz and Stegun 1964, 26.7.5, two terms; 2 % off at two degrees of
/// freedom).
double studentQuantile(int freedom) {
    if (freedom < 1) return 0;
    if (freedom == 1) return 12.706;
    const double z = 1.95996, n = freedom;
    return z + (z * z * z + z) / (4 * n) + (5 * std::pow(z, 5) + 16 * std::pow(z, 3) + 3 * z) / (96 * n * n);
}

/// The variance of a mean of values.
double varianceOfMean(std::span<const double> values) {
    const double n = static_cast<double>(values.size()), mean = std::accumulate(values.begin(), values.end(), 0.) / n;
    double squares = 0;
    for (double v : values) squares += (v - mean) * (v - mean);
    return n > 1 ? squares / (n - 1) / n : 0;
}

Interval around(double value, double halfWidth) { return {value, value - halfWidth, value + halfWidth}; }

}  // namespace

double meanOf(const FilmImage& image) {
    double sum = 0;
    for (const glm::vec3& c : image.color) sum += static_cast<double>(c.x) + c.y + c.z;
    return image.color.empty() ? 0 : sum / (3 * static_cast<double>(image.color.size()));
}

FilmImage References::mean() const {
    checkSize(second, first.pixelCount());
    FilmImage image = first;
    for (size_t i = 0; i < image.color.size(); ++i) image.color[i] = 0.5f * (first.color[i] + second.color[i]);
    return image;
}

double References::relativeError() const {
    double square = 0;
    forEachValue(first, *this, [&](double, double a, double b, double weight, size_t, int) { square += weight * (a - b) * (a - b) / 4; });
    return std::sqrt(square);
}

void SeedSums::add(const FilmImage& image) {
    if (seeds == 0) {
        mean = image;
        for (glm::vec3& c : mean.color) c = glm::vec3(0);
        squares.assign(image.pixelCount(), glm::vec3(0));
    }
    checkSize(image, mean.pixelCount());
    ++seeds;
    for (size_t i = 0; i < squares.size(); ++i) {
        const glm::vec3 delta = image.color[i] - mean.color[i];
        mean.color[i] += delta / static_cast<float>(seeds);
        squares[i] += delta * (image.color[i] - mean.color[i]);
    }
}

double squaredErrorOf(const FilmImage& image, const References& references) {
    double sum = 0;
    forEachValue(image, references,
                 [&](double a, double first, double second, double weight, size_t, int) { sum += weight * (a - first) * (a - second); });
    return sum;
}

TrueError estimateTrueError(const SeedSums& sums, std::span<const double> squaredErrors, std::span<const double> means,
                            const References& references) {
    const double seeds = sums.seeds;
    TrueError e;
    std::vector<double> variances(sums.squares.size());
    double biasOfMean = 0, fromReferences = 0, fromSeeds = 0;  // the last two: variances of the bias's square
    forEachValue(sums.mean, references, [&](double a, double first, double second, double weight, size_t i, int c) {
        const double variance = sums.seeds > 1 ? static_cast<double>(sums.squares[i][c]) / (seeds - 1) : 0;
        const double bias = a - (first + second) / 2, difference = (first - second) * (first - second) / 2;  // variance of a reference
        e.variance += weight * variance;
        variances[i] += weight * variance;
        biasOfMean += weight * (a - first) * (a - second);
        fromReferences += weight * weight * (difference * difference / 3 + 2 * bias * bias * difference);
        const double overSeeds = variance / seeds;
        fromSeeds += weight * weight * (2 * overSeeds * overSeeds + 4 * bias * bias * overSeeds);
    });
    const size_t few = std::max<size_t>(1, variances.size() / 1000);
    std::ranges::nth_element(variances, variances.begin() + static_cast<std::ptrdiff_t>(few), std::greater());
    if (e.variance > 0)
        e.concentration = std::accumulate(variances.begin(), variances.begin() + static_cast<std::ptrdiff_t>(few), 0.) / e.variance;
    e.biasSquare = around(biasOfMean - e.variance / seeds, 1.96 * std::sqrt(fromSeeds + fromReferences));
    const double square = biasOfMean + e.variance * (seeds - 1) / seeds, t = studentQuantile(sums.seeds - 1);
    e.square = around(square, std::sqrt(t * t * varianceOfMean(squaredErrors) + 1.96 * 1.96 * fromReferences));
    const double first = meanOf(references.first), second = meanOf(references.second), reference = (first + second) / 2;
    if (reference > 0)
        e.energy = around(meanOf(sums.mean) / reference - 1,
                          std::hypot(t * std::sqrt(varianceOfMean(means)), 1.96 * (first - second) / 2) / reference);
    return e;
}

}  // namespace eikonal
