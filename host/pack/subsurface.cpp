// Material "subsurface": the interior medium or the diffusion profile of a body.

#include "kind_features.h"
#include "kinds/light_kind.h"
#include "kinds/material_kind.h"
#include "pack/material_slots.h"
#include "pack/materials.h"

#include "color/diffuse_albedo.h"

#include <fmt/format.h>

#include <algorithm>

namespace eikonal {

/// Smooth dielectrics block next-event estimation; lights without a size behind them are never found.
void MaterialPacker::warnOfPoints() const {
    for (const Light& l : in_.context.scene.lights)
        if (const LightPlace place = l.kind->place; place == LightPlace::POINT || place == LightPlace::DISTANT)
            in_.context.diagnostics.warnOnce("lights without a size", l.where,
                                             "point and directional lights do not illuminate the inside of a smooth material "
                                             "\"subsurface\"; with a \"roughness\" they do");
}

const DiffusionProfile& MaterialPacker::profileOf(const Material& body) const {
    return in_.context.spectral && body.diffusion->atWavelengths ? *body.diffusion->atWavelengths : *body.diffusion;
}

/// The diffusion profile of a body, and the material of its exit points.
uint MaterialPacker::profile(InputWriter& inputs, const Material& description) {
    MaterialTables& tables = in_.tables;
    const auto [place, isNew] = profiles_.try_emplace(description.diffusion.get(), static_cast<uint>(tables.profiles.size()));
    if (!isNew) return place->second;
    for (Feature feature : {Feature::SUBSURFACE, Feature::DIFFUSION, KindFeature::BSDF_SUBSURFACE_EXIT}) inputs.require(feature);
    const DiffusionProfile& profile = profileOf(description);
    const color albedo = in_.colors.reflectance(profile.albedo);
    PackedMaterial surface = blankMaterial;
    surface.next_queue = next_subsurface_exit;
    surface.first_input = static_cast<uint>(tables.material_inputs.size());
    const double eta = inputs.get("eta").value.value();
    inputs.color(slot_subsurface_exit::albedo, albedo);
    inputs.number(slot_subsurface_exit::eta, eta);
    inputs.number(slot_subsurface_exit::passing, boundaryTransmittance(eta));
    surface.input_count = static_cast<uint>(tables.material_inputs.size()) - surface.first_input;
    const auto textureOf = [&](int texture, TextureUse use) {
        if (texture == none) return NONE;
        for (Feature feature : {Feature::TEXTURED, Feature::BODY_TEXTURES}) inputs.require(feature);
        return in_.textures.texture(texture, use);
    };
    tables.profiles.push_back({albedo, in_.colors.coefficient(profile.length, in_.context.space.scale),
                               textureOf(profile.albedoTexture, TextureUse::reflectance),
                               textureOf(profile.pathTexture, TextureUse::coefficient), static_cast<float>(std::max(eta * eta - 1, 0.0)),
                               static_cast<uint>(tables.materials.size())});
    tables.materials.push_back(surface);
    return place->second;
}

/// The reflectance of a diffuse surface that has an albedo together with the inside of a boundary above it: the share of light below the
/// boundary that leaves through it (Saunderson 1942, solved for the reflectance).
static Spectrum belowBoundary(const Spectrum& albedo, double eta) {
    const double kept = 1 - boundaryTransmittance(eta) / (eta * eta);  // of diffuse light from inside
    return combineSpectra([&](double A) { return A / std::max(1 - kept + A * kept, 1e-9); }, albedo);
}

/// Replacement for subsurface materials with integrator whitted.
Material MaterialPacker::coatOver(const Material& body) const {
    const DiffusionProfile& profile = profileOf(body);
    in_.context.diagnostics.unsupported(
        "subsurface in trees", body.where,
        fmt::format("integrator \"whitted\" has no subsurface scattering: material \"subsurface\" is a coated diffuse surface {}",
                    profile.albedoTexture == none ? "of the same albedo" : "whose base has its albedo, so it is darker"));
    Material coat = body;
    coat.kind = &coated_diffuse_material;
    const double eta = body.inputs.at("eta").value.value();
    coat.inputs["reflectance"] = {profile.albedoTexture == none ? belowBoundary(profile.albedo, eta) : profile.albedo,
                                  profile.albedoTexture, body.where};
    for (const auto& [name, value] : {std::pair("thickness", 0.0), std::pair("g", 0.0), std::pair("albedo", 0.0),
                                      std::pair("maxdepth", 10.0), std::pair("nsamples", 1.0)})
        coat.inputs[name].value = Spectrum::constant(value);
    return coat;
}

/// The body's medium for a random walk, or its diffusion profile.
void MaterialPacker::packInside(InputWriter& inputs, const Material& description, PackedMaterial& m) {
    const bool asksForWalk = description.method == SubsurfaceMethod::randomWalk;
    if (asksForWalk && description.interior) {
        m.interior = media_.interior(description.interior, inputs.why());
        if (m.next_queue == next_specular_dielectric) warnOfPoints();
        return;
    }
    if (asksForWalk)
        in_.context.diagnostics.unsupported(
            "textured walk", description.where,
            "material \"subsurface\": textured coefficients allow no random walk; the diffusion profile is used instead");
    m.profile = profile(inputs, description);
}

}  // namespace eikonal
