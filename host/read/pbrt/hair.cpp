#include "read/pbrt/hair.h"

#include "eikonal/formulas.h"

#include <algorithm>
#include <cmath>

namespace eikonal::pbrt {
namespace {

// Absorption per concentration of melanin and fiber radius: d'Eon et al. 2011, "An Energy-Conserving Hair Reflectance Model".
const glm::dvec3 eumelaninAbsorption(0.419, 0.697, 1.37), pheomelaninAbsorption(0.187, 0.4, 1.05);
constexpr double brown = 1.3;  // concentration of eumelanin

Input melanins(TextureRegistry& textures, const Arguments& arguments) {
    const Input dark = textures.input(arguments, "eumelanin"), red = textures.input(arguments, "pheomelanin");
    const SourceLocation& where = dark.where.file ? dark.where : red.where;
    const auto amount = [](const Input& input) { return std::max(input.value.value(), 0.); };
    if (dark.texture == none && red.texture == none)
        return {Spectrum::rgb(amount(dark) * eumelaninAbsorption + amount(red) * pheomelaninAbsorption), none, where};
    // Add by mixing both equally and doubling; texture colours are at most 1, so their scale is a separate number.
    const auto part = [&](const Input& concentration, const glm::dvec3& absorption) {
        const double most = std::max({absorption.x, absorption.y, absorption.z});
        const Input color = textures.derive(kind_scale_texture, {concentration, {Spectrum::rgb(absorption / most)}}, where);
        return textures.derive(kind_scale_texture, {color, {Spectrum::constant(2 * most)}}, where);
    };
    const Input parts[] = {part(dark, eumelaninAbsorption), part(red, pheomelaninAbsorption)};
    return textures.derive(kind_mix_texture, {parts[0], parts[1], {Spectrum::constant(0.5)}}, where);
}

/// The absorption that gives hair a colour: Chiang et al. 2016, equation 9. Far from linear, so it is computed here only for a grey, and
/// otherwise on the device, at each wavelength.
Input absorptionOfColor(TextureRegistry& textures, const Input& color, const Input& betaN) {
    const glm::dvec3 c = color.value.albedo();
    if (color.texture != none || betaN.texture != none || c.x != c.y || c.y != c.z)
        return textures.derive(kind_absorption_texture, {color, betaN}, color.where);
    const double n = std::clamp(betaN.value.value(), 0.01, 1.);
    return {Spectrum::constant(hair_absorption_scale(n) * squared_log(c.x)), none, color.where};
}

}  // namespace

void readHair(Reading& reading, TextureRegistry& textures, const Arguments& arguments, Material& material) {
    const bool hasMelanin = arguments.has("eumelanin") || arguments.has("pheomelanin");
    const char* const used = arguments.has("sigma_a")       ? "sigma_a"
                             : arguments.has("reflectance") ? "reflectance"
                             : hasMelanin                   ? "melanin"
                                                            : "";
    for (const char* name : {"reflectance", "eumelanin", "pheomelanin"}) {
        const bool counts = std::string(name).find(used) != std::string::npos;
        if (*used && !counts && arguments.has(name))
            reading.diagnostics.warn(arguments.whereOf(name),
                                     "\"" + std::string(name) + "\" is ignored, since there is a \"" + used + "\" as well");
    }
    const Input& betaN = material.inputs.at("beta_n");
    if (hasMelanin && std::string(used) == "melanin") material.inputs["sigma_a"] = melanins(textures, arguments);
    else if (std::string(used) == "reflectance")
        material.inputs["sigma_a"] = absorptionOfColor(textures, textures.input(arguments, "reflectance"), betaN);
    else if (!*used) material.inputs["sigma_a"] = {Spectrum::rgb(brown * eumelaninAbsorption)};

    // Across a curve, v goes from 0 to 1 and h from -1 to 1.
    const Input left{Spectrum::constant(-1)}, right{Spectrum::constant(1)};
    material.inputs["h"] = textures.derive(kind_bilerp_texture, {left, right, left, right}, arguments.where());
}

}  // namespace eikonal::pbrt
