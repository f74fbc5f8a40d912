#include "pack/materials.h"

#include "kind_features.h"
#include "kinds/integrator_kind.h"
#include "kinds/material_kind.h"
#include "pack/smooth_bsdfs.h"

namespace eikonal {

/// Requires the features of a queue's BSDF.
void MaterialPacker::requireBsdf(next_queue h, const std::string& why) const {
#define REQUIRE_BSDF(name, FEATURE, PARAMETERS) if (h == next_##name) in_.context.require(KindFeature::FEATURE, why);
    BSDFS(REQUIRE_BSDF)
#undef REQUIRE_BSDF
    if (h == next_crossing) in_.context.require(Feature::INTERFACE, why);
    if (h == next_mix) in_.context.require(Feature::MIX, why);
}

/// Packs everything but the materials of a mix and the regularized variant.
void MaterialPacker::pack(const Material& description, PackedMaterial& m, bool regularize) {
    const IntegratorKind& integrator = *in_.context.scene.integrator.kind;
    const bool isSurface = description.kind->isSurface, isForced = isSurface && in_.context.scene.forcesDiffuse;
    if (isSurface && !integrator.countsMaterials()) { m.next_queue = *integrator.surfaceQueue; return; }
    const bool isBody = description.kind == &subsurface_material && !isForced;
    if (isBody && integrator.splitsRays) return pack(coatOver(description), m, regularize);
    InputWriter inputs(in_, description, regularize);
    m.first_input = static_cast<uint>(in_.tables.material_inputs.size());
    const next_queue h = description.kind->pack(inputs);
    if (isForced) inputs.require(Feature::FORCE_DIFFUSE);
    m.next_queue = h;
    m.transmits = inputs.transmits() && !isForced ? 1 : 0;
    m.is_clear = inputs.isClear() && !isForced ? 1 : 0;
    m.disperses = inputs.disperses() ? 1 : 0;
    m.is_delta = isSmoothBsdf(h) && !isForced ? 1 : 0;
    m.input_count = static_cast<uint>(in_.tables.material_inputs.size()) - m.first_input;
    requireBsdf(h, inputs.why());
    if (m.transmits) inputs.require(Feature::TRANSMISSION);
    if (isBody) packInside(inputs, description, m);
    if (description.displacement != none) {
        inputs.require(Feature::BUMP);
        m.displacement = in_.textures.texture(description.displacement, TextureUse::displacement);
    }
    if (description.normalMap != none) {
        inputs.require(Feature::NORMAL_MAP);
        m.normal_map = in_.textures.image(description.normalMap, false);
    }
}

std::vector<int> MaterialPacker::sources() const {
    std::vector<int> sources(in_.tables.materials.size(), none);
    for (size_t i = 0; i < indices_.size(); ++i)
        if (indices_[i] != NONE) sources[indices_[i]] = static_cast<int>(i);
    return sources;
}

uint MaterialPacker::material(int index) {
    Table<PackedMaterial>& materials = in_.tables.materials;
    if (index == none) {
        if (default_ == NONE) {
            Material grey;
            grey.kind = &diffuse_material;
            grey.inputs["reflectance"].value = Spectrum::constant(0.5);
            default_ = static_cast<uint>(materials.size());
            materials.push_back(blankMaterial);
            pack(grey, materials[default_]);
            materials[default_].regular = default_;
        }
        return default_;
    }
    uint& place = indices_[static_cast<size_t>(index)];
    if (place != NONE) return place;
    const uint here = place = static_cast<uint>(materials.size());
    materials.push_back(blankMaterial);
    const Material& description = in_.context.scene.materials[static_cast<size_t>(index)];
    PackedMaterial m = blankMaterial;
    pack(description, m);
    if (description.kind == &mix_material) {
        m.mix_a = material(description.mixed[0]);
        m.mix_b = material(description.mixed[1]);
        m.mix_amount = in_.textures.input(description.inputs.at("amount"));
    }
    const bool isMix = m.next_queue == next_mix;
    if (isMix ? isEntered(m.mix_a) || isEntered(m.mix_b) : m.transmits || m.interior != NONE || m.next_queue == next_crossing)
        entered_.insert(here);
    m.regular = here;
    const IntegratorDescription& integrator = in_.context.scene.integrator;
    const bool isRegularized = integrator.regularize && !in_.context.scene.forcesDiffuse;
    if (isRegularized && m.next_queue != integrator.kind->surfaceQueue && description.inputs.count("uroughness")) {
        in_.context.require(Feature::REGULARIZE, integrator.where.toString());
        m.regular = static_cast<uint>(materials.size());
        PackedMaterial rougher = blankMaterial;
        pack(description, rougher, true);
        materials.push_back(rougher);
    }
    materials[here] = m;
    return here;
}

}  // namespace eikonal
