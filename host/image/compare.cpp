#include "image/compare.h"

#include "error.h"
#include "color/luminance.h"
#include "image/relative_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

namespace eikonal {
namespace {

bool isFinite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// The sum of both images' luminance variances at pixel (x, y).
double varianceAt(const FilmImage& image, const FilmImage& reference, int x, int y) {
    const double own = image.variance[image.index(x, y)];
    return own + (reference.variance.empty() ? own : reference.variance[reference.index(x, y)]);
}

/// Sums over pixels.
struct Sums {
    double count = 0;
    glm::dvec3 image{0}, reference{0}, difference{0}, squares{0};
    double variance = 0;  ///< of the luminance

    void add(const glm::dvec3& a, const glm::dvec3& b) {
        ++count;
        image += a;
        reference += b;
        difference += a - b;
        squares += (a - b) * (a - b);
    }
    /// Standard error of the mean difference, from the variance; a channel's noise relates to the luminance's noise as the channel to the
    /// luminance.
    glm::dvec3 knownError() const {
        const glm::dvec3 both = image + reference;
        const double brightness = luminance(both);
        return brightness > 0 ? std::sqrt(variance) / count * glm::abs(both) / brightness : glm::dvec3(0);
    }
    /// Standard error of the mean difference, from the spread of the differences.
    glm::dvec3 scatterError() const {
        if (count < 2) return glm::dvec3(0);
        const glm::dvec3 mean = difference / count;
        return glm::sqrt(glm::max(squares / count - mean * mean, 0.) / (count - 1));
    }
};

/// relMSE of each pixel of `part` that is finite in both images; `mean` is the reference's mean.
std::vector<double> relativeMses(const FilmImage& image, const FilmImage& reference, const PixelBounds& part, const glm::dvec3& mean) {
    std::vector<double> errors;
    for (int y = part.y0; y < part.y1; ++y)
        for (int x = part.x0; x < part.x1; ++x) {
            const glm::vec3 &p = image.color[image.index(x, y)], &q = reference.color[reference.index(x, y)];
            if (!isFinite(p) || !isFinite(q)) continue;
            double sum = 0;
            for (int c = 0; c < 3; ++c) sum += relativeSquare(std::pow(double(p[c]) - q[c], 2), q[c], (mean.x + mean.y + mean.z) / 3);
            errors.push_back(sum / 3);
        }
    return errors;
}

double meanOf(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.) / std::max(static_cast<double>(values.size()), 1.);
}

std::vector<double> withoutTheWorst(std::vector<double> errors) {
    const size_t worst = errors.size() > 1 ? (errors.size() + 999) / 1000 : 0;
    std::ranges::nth_element(errors, errors.end() - static_cast<std::ptrdiff_t>(worst));
    errors.resize(errors.size() - worst);
    return errors;
}

}  // namespace

double BlockDifference::distance(double relative, double sigmas) const {
    double worst = 0;
    for (int c = 0; c < 3; ++c)
        if (const double off = std::abs(image[c] - reference[c]); off > 0)
            worst = std::max(worst, off / (relative * std::abs(reference[c]) + sigmas * standardError[c] + negligible[c]));
    return worst;
}

double Comparison::worstMean() const {
    double worst = 0;
    for (int c = 0; c < 3; ++c) {
        const double difference = std::abs(mean[c] - referenceMean[c]);
        if (difference > 0)
            worst =
                std::max(worst, referenceMean[c] != 0 ? difference / std::abs(referenceMean[c]) : std::numeric_limits<double>::infinity());
    }
    return worst;
}

const BlockDifference& Comparison::worstBlock(double relative, double sigmas) const {
    return *std::ranges::max_element(blocks, {}, [&](const BlockDifference& block) { return block.distance(relative, sigmas); });
}

PixelBounds sharedPixels(const FilmImage& image, const FilmImage& reference) {
    if (image.width != reference.width || image.height != reference.height)
        throw Error(ExitCode::scene, fmt::format("images of {} x {} and {} x {} pixels cannot be compared", image.width, image.height,
                                                 reference.width, reference.height));
    const PixelBounds &a = image.bounds, &b = reference.bounds;
    const PixelBounds both{std::max(a.x0, b.x0), std::min(a.x1, b.x1), std::max(a.y0, b.y0), std::min(a.y1, b.y1)};
    if (both.x0 >= both.x1 || both.y0 >= both.y1) throw Error(ExitCode::scene, "the images have no pixel in common");
    return both;
}

Comparison compare(const FilmImage& image, const FilmImage& reference, int blockSize) {
    const PixelBounds both = sharedPixels(image, reference);

    const bool noiseKnown = !image.variance.empty();
    Comparison result;
    Sums whole;
    for (int y0 = both.y0; y0 < both.y1; y0 += blockSize)
        for (int x0 = both.x0; x0 < both.x1; x0 += blockSize) {
            Sums block;
            for (int y = y0; y < std::min(y0 + blockSize, both.y1); ++y)
                for (int x = x0; x < std::min(x0 + blockSize, both.x1); ++x) {
                    const glm::vec3 &p = image.color[image.index(x, y)], &q = reference.color[reference.index(x, y)];
                    if (!isFinite(p) || !isFinite(q)) { ++result.invalid; continue; }
                    block.add(p, q);
                    if (noiseKnown) block.variance += varianceAt(image, reference, x, y);
                    whole.add(p, q);
                }
            const double count = std::max(block.count, 1.);
            result.blocks.push_back(
                {x0, y0, block.image / count, block.reference / count, noiseKnown ? block.knownError() : block.scatterError()});
        }
    if (whole.count == 0) throw Error(ExitCode::scene, "the images have no pixel that is finite in both");
    const double count = whole.count;
    result.mean = whole.image / count;
    result.referenceMean = whole.reference / count;
    const std::vector<double> errors = relativeMses(image, reference, both, whole.reference / count);
    result.relativeMse = meanOf(errors);
    result.trimmedRelativeMse = meanOf(withoutTheWorst(errors));
    for (BlockDifference& block : result.blocks) block.negligible = 1e-4 * glm::abs(result.referenceMean);
    return result;
}

}  // namespace eikonal
