#include "render/roulette.h"

#include "image/relative_error.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace eikonal {
namespace {

/// A rule replaces the default only if it is better by this factor, because forecasts are no more accurate.
constexpr double leastGain = 1.02;

/// The default first.
constexpr Roulette candidates[] = {{},
                                   {RouletteRule::root, 1, 3},
                                   {RouletteRule::root, 1.5, 3},
                                   {RouletteRule::root, 1.5, 1},
                                   {RouletteRule::root, 2, 1},
                                   {RouletteRule::root, 3, 1},
                                   {RouletteRule::root, 5, 1},
                                   {RouletteRule::throughput, 1, 1},
                                   {RouletteRule::throughput, 1.5, 1},
                                   {RouletteRule::throughput, 2, 1},
                                   {RouletteRule::throughput, 3, 1},
                                   {RouletteRule::throughput, 5, 1},
                                   {RouletteRule::throughput, 8, 1}};

double survival(const Roulette& rule, double throughput) {
    return std::min(1., rule.scale * (rule.rule == RouletteRule::throughput ? throughput : std::sqrt(throughput)));
}

double lightOf(const std::vector<PathSegment>& path) {
    return std::accumulate(path.begin(), path.end(), 0., [](double sum, const PathSegment& s) { return sum + s.light; });
}

/// The light of each path, the weight of a squared error in each set of each pixel, and the relative variance of a set without roulette.
struct Sets {
    std::vector<double> lights, weights;
    double relativeVariance = 0;
};

/// Errors of a set are relative to the mean of the pixel's other sets. Relative to its own mean, a set with an outlier would count little.
Sets measureSets(const RecordedPaths& recorded) {
    Sets sets;
    for (const auto& path : recorded.paths) sets.lights.push_back(lightOf(path));
    std::vector<double> means(recorded.paths.size() / recorded.samples);
    for (size_t i = 0; i < sets.lights.size(); ++i) means[i / recorded.samples] += sets.lights[i] / static_cast<double>(recorded.samples);
    const double image = std::accumulate(means.begin(), means.end(), 0.) / static_cast<double>(means.size()),
                 count = static_cast<double>(recorded.sets);

    for (size_t i = 0; i < means.size(); i += recorded.sets) {
        const double sum = std::accumulate(&means[i], &means[i] + recorded.sets, 0.);
        for (size_t k = i; k < i + recorded.sets; ++k) {
            const double error = means[k] - sum / count;
            sets.weights.push_back(relativeSquare(1, (sum - means[k]) / (count - 1), image));
            sets.relativeVariance += sets.weights.back() * error * error * count / (count - 1) / static_cast<double>(means.size());
        }
    }
    return sets;
}

struct Play { double addedVariance = 0, rays = 0; };

/// Plays a rule on one path. `ahead`: light that is still to come; initially all of the path's light.
Play play(const Roulette& rule, const std::vector<PathSegment>& path, double ahead) {
    Play result;
    double reached = 1;
    int depth = 0;
    for (const PathSegment& segment : path) {
        result.rays += reached * segment.rays;
        ahead -= segment.light;
        if (segment.throughput > 0 && depth++ >= rule.depth) {
            const double before = reached;
            reached *= survival(rule, segment.throughput / reached);
            result.addedVariance += (1 / reached - 1 / before) * ahead * ahead;
        }
    }
    return result;
}

RouletteForecast forecast(const RecordedPaths& recorded, const Sets& sets, const Roulette& rule) {
    Play sum;
    for (size_t i = 0; i < recorded.paths.size(); ++i) {
        const Play p = play(rule, recorded.paths[i], sets.lights[i]);
        sum.addedVariance += sets.weights[i / recorded.samples] * p.addedVariance;
        sum.rays += p.rays;
    }
    const double paths = static_cast<double>(recorded.paths.size());
    return {sets.relativeVariance + sum.addedVariance / paths / static_cast<double>(recorded.samples), 1 + sum.rays / paths};
}

}  // namespace

RouletteForecast forecastRoulette(const RecordedPaths& recorded, const Roulette& rule) {
    return forecast(recorded, measureSets(recorded), rule);
}

Roulette chooseRoulette(const RecordedPaths& recorded) {
    const Sets sets = measureSets(recorded);
    std::array<double, std::size(candidates)> products{};
    tbb::parallel_for(size_t{0}, products.size(), [&](size_t i) {
        const RouletteForecast f = forecast(recorded, sets, candidates[i]);
        products[i] = f.relativeVariance * f.cost;
    });
    const auto best = std::min_element(products.begin() + 1, products.end());
    return *best * leastGain < products.front() ? candidates[best - products.begin()] : candidates[0];
}

}  // namespace eikonal
