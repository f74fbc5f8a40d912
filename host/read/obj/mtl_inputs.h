#pragma once
// What the statements of a MTL material become: textures, images and plain values of a scene.

#include "read/obj/materials.h"

#include <optional>
#include <string>
#include <utility>

namespace eikonal {

/// Adds to the scene what inputs of a material need.
class MtlInputs {
public:
    MtlInputs(Scene& scene, const MtlMaterial& mtl, ObjFiles& files, Diagnostics& diagnostics) : scene_(scene), mtl_(mtl), files_(files), diagnostics_(diagnostics) {}

protected:
    /// Plain values, which the keyword's statement gives.
    Input constant(double value, const std::string& keyword) const { return {Spectrum::constant(value), none, mtl_.whereIs(keyword)}; }
    Input color(const glm::dvec3& value, const std::string& keyword) const { return {Spectrum::rgb(value), none, mtl_.whereIs(keyword)}; }

    /// Both multiplied.
    Input product(const Input& a, const Input& b, bool isFloat);
    /// The number of an image in the scene, which has each once.
    int addImage(ImageFile image);
    /// The image that a keyword names, if it does and the file exists; what its options ask in vain is reported.
    std::optional<std::pair<MtlTexture, ImageFile>> image(const std::string& keyword, ColorEncoding encoding);
    /// The texture of a keyword: base + gain times the image, as -mm says, times factor.
    std::optional<Input> texture(const std::string& keyword, bool isFloat, double factor = 1);

    Scene& scene_;
    const MtlMaterial& mtl_;
    ObjFiles& files_;
    Diagnostics& diagnostics_;
    bool usesUvs_ = false;       ///< some image has been asked for

private:
    Input addTexture(Texture texture);
};

}  // namespace eikonal
