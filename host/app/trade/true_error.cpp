#include "app/trade/true_error.h"

#include "app/trade/student.h"
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

/// One channel of one pixel: an image's value, those of both references, and the weight that makes squares relative and a sum of all values
/// a mean. The references' noise is also in the weight, which correlates with the products: see relativeProduct.
struct Value {
    double a, first, second, mean, weight, count;
    double bias() const { return a - (first + second) / 2; }
    double noise() const { return (first - second) * (first - second) / 2; }  ///< the variance of a reference, from two values

    /// (a - first)(a - second), relative. With w(r) = 1 / (r^2 + c) at r = (first + second) / 2, whose variance is noise() / 2, the product
    /// is too large by 2 bias r w^2 noise, and by the product times w''(r) noise() / 4; where the noise is as large as the value, these
    /// series do not hold and are left out.
    double relativeProduct() const {
        const double r = (first + second) / 2, w = weight * count, product = (a - first) * (a - second);
        const double correlated = 2 * bias() * r * w * w * noise(), curved = product * w * w * (4 * r * r * w - 1) * noise() / 2;
        return w * noise() > 0.1 ? w * product / count : (w * product - correlated - curved) / count;
    }
};

/// Calls f(value, pixel, channel) for each channel of each pixel.
template <class F>
void forEachValue(const FilmImage& a, const References& r, F&& f) {
    checkSize(a, r.first.pixelCount());
    checkSize(a, r.second.pixelCount());
    const double mean = (meanOf(r.first) + meanOf(r.second)) / 2, count = 3 * static_cast<double>(a.pixelCount());
    for (size_t i = 0; i < a.pixelCount(); ++i)
        for (int c = 0; c < 3; ++c) {
            const double first = r.first.color[i][c], second = r.second.color[i][c];
            f(Value{a.color[i][c], first, second, mean, relativeSquare(1, (first + second) / 2, mean) / count, count}, i, c);
        }
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
    forEachValue(first, *this, [&](const Value& v, size_t, int) { square += v.weight * v.noise() / 2; });
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
    forEachValue(image, references, [&](const Value& v, size_t, int) { sum += v.relativeProduct(); });
    return sum;
}

TrueError estimateTrueError(const SeedSums& sums, std::span<const double> squaredErrors, std::span<const double> means,
                            const References& references) {
    const double seeds = sums.seeds;
    TrueError e;
    std::vector<double> variances(sums.squares.size());
    double biasOfMean = 0, fromReferences = 0, fromSeeds = 0, meanNoise = 0;      // the last three: variances
    double deviationOfReferences = 0, deviationOfSeeds = 0, deviationOfMean = 0;  // of the pixel so far
    forEachValue(sums.mean, references, [&](const Value& v, size_t i, int c) {
        const double variance = sums.seeds > 1 ? static_cast<double>(sums.squares[i][c]) / (seeds - 1) : 0, overSeeds = variance / seeds;
        const double noise = v.noise(), biasSquare = std::max(v.bias() * v.bias() - overSeeds - noise / 2, 0.);
        e.variance += v.weight * variance;
        variances[i] += v.weight * variance;
        biasOfMean += v.relativeProduct();
        /* The channels of a pixel may err together, so their standard deviations add up; pixels are independent */
        deviationOfReferences += v.weight * std::sqrt(noise * noise / 3 + 2 * biasSquare * noise);
        deviationOfSeeds += v.weight * std::sqrt(2 * overSeeds * overSeeds + 4 * biasSquare * overSeeds);
        deviationOfMean += std::sqrt(noise / 2) / v.count;
        if (c < 2) return;
        fromReferences += deviationOfReferences * deviationOfReferences;
        fromSeeds += deviationOfSeeds * deviationOfSeeds;
        meanNoise += deviationOfMean * deviationOfMean;
        deviationOfReferences = deviationOfSeeds = deviationOfMean = 0;
    });
    const size_t few = std::max<size_t>(1, variances.size() / 1000);
    const auto most = variances.begin() + static_cast<std::ptrdiff_t>(std::min(few, variances.size()));
    std::ranges::partial_sort(variances, most, std::greater());
    if (e.variance > 0) e.concentration = std::accumulate(variances.begin(), most, 0.) / e.variance;
    const double bias = biasOfMean - e.variance / seeds, deviationOfBias = std::sqrt(fromSeeds + fromReferences);
    e.biasSquare = around(bias, 1.96 * deviationOfBias);
    e.chanceOfBias = deviationOfBias > 0 ? std::erfc(bias / deviationOfBias / std::sqrt(2)) / 2 : 1;
    const double square = biasOfMean + e.variance * (seeds - 1) / seeds, t = studentQuantile(sums.seeds - 1);
    e.square = around(square, std::sqrt(t * t * varianceOfMean(squaredErrors) + 1.96 * 1.96 * fromReferences));
    const double reference = (meanOf(references.first) + meanOf(references.second)) / 2;
    if (reference > 0) {
        const double energy = meanOf(sums.mean) / reference - 1, seedNoise = varianceOfMean(means) / (reference * reference),
                     referenceNoise = meanNoise / (reference * reference), deviation = std::sqrt(seedNoise + referenceNoise);
        e.energy = around(energy, std::sqrt(t * t * seedNoise + 1.96 * 1.96 * referenceNoise));
        /* Two tests, so twice the smaller chance */
        const double chanceOfEnergy = deviation > 0 && sums.seeds > 1 ? studentTail(energy / deviation, sums.seeds - 1) : 1;
        e.chanceOfBias = std::min(1., 2 * std::min(e.chanceOfBias, chanceOfEnergy));
    }
    return e;
}

}  // namespace eikonal
