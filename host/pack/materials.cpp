// Materials: a BSDF, and what lies in and on the surface.

#include "kind_features.h"
#include "kinds/integrator_kind.h"
#include "kinds/light_kind.h"
#include "kinds/material_kind.h"
#include "pack/material_inputs.h"

#include "color/diffuse_albedo.h"

namespace eikonal {

bool transmits(next_queue h) {
    return h == next_dielectric || h == next_specular_dielectric || h == next_diffuse_transmission || h == next_hair;
}

static constexpr material blank{next_none, 0, 0, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, 0, 0};

/// Which features the BSDF of a queue brings.
static void requireBsdf(Packer& packer, next_queue h, const std::string& why) {
#define REQUIRE_BSDF(name, FEATURE, PARAMETERS) if (h == next_##name) packer.packed.require(KindFeature::FEATURE, why);
    BSDFS(REQUIRE_BSDF)
#undef REQUIRE_BSDF
    if (transmits(h)) packer.packed.require(Feature::TRANSMISSION, why);
    if (h == next_crossing)
        packer.packed.require(Feature::INTERFACE, why);
    if (h == next_mix) packer.packed.require(Feature::MIX, why);
}

/// Smooth dielectrics block next-event estimation; lights without a size behind them are never found.
static void warnOfPoints(Packer& packer) {
    for (const Light& l : packer.scene.lights)
        if (const LightPlace place = l.kind->place; place == LightPlace::POINT || place == LightPlace::DISTANT)
            packer.diagnostics.warnOnce("lights without a size", l.where,
                                        "light from a point or of one direction does not get below the smooth surface of material "
                                        "\"subsurface\"; with a \"roughness\" it does");
}

static const DiffusionProfile& profileIn(const Packer& packer, const Material& body) {
    return packer.spectral && body.diffusion->atWavelengths ? *body.diffusion->atWavelengths : *body.diffusion;
}

/// How light spreads below a surface, and what lets it out.
static uint packProfile(Packer& packer, InputWriter& in, const Material& description) {
    SceneTables& tables = packer.packed.tables;
    const auto [place, isNew] = packer.profiles.try_emplace(description.diffusion.get(), static_cast<uint>(tables.profiles.size()));
    if (!isNew) return place->second;
    for (Feature feature : {Feature::SUBSURFACE, Feature::DIFFUSION, KindFeature::BSDF_SUBSURFACE_EXIT})
        packer.packed.require(feature, in.why());
    const DiffusionProfile& profile = profileIn(packer, description);
    const color albedo = packReflectance(packer, profile.albedo);
    material surface = blank;
    surface.next_queue = next_subsurface_exit;
    surface.first_input = static_cast<uint>(tables.material_inputs.size());
    const double eta = in.get("eta").value.value();
    in.color(slot_subsurface_exit::albedo, albedo);
    in.number(slot_subsurface_exit::eta, eta);
    in.number(slot_subsurface_exit::passing, boundaryTransmittance(eta));
    surface.input_count = static_cast<uint>(tables.material_inputs.size()) - surface.first_input;
    const auto textureOf = [&](int texture, TextureUse use) {
        if (texture == none) return NONE;
        for (Feature feature : {Feature::TEXTURED, Feature::BODY_TEXTURES}) packer.packed.require(feature, in.why());
        return packTexture(packer, texture, use);
    };
    tables.profiles.push_back({albedo, packCoefficient(packer, profile.length, packer.space.scale),
                               textureOf(profile.albedoTexture, TextureUse::reflectance),
                               textureOf(profile.pathTexture, TextureUse::coefficient), static_cast<float>(std::max(eta * eta - 1, 0.0)),
                               static_cast<uint>(tables.materials.size())});
    tables.materials.push_back(surface);
    return place->second;
}

/// What stands in for a body that light enters where trees of rays are followed, which branch at surfaces only.
static Material coatOver(Packer& packer, const Material& body) {
    packer.diagnostics.unsupported("subsurface in trees", body.where,
                                   "integrator \"whitted\" follows no light inside of bodies of material \"subsurface\"; a coated diffuse "
                                   "surface of the same albedo stands in for it");
    Material coat = body;
    coat.kind = &coated_diffuse_material;
    const DiffusionProfile& profile = profileIn(packer, body);
    coat.inputs["reflectance"] = {profile.albedo, profile.albedoTexture, body.where};
    for (const auto& [name, value] : {std::pair("thickness", 0.01), std::pair("g", 0.0), std::pair("albedo", 0.0),
                                      std::pair("maxdepth", 10.0), std::pair("nsamples", 1.0)})
        coat.inputs[name].value = Spectrum::constant(value);
    return coat;
}

/// Everything but what a mix is mixed of, and the twin for regularization.
static void packMaterial(Packer& packer, const Material& description, material& m, bool regularize = false) {
    SceneTables& tables = packer.packed.tables;
    const bool isSurface = description.kind != &interface_material && description.kind != &mix_material;
    if (isSurface && !countsMaterials(packer.scene.integrator)) { m.next_queue = next_occlusion; return; }
    if (description.kind == &subsurface_material && packer.scene.integrator.kind->splitsRays)
        return packMaterial(packer, coatOver(packer, description), m, regularize);
    InputWriter inputs(packer, description, regularize);
    m.first_input = static_cast<uint>(tables.material_inputs.size());
    const next_queue h = description.kind->pack(inputs);
    m.next_queue = h;
    m.transmits = transmits(h) ? 1 : 0;
    m.disperses = inputs.disperses() ? 1 : 0;
    m.input_count = static_cast<uint>(tables.material_inputs.size()) - m.first_input;
    requireBsdf(packer, h, inputs.why());
    const bool walks = description.method == SubsurfaceMethod::randomWalk && description.interior;
    if (description.kind == &subsurface_material && !walks) {
        if (description.method == SubsurfaceMethod::randomWalk)
            packer.diagnostics.unsupported(
                "textured walk", description.where,
                "where a texture says what is inside of material \"subsurface\", no walk knows it; light is diffused instead");
        m.profile = packProfile(packer, inputs, description);
    }
    if (description.kind == &subsurface_material && walks) {
        m.interior = packInterior(packer, description.interior, inputs.why());
        if (h == next_specular_dielectric) warnOfPoints(packer);
    }
    if (description.displacement != none) {
        packer.packed.require(Feature::BUMP, inputs.why());
        m.displacement = packTexture(packer, description.displacement, TextureUse::displacement);
    }
    if (description.normalMap != none) {
        packer.packed.require(Feature::NORMAL_MAP, inputs.why());
        m.normal_map = packImage(packer, description.normalMap, false);
    }
}

uint packedMaterial(Packer& packer, int index) {
    Table<material>& materials = packer.packed.tables.materials;
    if (index == none) {
        if (packer.defaultMaterial == NONE) {
            Material grey;
            grey.kind = &diffuse_material;
            grey.inputs["reflectance"].value = Spectrum::constant(0.5);
            packer.defaultMaterial = static_cast<uint>(materials.size());
            materials.push_back(blank);
            packMaterial(packer, grey, materials[packer.defaultMaterial]);
            materials[packer.defaultMaterial].regular = packer.defaultMaterial;
        }
        return packer.defaultMaterial;
    }
    /* Only materials that something uses are packed: nothing runs that the scene does not ask for */
    uint& place = packer.materialIndices[static_cast<size_t>(index)];
    if (place != NONE) return place;
    const uint here = place = static_cast<uint>(materials.size());
    materials.push_back(blank);
    const Material& description = packer.scene.materials[static_cast<size_t>(index)];
    material m = blank;
    packMaterial(packer, description, m);
    if (description.kind == &mix_material) {
        m.mix_a = packedMaterial(packer, description.mixed[0]);
        m.mix_b = packedMaterial(packer, description.mixed[1]);
        m.mix_amount = packInput(packer, description.inputs.at("amount"));
    }
    m.regular = here;
    if (packer.scene.integrator.regularize && m.next_queue != next_occlusion && description.inputs.count("uroughness")) {
        packer.packed.require(Feature::REGULARIZE, packer.scene.integrator.where.toString());
        m.regular = static_cast<uint>(materials.size());
        material rougher = blank;
        packMaterial(packer, description, rougher, true);
        materials.push_back(rougher);
    }
    materials[here] = m;
    return here;
}

void packMaterials(Packer& packer) { packer.materialIndices.assign(packer.scene.materials.size(), NONE); }

}  // namespace eikonal
