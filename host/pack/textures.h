#pragma once
// Textures as programs, and the images that they read.

#include "pack/colors.h"

#include <array>
#include <map>
#include <utility>

namespace eikonal {

/// What a texture's value is used as.
enum class TextureUse {
    asItIs,
    coefficient /* colours are not reflectances: they may exceed 1 */,
    reflectance /* clamped to [0, 1] */,
    regularWidth /* a microfacet width, regularized */,
    regularRoughness /* the same of a roughness */,
    roughness /* its square root */,
    metal /* a reflectance to an index of refraction */,
    displacement /* world units to scene units */
};

struct TexturePacking;

/// Packs programs and images when they are first used.
class TexturePacker {
public:
    TexturePacker(const PackContext& context, TextureTables& tables, ColorPacker& colors)
        : context_(context), tables_(tables), colors_(colors) {}

    /// The program of a texture.
    uint texture(int texture, TextureUse use = TextureUse::asItIs);
    /// The same of a texture or a plain number.
    uint input(const Input& input);
    /// The same of an alpha, which rays evaluate at points in the space of a hierarchy, where worldFromPoint leads to where the shape was
    /// defined (as in pbrt-v4: the pattern of an object's alpha moves with its instances).
    uint alpha(const Input& input, const glm::dmat4& worldFromPoint);
    /// The same of a texture or a plain colour.
    uint colorInput(const Input& input, TextureUse use);
    /// The program of an area light's image: radiance relative to the image's mean.
    uint emissionImage(const AreaLight&);
    /// Mean luminance of an image.
    double meanLuminance(int image);
    /// The index in `images` of an image; asFloat: with one channel.
    uint image(int image, bool asFloat);

    const TextureTables& tables() const { return tables_; }

private:
    TexturePacking inScene();   ///< for programs that are evaluated at points in scene space

    const PackContext& context_;
    TextureTables& tables_;
    ColorPacker& colors_;
    std::map<std::pair<int, bool>, uint> images_;             ///< (scene image, asFloat) -> `images`
    std::map<int, double> meanLuminances_;                    ///< of scene images
    std::map<std::pair<int, TextureUse>, uint> programs_;     ///< (scene texture, use) -> `programs`
    std::map<std::pair<int, std::array<double, 16>>, uint> alphas_;   ///< (scene texture, worldFromPoint) -> `programs`
};

}  // namespace eikonal
