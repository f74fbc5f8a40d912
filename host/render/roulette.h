#pragma once
// Chooses the Russian roulette rule with the best efficiency, by simulating rules on recorded paths.

#include "scene/integrator.h"

#include <vector>

namespace eikonal {

/// The part of a path between two roulette decisions. The first one begins at the camera and ends where the path leaves its first
/// scattering event.
struct PathSegment {
    float light = 0;        ///< contribution to the path's radiance estimate, mean of the channels, without roulette
    float rays = 0;         ///< rays traced, without the camera ray
    float throughput = 0;   ///< throughput at its end, on which roulette is based; 0: the path ends there
};

/// Paths traced without roulette: several sets of samples of some pixels. Each set has low discrepancy, like the first samples of a render.
struct RecordedPaths {
    size_t sets = 0, samples = 0;                  ///< sets per pixel, at least 2; samples per set
    std::vector<std::vector<PathSegment>> paths;   ///< [(p * sets + k) * samples + i]: sample i of set k of pixel p
};

/// The expected error and cost of a rule.
struct RouletteForecast {
    double relativeVariance;   ///< relative variance (image/relative_error.h) of the mean of `samples` samples, averaged over pixels
    double cost;               ///< rays per path
};

/// Simulates a rule on recorded paths. A decision that continues with probability q, on a path that has survived with probability Q, adds
/// (1 / (Q q) - 1 / Q) A^2 to the variance of the estimate, where A is the light still to come; the terms of different decisions are
/// uncorrelated. Low-discrepancy samples reduce these terms, which is neglected. The variance without roulette is measured between sets,
/// which includes that reduction.
RouletteForecast forecastRoulette(const RecordedPaths& recorded, const Roulette& rule);

/// Returns the candidate with the least variance * cost, or the default unless that is clearly better. After Rath et al. 2022 (EARS), who
/// optimise survival probabilities locally; this chooses one rule for the whole scene. If no path carries light, returns the default.
Roulette chooseRoulette(const RecordedPaths& recorded);

}  // namespace eikonal
