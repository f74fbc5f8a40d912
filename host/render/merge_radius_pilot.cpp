#include "render/merge_radius_pilot.h"

#include "film/splats.h"
#include "pack/light_vertices.h"
#include "pack/merge_radius.h"
#include "render/pilot.h"
#include "render/survey.h"

#include <algorithm>

namespace eikonal {
namespace {

/// Not a seed that a user is likely to choose.
constexpr uint mergeSeed = 0x6d657267;
constexpr size_t cameraPaths = 2048, mostLightPaths = 1 << 13;

/// The vertices of light paths of so many pixels. What they add to the image is not kept.
SurfacePoints traceLightPaths(const Context& context, const settings& frame, Wave& wave, size_t paths) {
    const PixelRect nowhere{0, 0, 1, 1};
    const Buffer splats(context, SplatSums(nowhere, 1).halves() * sizeof(uint), "splats of the survey");
    Batches batches(BlockSize{}, scatterPixels(frame, paths, 1), wave.mostPaths());
    const auto next = [&] { return batches.empty() ? std::nullopt : std::optional(batches.next()); };
    wave.traceLights({next, [](const Batch&) {}, static_cast<int>(frame.width), static_cast<int>(frame.height)}, splats, nowhere);
    return wave.storedVertices();
}

}  // namespace

std::optional<double> pilotMergeRadius(const Context& context, DeviceScene& scene, const PackedScene& packed, const Stages& stages,
                                       const StageShape& shape, Wave& wave) {
    settings frame = pilotFrame(packed.frame(), mergeSeed);
    frame.stored_share = 0;
    scene.setFrame(context, frame);
    const double pixels = static_cast<double>(frame.width) * frame.height;
    const size_t lightPaths = std::min(mostLightPaths, static_cast<size_t>(frame.width) * frame.height);
    const MergeView view{surveyView(context, scene, stages, shape, cameraPaths), cameraPaths,
                         traceLightPaths(context, frame, wave, lightPaths), lightPaths};
    scene.setFrame(context, packed.frame());
    return chooseMergeRadius(view, pixels, pathsThatKeep(packed.frame(), packed.frame().stored_share), double{frame.merge_radius});
}

}  // namespace eikonal
