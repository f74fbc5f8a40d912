#pragma once
// What has been measured of one setting at one rung of its ladder.

#include "app/trade/true_error.h"

#include <string>
#include <vector>

namespace eikonal {

/// One render of a point.
struct SeedResult {
    int seed = 0;
    double renderSeconds = 0;
    double meanSamples = 0;    ///< per pixel
    double ownError = 0;  ///< by its own samples, in studyMetric
    double squaredError = 0;   ///< squaredErrorOf its image
    double mean = 0;           ///< meanOf its image
};

/// A setting, by its index, at `rung`: samples per pixel, or a target error.
struct Point {
    size_t setting = 0;
    double rung = 0;
    std::vector<SeedResult> seeds;
    double prepareSeconds = 0;  ///< the least of its sessions
    double compileSeconds = 0;  ///< the most of its sessions: with kernels that were not in the cache
    int compiledKernels = 0;    ///< the most of its sessions
    bool isSameImage = false;   ///< the same bits as the user's own options give: the setting has no effect on the image
    std::string failure;        ///< why it cannot be rendered; empty: it can

    double medianSeconds() const;  ///< of rendering
    double meanSamples() const;
};

/// The sums of a point's images, and the image of its first seed, as files: sums.mean, sums.squares and first, each an EXR.
struct PointImages {
    SeedSums sums;
    FilmImage first;

    /// `stem`: a path without extension. Throws Error.
    void save(const std::string& stem) const;
    static void remove(const std::string& stem);
    static PointImages load(const std::string& stem, int seeds);
};

TrueError estimateTrueError(const Point& point, const SeedSums& sums, const References& references);

}  // namespace eikonal
