#pragma once
// The colours of a scene's lights, surfaces and media, as RGB and as spectra.

#include "color/color_set.h"
#include "image/image_data.h"
#include "scene/scene.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace eikonal {

/// Finds the colours of things, each texture once.
class SceneColors {
public:
    SceneColors(const Scene& scene, const std::vector<std::shared_ptr<const ImageData>>& images);

    /// What a surface of this material makes of light that it scatters; without a material, grey.
    const ColorSet& ofMaterial(int material);
    /// Emitted light; of lights with an image, its colours. The luminance of the mean is the light's, but for the size of its source.
    ColorSet ofLight(const Light& light) const;
    ColorSet ofLight(const AreaLight& light) const;

private:
    DualColor emission(const Spectrum& light) const;
    enum class Use { reflectance, coefficient };
    const ColorSet& ofTexture(int texture, Use use);
    ColorSet ofInput(const Input& input, Use use);
    ColorSet ofImage(int image, bool isLight) const;
    ColorSet ofMetal(const Material& m);
    ColorSet ofBody(const DiffusionProfile& body);
    ColorSet scattered(const Material& m);

    int reflectances_ = 0;   ///< that were looked at
    const Scene& scene_;
    const std::vector<std::shared_ptr<const ImageData>>& images_;
    std::vector<std::array<std::optional<ColorSet>, 2>> textures_;   ///< for each use
    std::vector<std::optional<ColorSet>> materials_;
};

}  // namespace eikonal
