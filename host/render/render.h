#pragma once
// The scheduler: which samples of which pixels are traced when.

#include "render/film.h"
#include "render/profile.h"
#include "render/stages.h"
#include "render/tracer.h"

#include <functional>

namespace eikonal {

/// How far a render is.
struct Progress {
    double fraction = 0;     ///< of all samples, in [0, 1]
    double seconds = 0;      ///< since rendering began
    unsigned samples = 0;    ///< that every pixel has by now
};

struct RenderControl {
    unsigned firstSample = 0, endSample = 1;          ///< of each pixel
    std::function<void(const Progress&)> progress;    ///< called after each wave; may be empty
    std::function<bool()> stop;                       ///< asked before each wave: ends the render there; may be empty
};

/// Renders the film's pixels. Every pixel gets its samples in order, so stopping, tiling and wave size change no bit of those it has.
/// Returns the number of samples that every pixel has.
unsigned render(const Context& context, Tracer& tracer, Film& film, Profile& profile, const RenderControl& control);

/// How wide and high, as powers of two, tiles of at most `pixels` pixels should be to cover a rectangle with the fewest of them.
struct TileSize { int log2Width, log2Height; };
TileSize chooseTileSize(const PixelRect& rect, unsigned pixels);

}  // namespace eikonal
