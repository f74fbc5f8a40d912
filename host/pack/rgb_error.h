#pragma once
// How far RGB rendering would be from spectral rendering, as calculated from the colours of a scene.

#include "image/image_data.h"
#include "pack/space.h"
#include "scene/scene.h"

#include <memory>
#include <string>
#include <vector>

namespace eikonal {

/// The calculation has no visibility: it takes light of the scene to each colour, directly and by way of the others, and compares both ways
/// of multiplying. Relative to the spectrum's colour, the channel that is most off.
struct RgbError {
    double mean = 0;          ///< of the image's mean, about
    double worst = 0;         ///< of the part of the image that is most off, about
    std::string cause;        ///< what the most comes from, with its location
};

/// near: of the scene's bounds (pack/scene_bounds.h).
RgbError predictRgbError(const Scene& scene, const std::vector<std::shared_ptr<const ImageData>>& images, const Box& near);

}  // namespace eikonal
