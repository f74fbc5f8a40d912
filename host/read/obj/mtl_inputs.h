#pragma once
// Converts statements of an MTL material into textures, images and plain values of a scene.

#include "read/obj/materials.h"

#include <optional>
#include <string>
#include <utility>

namespace eikonal {

/// Adds the inputs of a material to the scene.
class MtlInputs {
public:
    MtlInputs(Scene& scene, const MtlMaterial& mtl, ObjFiles& files, Diagnostics& diagnostics)
        : scene_(scene), mtl_(mtl), files_(files), diagnostics_(diagnostics) {}

protected:
    /// Plain values; `keyword` gives their place.
    Input constant(double value, const std::string& keyword) const { return {Spectrum::constant(value), none, mtl_.whereIs(keyword)}; }
    Input color(const glm::dvec3& value, const std::string& keyword) const { return {Spectrum::rgb(value), none, mtl_.whereIs(keyword)}; }

    /// The product of both.
    Input product(const Input& a, const Input& b, bool isFloat);
    /// The image that a keyword names; nothing if it names none or the file is missing. Warns of unsupported options.
    std::optional<std::pair<MtlTexture, ImageFile>> image(const std::string& keyword, ColorEncoding encoding);
    /// The texture of a keyword: factor * (base + gain * image), as -mm says.
    std::optional<Input> texture(const std::string& keyword, bool isFloat, double factor = 1);

    Scene& scene_;
    const MtlMaterial& mtl_;
    ObjFiles& files_;
    Diagnostics& diagnostics_;
    bool usesUvs_ = false;       ///< whether some image was requested

private:
    Input addTexture(Texture texture);
};

}  // namespace eikonal
