#pragma once
// What every part of packing may use. Each part is also handed the tables that it writes, and no others; some share the settings.

#include "diagnostics.h"
#include "pack/space.h"
#include "pack/tables.h"
#include "image/image_data.h"
#include "scene/scene.h"

#include <memory>
#include <vector>

namespace eikonal {

struct PackContext {
    const Scene& scene;
    Diagnostics& diagnostics;
    RequiredFeatures& required;
    SceneSpace space{};
    Box bounds{};             ///< of what the space is chosen for, world space (pack/scene_bounds.h)
    Box whole{};              ///< of everything placed in the scene
    bool hasMedia = false;    ///< whether a ray can be inside a medium of the scene
    bool spectral = false;    ///< rendering at sampled wavelengths, not in RGB
    std::vector<std::shared_ptr<const ImageData>> images{};   ///< of scene.images

    void require(Feature feature, const std::string& why) const { required.require(feature, why); }
    bool has(Feature feature) const { return required.features.has(feature); }
    const ImageData& imageData(int image) const { return *images[static_cast<size_t>(image)]; }
};

}  // namespace eikonal
