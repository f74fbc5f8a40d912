#pragma once
// The scheduler: which samples of which pixels are traced when.

#include "film/film.h"
#include "render/profile.h"
#include "render/stages.h"
#include "render/tracer.h"

#include <functional>
#include <optional>

namespace eikonal {

/// How far a render is.
struct Progress {
    double fraction = 0;     ///< of all samples, in [0, 1]; of those that are expected, where that is not decided yet
    double seconds = 0;      ///< since rendering began
    unsigned samples = 0;    ///< that every pixel has by now
    double meanSamples = 0;  ///< of a pixel
};

struct RenderControl {
    unsigned firstSample = 0, endSample = 1;          ///< of each pixel
    std::optional<double> targetError;                ///< sampling is adaptive (adaptive.h), and endSample the most that a pixel gets
    std::function<void(const Progress&)> progress;    ///< called after each batch of paths; may be empty
    std::function<bool()> stop;                       ///< asked before each batch of paths: those in flight are the last then; may be empty
};

struct RenderResult {
    bool isFinished = true;             ///< not ended by RenderControl::stop
    unsigned samples = 0;               ///< that every pixel has
    std::optional<double> error;        ///< with a target: the expected one, if the render is finished
};

/// Renders the film's pixels. Every pixel gets its samples in order, so stopping, tiling and wave size change no bit of those it has.
RenderResult render(const Context& context, Tracer& tracer, Film& film, Profile& profile, const RenderControl& control);

}  // namespace eikonal
