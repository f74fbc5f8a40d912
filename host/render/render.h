#pragma once
// The scheduler: decides the order in which samples of pixels are traced.

#include "film/film.h"
#include "render/device_team.h"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace eikonal {

/// Progress of a render.
struct Progress {
    double fraction = 0;     ///< of all samples, in [0, 1]; with adaptive sampling, of those expected, or at first of those allowed
    double seconds = 0;      ///< since rendering began
    std::optional<double> secondsLeft;  ///< expected, from the rate so far; unset before adaptive sampling has made its first plan
    unsigned samples = 0;    ///< samples that every pixel has
    double meanSamples = 0;  ///< mean samples per pixel
};

struct RenderControl {
    unsigned endSample = 1;                           ///< samples that each pixel is to have
    std::optional<double> targetError;                ///< set: sampling is adaptive (adaptive.h), and endSample is the maximum per pixel
    ErrorMetric errorMetric = ErrorMetric::relmseRoot;
    std::vector<unsigned> planned;                    ///< as `pause` gave it, for a film that was stored then; empty: none
    std::function<void(const Progress&)> progress;    ///< called after each batch of paths; may be empty
    /// Called after each batch of paths, with the samples that each block of adaptive sampling is getting (AdaptiveSampling::samples; empty
    /// before the first decision). Together with the film at that moment they are all that a render needs to go on. May be empty.
    std::function<void(std::span<const unsigned> planned)> pause;
    std::function<bool()> stop;                       ///< checked before each batch; true: no further batch begins; may be empty
    /// Asked every few milliseconds, by another thread; true: batches in flight are abandoned; may be empty
    std::function<bool()> abandon;
    /// Told of each device that fails while others are left, which do its work. May be empty.
    std::function<void(const RenderDevice&, const DeviceError&)> dropped;
};

struct RenderResult {
    bool isFinished = true;             ///< false: ended by RenderControl::stop or abandon
    unsigned samples = 0;               ///< samples that every pixel has
    std::optional<double> error;        ///< adaptive sampling: the expected error, if the render is finished
    std::vector<unsigned> planned;      ///< as for RenderControl::pause
};

/// Renders what the film's pixels lack. Every pixel gets its samples in order, so stopping, tiling, wave size and the number of devices do
/// not change their values: a film that was stored in the middle of a render ends with the same bits. The functions of `control` are
/// called by one thread at a time, `abandon` excepted.
RenderResult render(std::span<const RenderDevice> devices, Film& film, const RenderControl& control);

}  // namespace eikonal
