#pragma once
// Efficiency of a renderer on one scene: the inverse of variance times time.

#include "image/seed_variance.h"

#include <vector>

namespace eikonal {

/// 1 / (relative variance x seconds): twice the value is the same noise in half the time. [low, high] is a 95 % confidence interval.
struct Efficiency { double value = 0, low = 0, high = 0; };

/// relativeVariance: of a render that takes `seconds` (SeedVariance). seconds: of several renders; the median counts. The interval assumes
/// a log-normal distribution, since the relative errors of both factors are small and independent.
Efficiency efficiencyOf(const Estimate& relativeVariance, const std::vector<double>& seconds);

}  // namespace eikonal
