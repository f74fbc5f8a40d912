#include "render/guide_gain.h"

#include <algorithm>
#include <numeric>

namespace eikonal {

void GuideGain::begin(std::size_t paths) {
    first_ = paths_.size();
    paths_.resize(first_ + paths);
}

void GuideGain::sampled(std::size_t path, double q, double p) {
    Path& at = paths_[first_ + path];
    at.ratio *= q / p;
    at.isGuided = true;
}

void GuideGain::found(std::size_t path, double light) {
    Path& at = paths_[first_ + path];
    if (!at.isGuided) {
        at.direct += light;
        return;
    }
    at.guided += light;
    at.squares += light * light;
    at.squaresWithout += light * light * at.ratio;
}

/// The sum of all but the largest thousandth.
static double trimmedSum(std::vector<double> values) {
    std::ranges::sort(values);
    values.resize(values.size() - (values.size() + 999) / 1000);
    return std::accumulate(values.begin(), values.end(), 0.);
}

double GuideGain::varianceRatio(std::size_t samples) const {
    const double n = static_cast<double>(samples);
    std::vector<double> with, without;
    for (std::size_t pixel = 0; pixel + samples <= paths_.size(); pixel += samples) {
        double direct = 0, directSquares = 0, guided = 0, squares = 0, second = 0, secondWithout = 0;
        for (std::size_t i = pixel; i < pixel + samples; ++i) {
            const Path& p = paths_[i];
            direct += p.direct;
            directSquares += p.direct * p.direct;
            guided += p.guided;
            squares += p.guided * p.guided;
            second += p.guided * p.guided;
            secondWithout += p.squares > 0 ? p.guided * p.guided * (p.squaresWithout / p.squares) : 0;
        }
        /* The square of the mean, from pairs of different paths */
        const double meanSquare = std::max((guided * guided - squares) / (n * (n - 1)), 0.);
        const double variance = std::max(directSquares - direct * direct / n, 0.) / (n - 1);
        with.push_back(variance + std::max(second / n - meanSquare, 0.));
        without.push_back(variance + std::max(secondWithout / n - meanSquare, 0.));
    }
    if (with.empty()) return 1;
    const double a = trimmedSum(without), b = trimmedSum(with);
    return b > 0 ? a / b : 1;
}

}  // namespace eikonal
