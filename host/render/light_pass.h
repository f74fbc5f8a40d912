#pragma once
// Traces light paths on several devices, and sums what they add to the image.

#include "film/splats.h"
#include "render/device_team.h"

#include <map>
#include <optional>
#include <vector>

namespace eikonal {

class LightPass {
public:
    /// whole: all pixels, each of which begins a light path per sample. part: those whose splats are kept, in `sums`.
    LightPass(const PixelRect& whole, const PixelRect& part, const SplatSums& sums) : whole_(whole), part_(part), halves_(sums.halves()) {}

    struct Work {
        SampleRange samples;
        unsigned mostPaths;    ///< of a batch
        bool onlyFirst;        ///< on the team's first device alone, where paths from the camera then find their vertices
    };
    /// Traces light paths. If a device fails, with the splats that it holds, the others begin again.
    /// isToStop: asked before each batch, by any thread; true: none begins any more. abandon: as for DeviceTeam::run.
    /// Returns the sum of all splats, as kernels/film/splat.clh has them; nothing if it was stopped.
    std::optional<std::vector<uint>> trace(DeviceTeam& team, const Work& work, const std::function<bool()>& isToStop,
                                           const std::function<bool()>& abandon);

private:
    PixelRect whole_, part_;
    size_t halves_;
    std::map<const Tracer*, Buffer> splats_;   ///< by device
};

}  // namespace eikonal
