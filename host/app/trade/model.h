#pragma once
// Predicts time and error of a setting at any number of samples, and chooses settings for a wish.

#include "app/trade/paired.h"
#include "app/trade/setting.h"
#include "app/wish.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace eikonal {

/// A point with its error: what the report shows.
struct MeasuredPoint {
    size_t setting = 0;
    double rung = 0, samples = 0;  ///< samples: mean per pixel
    int seeds = 0;
    double secondsPerPath = 0;  ///< of rendering
    double seconds = 0;         ///< of the user's whole image, predicted: the whole command with compiled kernels
    double compileSeconds = 0, prepareSeconds = 0;
    int compiledKernels = 0;
    TrueError error;
    std::optional<PairedDifference> paired;  ///< beside the user's own options at the same rung; nothing for these
    double flip = 0;               ///< FLIP of one render, tone-mapped
    bool isOnFront = false;        ///< no other point has less error in less time
    double relativeError() const;  ///< the root of relMSE, at least 0
};

/// The error and time of one setting as functions of its samples per pixel n: relMSE = biasSquare + variance(n),
/// seconds = fixed + secondsPerSample * n. The variance is variance1 * n^slope where n is a power of two. Other numbers are worse, since
/// n points of a (0,2)-sequence are one well-spread set for each binary digit of n.
struct SettingModel {
    size_t setting = 0;
    double biasSquare = 0, variance1 = 0;
    Interval slope;                                 ///< of the variance over the samples; -1: independent samples
    double fixedSeconds = 0, secondsPerSample = 0;  ///< of the user's whole image
    double lastRung = 0, lastSamples = 0;           ///< of the ladder
    size_t rungs = 0;                               ///< of the ladder that have been measured; with one, the slope is a guess
    double uncertainty = 0;                         ///< relative half width of the 95 % interval of the error at the last rung
    bool isReliable = true;                         ///< false: few bright samples hold much of the variance, so it may be far too low
    bool isExact = true;                            ///< false: the setting converges to another image
    bool isUniform = true;                          ///< false: adaptive, n is a mean over the pixels, and the variance variance1 * n^slope

    double variance(double samples) const;
    double error(double samples) const;  ///< a root of relMSE
    /// The relative half width of the 95 % interval of that: of what was measured, and of the slope over what is extrapolated.
    double uncertaintyAt(double samples) const;
    double seconds(double samples) const { return fixedSeconds + secondsPerSample * samples; }
    /// The samples for an error, or in a time; nothing if it takes more than 2^24 or less than 1.
    std::optional<double> samplesForError(double error) const;
    std::optional<double> samplesInTime(double seconds) const;
};

/// `points`: of one setting, by ascending samples, at least one. `pixels`: of the user's image. `fixedSeconds`: of the whole command
/// without rendering. `pace`: seconds of rendering a path of the user's image over those of the measured one.
SettingModel fitModel(const std::vector<MeasuredPoint>& points, const Setting& setting, double pixels, double fixedSeconds, double pace);

/// The setting that is predicted to satisfy a wish best: least error in the time, or least time for the error.
struct Recommendation {
    Wish wish;
    bool isPossible = false;
    size_t setting = 0;
    double samples = 0, rung = 0;   ///< rung: what its option says, samples or a target error
    double seconds = 0, error = 0;  ///< predicted
    double uncertainty = 0;         ///< relative, of the error
    double referenceError = 0;      ///< of the references that errors were measured by
    bool isReliable = true;         ///< SettingModel::isReliable
    bool isBetter = true;           ///< significantly more efficient than the user's own options where it was measured; or it is these
    double extrapolation = 1;       ///< samples over those of the longest ladder that was measured
};
Recommendation recommend(const Wish& wish, const std::vector<SettingModel>& models, const std::vector<Setting>& settings);

/// Marks the points of the Pareto front.
void markFront(std::vector<MeasuredPoint>& points);

}  // namespace eikonal
