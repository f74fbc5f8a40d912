#include "image/seed_variance.h"

#include "error.h"
#include "image/relative_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace eikonal {

/// `count`: number of values, including this one.
void SeedVariance::Moments::add(double value, int count) {
    const double n = count, delta = value - mean, step = delta / n, step2 = step * step, term = delta * step * (n - 1);
    mean += step;
    m4 += term * step2 * (n * n - 3 * n + 3) + 6 * step2 * m2 - 4 * step * m3;
    m3 += term * step * (n - 2) - 3 * step * m2;
    m2 += term;
}

/// The k-statistics k2 and k4, and the unbiased estimate of the variance of k2 from them (Kenney and Keeping 1951, 7.8).
SeedVariance::MomentVariance SeedVariance::Moments::variance(int count) const {
    const double n = count, k2 = m2 / (n - 1);
    const double k4 = n * ((n + 1) * m4 - 3 * (n - 1) / n * m2 * m2) / ((n - 1) * (n - 2) * (n - 3));
    return {k2, (2 * n * k2 * k2 + (n - 1) * k4) / (n * (n + 1))};
}

void SeedVariance::add(const FilmImage& image) {
    if (count_ == 0) pixels_.resize(image.pixelCount());
    checkSize(image);
    ++count_;
    for (size_t i = 0; i < pixels_.size(); ++i)
        for (int c = 0; c < 3; ++c) pixels_[i][static_cast<size_t>(c)].add(image.color[i][c], count_);
}

void SeedVariance::checkSize(const FilmImage& image) const {
    if (image.pixelCount() != pixels_.size())
        throw Error(ExitCode::scene, fmt::format("a render of {} pixels cannot be combined with renders of {}", image.pixelCount(), pixels_.size()));
}

Estimate SeedVariance::relativeVariance(const FilmImage* converged, double outliers) const {
    if (converged) checkSize(*converged);
    const auto reference = [&](size_t i, size_t c) { return converged ? converged->color[i][static_cast<int>(c)] : pixels_[i][c].mean; };
    const double values = 3 * static_cast<double>(pixels_.size());
    double mean = 0;
    for (size_t i = 0; i < pixels_.size(); ++i)
        for (size_t c = 0; c < 3; ++c) mean += reference(i, c) / values;

    struct Pixel { double sum = 0; std::array<double, 3> squaredErrors{}; };
    std::vector<Pixel> pixels(pixels_.size());
    for (size_t i = 0; i < pixels_.size(); ++i)
        for (size_t c = 0; c < 3; ++c) {
            const MomentVariance variance = pixels_[i][c].variance(count_);
            const double scale = relativeSquare(1, reference(i, c), mean);
            if (variance.value > 0) {
                pixels[i].sum += variance.value * scale;
                pixels[i].squaredErrors[c] = variance.squaredError * scale * scale;
            }
        }
    const size_t left = pixels.size() - static_cast<size_t>(outliers * static_cast<double>(pixels.size()));
    if (left < pixels.size()) std::ranges::nth_element(pixels, pixels.begin() + static_cast<std::ptrdiff_t>(left), {}, &Pixel::sum);

    double sum = 0;
    std::array<double, 3> squaredErrors{};
    for (size_t i = 0; i < left; ++i) {
        sum += pixels[i].sum;
        for (size_t c = 0; c < 3; ++c) squaredErrors[c] += pixels[i].squaredErrors[c];
    }
    double error = 0;
    for (double squared : squaredErrors) error += std::sqrt(std::max(squared, 0.));
    return {sum / values, error / values};
}

}  // namespace eikonal
