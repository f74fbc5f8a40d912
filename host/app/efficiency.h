#pragma once
// Error per second, of one scene by one program.

#include "image/seed_variance.h"

#include <vector>

namespace eikonal {

/// 1 / (relative variance x seconds): twice as much is the same noise in half the time. `low` and `high`: an interval that holds the truth 19 times of 20.
struct Efficiency { double value = 0, low = 0, high = 0; };

/// relativeVariance: at the samples that a render of `seconds` takes (SeedVariance); seconds: of several renders, the median counts. The interval is that
/// of a log-normal distribution: relative errors of both factors are small and independent.
Efficiency efficiencyOf(const Estimate& relativeVariance, const std::vector<double>& seconds);

}  // namespace eikonal
