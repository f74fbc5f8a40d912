#pragma once
// The scheduler: decides the order in which samples of pixels are traced.

#include "film/film.h"
#include "render/profile.h"
#include "device/context.h"
#include "render/tracer.h"

#include <functional>
#include <optional>

namespace eikonal {

/// Progress of a render.
struct Progress {
    double fraction = 0;     ///< of all samples, in [0, 1]; with adaptive sampling, of the samples expected
    double seconds = 0;      ///< since rendering began
    unsigned samples = 0;    ///< samples that every pixel has
    double meanSamples = 0;  ///< mean samples per pixel
};

struct RenderControl {
    unsigned firstSample = 0, endSample = 1;          ///< sample range of each pixel
    std::optional<double> targetError;                ///< set: sampling is adaptive (adaptive.h), and endSample is the maximum per pixel
    ErrorMetric errorMetric = ErrorMetric::relmseRoot;
    std::function<void(const Progress&)> progress;    ///< called after each batch of paths; may be empty
    std::function<bool()> stop;                       ///< checked before each batch; true: no further batch begins; may be empty
    /// Asked every few milliseconds, by another thread; true: batches in flight are abandoned; may be empty
    std::function<bool()> abandon;
};

struct RenderResult {
    bool isFinished = true;             ///< false: ended by RenderControl::stop or abandon
    unsigned samples = 0;               ///< samples that every pixel has
    std::optional<double> error;        ///< adaptive sampling: the expected error, if the render is finished
};

/// Renders the film's pixels. Every pixel gets its samples in order, so stopping, tiling and wave size do not change their values.
RenderResult render(const Context& context, Tracer& tracer, Film& film, Profile& profile, const RenderControl& control);

}  // namespace eikonal
