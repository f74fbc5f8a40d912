#pragma once
// BSDFs of smooth surfaces: delta distributions, whose kernels define x_is_delta as 1.

#include "kind_features.h"
#include "eikonal/stages.h"

#include <algorithm>

namespace eikonal {

struct SmoothBsdf { Feature feature; next_queue queue; const char* what; };

inline constexpr SmoothBsdf smoothBsdfs[] = {{KindFeature::BSDF_SPECULAR_DIELECTRIC, next_specular_dielectric, "clear glass"},
                                             {KindFeature::BSDF_SPECULAR_CONDUCTOR, next_specular_conductor, "a mirror"},
                                             {KindFeature::BSDF_THIN_DIELECTRIC, next_thin_dielectric, "a pane"}};

/// Whether the BSDF of this queue is one of them.
inline bool isSmoothBsdf(uint queue) {
    return std::ranges::any_of(smoothBsdfs, [&](const SmoothBsdf& b) { return b.queue == queue; });
}

}  // namespace eikonal
