#pragma once
// Runs a command of this program as the user would, to learn what it takes at full size.

#include <string>
#include <vector>

namespace eikonal {

/// What `eikonal render` took for the whole image, in seconds.
struct Confirmation {
    size_t setting = 0;
    double rung = 0;
    double wallSeconds = 0;     ///< of the process
    double renderSeconds = 0;   ///< of that: rendering
    double compileSeconds = 0;  ///< of that: kernels
    std::string failure;        ///< why it failed; empty: it did not
    double meanSamples = 0;     ///< per pixel
    double ownError = 0;        ///< of the whole image, by its own samples, in studyMetric; 0: unknown
    double errorDeviation = 0;  ///< of the logarithm of that

    /// What it takes besides rendering, with compiled kernels.
    double fixedSeconds() const { return wallSeconds - renderSeconds - compileSeconds; }
};

/// Runs `eikonal render scene options...`, which writes its images into `folder`. Fills in the times. Throws an Error (ExitCode::scene)
/// with what the process printed if it fails or is interrupted.
Confirmation confirm(const std::string& scene, const std::vector<std::string>& options, const std::string& folder);

}  // namespace eikonal
