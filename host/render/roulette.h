#pragma once
// Which rule of Russian roulette renders a scene with the least error in a second, by paths of it that were recorded.

#include "scene/integrator.h"

#include <vector>

namespace eikonal {

/// A path from one chance of roulette to end it to the next: the first from the camera to where it leaves the first point that scatters it.
struct PathSegment {
    float light = 0;        ///< that it brings to the path's estimate: radiance, mean of the channels, as if no path were ended
    float rays = 0;         ///< it took, without the camera ray
    float throughput = 0;   ///< at its end, which roulette goes by; 0: the path ends there
};

/// Paths without roulette: of some pixels, several sets of samples, each with the low discrepancy of a render's first ones.
struct RecordedPaths {
    size_t sets = 0, samples = 0;                  ///< of each pixel, at least 2; and of each set
    std::vector<std::vector<PathSegment>> paths;   ///< of sample i of set k of pixel p: [(p * sets + k) * samples + i]
};

/// What a rule is expected to do to an image.
struct RouletteForecast {
    double relativeVariance;   ///< mean over pixels, as of film/relative_error.h, of the mean of `samples` samples
    double cost;               ///< rays a path
};

/// Plays a rule on recorded paths. Roulette that lets a path go on with probability q that got so far with probability Q adds (1 / (Q q) -
/// 1 / Q) A^2 to the variance of its estimate, where A is the light that is still to come; the increments of different chances are not
/// correlated. What random numbers of low discrepancy take away from that is left out; what varies without roulette is measured between
/// sets, where it is in.
RouletteForecast forecastRoulette(const RecordedPaths& recorded, const Roulette& rule);

/// Of a dozen rules the one with the least product of variance and cost, if that is clearly less than the default's: after Rath et al. 2022
/// (EARS), who find the best probability for each path in each part of the scene; here one rule is found for all. The default where nothing
/// is to be learnt: paths without light.
Roulette chooseRoulette(const RecordedPaths& recorded);

}  // namespace eikonal
