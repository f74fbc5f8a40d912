#pragma once
// A setting beside the user's own options, by the same seeds: what both renders of a seed share cancels.

#include "app/trade/point.h"

#include <optional>

namespace eikonal {

/// What a setting has, over what the user's own options have; intervals hold 95 %.
struct PairedDifference {
    Interval error;             ///< a root of relMSE, over the own one
    Interval seconds;           ///< of rendering, over the own ones
    Interval efficiency;        ///< 1 / (relMSE x seconds), over the own one
    Interval energy;            ///< mean of the image over the own mean, - 1
    double chanceOfEfficiency;  ///< of an efficiency so different by noise alone, if both had the same
    double chanceOfEnergy;      ///< of an energy so different by noise alone
};

/// Jackknife over the seeds that both points have; nothing with fewer than four, or if squared errors are lost in the references' noise.
/// The seeds of a session are rendered at one time, so the interval of `seconds` holds what differs between two times of measurement only
/// if both points have two sessions.
std::optional<PairedDifference> compareSeeds(const Point& own, const Point& other);

/// The level below which a chance is significant: 1 %, shared by `comparisons` (Bonferroni).
inline double significantChance(size_t comparisons) { return 0.01 / static_cast<double>(comparisons > 0 ? comparisons : 1); }

}  // namespace eikonal
