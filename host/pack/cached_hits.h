#pragma once
// Which scenes keep hits of light paths for paths from the camera to connect with, and how many (kernels/shade/cached_hits.clh).

#include "pack/context.h"

#include <string>

namespace eikonal {

/// Has paths from both ends connected, because of `why`. Chooses how many light paths keep their hits. Where light paths are traced.
void requireConnections(const PackContext& context, settings& frame, const std::string& why);

/// Of the hits that are kept at a time.
struct HitCachePlan {
    unsigned passes = 0;  ///< of whole passes, a power of two; 0: the scene keeps none
    size_t hits = 0;      ///< room for so many
    size_t paths = 0;     ///< light paths of these passes that keep hits
};
/// For a render of so many samples per pixel. The first pass alone has room for all its hits; no number changes the image.
HitCachePlan planHitCache(const PackedScene& scene);

/// Whether all paths of a pass have the same wavelengths: those that merge or connect must.
bool sharesWavelengths(const Features& features);

}  // namespace eikonal
