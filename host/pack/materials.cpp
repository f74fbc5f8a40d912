// Materials as BSDFs with parameters. Adding a BSDF adds a function here: which parameters it has is declared in bsdfs.h.

#include "pack/packer.h"

#include "eikonal/stages.h"

#include <cmath>
#include <cstring>

namespace eikonal {

// Slots of every BSDF's parameters, from the lists: slot_diffuse::reflectance, words_diffuse.
#define PARAMETER_SLOT(q, type, name, FEATURE) name, name##_last = name + WORDS_##type - 1,
#define PARAMETER_SLOTS(bsdf, FEATURE, PARAMETERS) \
    namespace slot_##bsdf { enum : uint { PARAMETERS(PARAMETER_SLOT, bsdf) words }; } \
    static_assert(slot_##bsdf::words <= BSDF_MAX_WORDS);
BSDFS(PARAMETER_SLOTS)

/// Collects the inputs of one material's BSDF.
class InputWriter {
public:
    InputWriter(Packer& packer, const Material& description) : packer_(packer), description_(description) {}

    const Input& get(const char* name) const { return description_.inputs.at(name); }
    bool has(const char* name) const { return description_.inputs.count(name) != 0; }

    void spectrum(uint slot, const char* name) {
        const Input& in = get(name);
        add(slot, input_spectrum, packReflectance(packer_, in.value), in.texture == none ? NONE : texture(in.texture, TextureUse::reflectance));
    }
    /// One that may be larger than 1.
    void coefficient(uint slot, const char* name) {
        const Input& in = get(name);
        add(slot, input_spectrum, packCoefficient(packer_, in.value), in.texture == none ? NONE : texture(in.texture));
    }
    void spectrum(uint slot, glm::dvec3 value) { add(slot, input_spectrum, packRgb(value), NONE); }
    /// The k of a metal with eta = 1 that has this reflectance.
    void metal(uint slot, const char* name) {
        const Input& in = get(name);
        const glm::dvec3 r = glm::clamp(in.value.isConstant() ? glm::dvec3(in.value.value()) : in.value.albedo(), 0.0, 0.9999);
        add(slot, input_spectrum, packRgb(2.0 * glm::sqrt(r / (1.0 - r))), in.texture == none ? NONE : texture(in.texture, TextureUse::metal));
    }
    void number(uint slot, const char* name) {
        const Input& in = get(name);
        add(slot, input_number, packNumber(in.value.value()), in.texture == none ? NONE : texture(in.texture));
    }
    void number(uint slot, double value) { add(slot, input_number, packNumber(value), NONE); }
    void count(uint slot, const char* name) {
        material_input i{NONE, slot, input_count, static_cast<uint>(std::max(get(name).value.value(), 0.0)), {}};
        packer_.packed.tables.material_inputs.push_back(i);
    }
    /// A roughness as a microfacet width.
    void width(uint slot, const char* name) {
        const Input& in = get(name);
        const double value = in.value.value();
        add(slot, input_number, packNumber(description_.remapRoughness ? std::sqrt(std::max(value, 0.0)) : value),
            in.texture == none ? NONE : texture(in.texture, description_.remapRoughness ? TextureUse::roughness : TextureUse::asItIs));
    }
    /// Whether both roughnesses are so small everywhere that the surface is a mirror.
    bool isSmooth() const {
        for (const char* name : {"uroughness", "vroughness"}) {
            const Input& in = get(name);
            const double value = in.value.value();
            if (in.texture != none || (description_.remapRoughness ? std::sqrt(std::max(value, 0.0)) : value) >= MIN_ALPHA) return false;
        }
        return true;
    }
    bool isAnisotropic() const {
        const Input &u = get("uroughness"), &v = get("vroughness");
        return u.texture != v.texture || (u.texture == none && u.value.value() != v.value.value());
    }
    std::string why() const { return description_.where.toString() + ": material \"" + description_.name + "\""; }
    Packer& packer() { return packer_; }

private:
    uint texture(int index, TextureUse use = TextureUse::asItIs) {
        packer_.packed.require(Feature::TEXTURED, why());
        return packTexture(packer_, index, use);
    }
    void add(uint slot, input_kind kind, const color& value, uint texture) {
        packer_.packed.tables.material_inputs.push_back({texture, slot, kind, 0, value});
    }
    Packer& packer_;
    const Material& description_;
};

static hop packDiffuse(InputWriter& in) {
    in.spectrum(slot_diffuse::reflectance, "reflectance");
    return hop_diffuse;
}

static hop packDiffuseTransmission(InputWriter& in) {
    in.spectrum(slot_diffuse_transmission::reflectance, "reflectance");
    in.spectrum(slot_diffuse_transmission::transmittance, "transmittance");
    return hop_diffuse_transmission;
}

/// A metal's indices: measured, textured, or those that give a reflectance at normal incidence (pbrt-v4: eta = 1).
static void packMetal(InputWriter& in, uint etaSlot, uint kSlot) {
    if (in.has("reflectance")) {
        in.spectrum(etaSlot, glm::dvec3(1));
        in.metal(kSlot, "reflectance");
    } else if (in.get("eta").texture != none || in.get("k").texture != none) {
        in.coefficient(etaSlot, "eta");
        in.coefficient(kSlot, "k");
    } else {
        const ConductorIndices metal = conductorIndices(in.get("eta").value, in.get("k").value);
        in.spectrum(etaSlot, metal.eta);
        in.spectrum(kSlot, metal.k);
    }
}

static hop packConductor(InputWriter& in) {
    if (in.isSmooth()) {
        packMetal(in, slot_specular_conductor::eta, slot_specular_conductor::k);
        return hop_specular_conductor;
    }
    packMetal(in, slot_conductor::eta, slot_conductor::k);
    in.width(slot_conductor::alpha_x, "uroughness");
    in.width(slot_conductor::alpha_y, "vroughness");
    if (in.isAnisotropic()) in.packer().packed.require(Feature::ANISOTROPY, in.why());
    return hop_conductor;
}

static hop packDielectric(InputWriter& in) {
    if (in.isSmooth()) {
        in.number(slot_specular_dielectric::eta, "eta");
        return hop_specular_dielectric;
    }
    in.number(slot_dielectric::eta, "eta");
    in.width(slot_dielectric::alpha_x, "uroughness");
    in.width(slot_dielectric::alpha_y, "vroughness");
    if (in.isAnisotropic()) in.packer().packed.require(Feature::ANISOTROPY, in.why());
    return hop_dielectric;
}

static hop packThinDielectric(InputWriter& in) {
    in.number(slot_thin_dielectric::eta, "eta");
    return hop_thin_dielectric;
}

static hop packCoatedDiffuse(InputWriter& in) {
    in.spectrum(slot_coated_diffuse::reflectance, "reflectance");
    in.number(slot_coated_diffuse::eta, "eta");
    in.width(slot_coated_diffuse::alpha_x, "uroughness");
    in.width(slot_coated_diffuse::alpha_y, "vroughness");
    in.number(slot_coated_diffuse::thickness, "thickness");
    in.spectrum(slot_coated_diffuse::albedo, "albedo");
    in.number(slot_coated_diffuse::g, "g");
    in.count(slot_coated_diffuse::max_depth, "maxdepth");
    in.count(slot_coated_diffuse::samples, "nsamples");
    if (in.isAnisotropic()) in.packer().packed.require(Feature::ANISOTROPY, in.why());
    return hop_coated_diffuse;
}

static hop packBsdf(InputWriter& in, MaterialKind kind) {
    switch (kind) {
        case MaterialKind::diffuse: return packDiffuse(in);
        case MaterialKind::diffuseTransmission: return packDiffuseTransmission(in);
        case MaterialKind::conductor: return packConductor(in);
        case MaterialKind::dielectric: return packDielectric(in);
        case MaterialKind::thinDielectric: return packThinDielectric(in);
        case MaterialKind::coatedDiffuse: return packCoatedDiffuse(in);
        case MaterialKind::interface: return hop_passage;
        case MaterialKind::mix: return hop_mix;
    }
    return hop_none;
}

/// Which features a hop's BSDF brings.
static void requireBsdf(Packer& packer, hop h, const std::string& why) {
#define REQUIRE_BSDF(name, FEATURE, PARAMETERS) if (h == hop_##name) packer.packed.require(Feature::FEATURE, why);
    BSDFS(REQUIRE_BSDF)
#undef REQUIRE_BSDF
    if (h == hop_dielectric || h == hop_specular_dielectric) packer.packed.require(Feature::TRANSMISSION, why);
    if (h == hop_passage) packer.packed.require(Feature::INTERFACE, why);
    if (h == hop_mix) packer.packed.require(Feature::MIX, why);
}

static void packMaterial(Packer& packer, const Material& description, material& m) {
    SceneTables& tables = packer.packed.tables;
    InputWriter inputs(packer, description);
    m.first_input = static_cast<uint>(tables.material_inputs.size());
    const hop h = packBsdf(inputs, description.kind);
    m.hop = h;
    m.input_count = static_cast<uint>(tables.material_inputs.size()) - m.first_input;
    requireBsdf(packer, h, inputs.why());
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
    std::vector<material>& materials = packer.packed.tables.materials;
    const material blank{hop_none, 0, 0, NONE, NONE, NONE, NONE, NONE};
    if (index == none) {
        if (packer.defaultMaterial == NONE) {
            Material grey;
            grey.name = "default";
            grey.inputs["reflectance"].value = Spectrum::constant(0.5);
            packer.defaultMaterial = static_cast<uint>(materials.size());
            materials.push_back(blank);
            packMaterial(packer, grey, materials[packer.defaultMaterial]);
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
    if (description.kind == MaterialKind::mix) {
        m.mix_a = packedMaterial(packer, description.mixed[0]);
        m.mix_b = packedMaterial(packer, description.mixed[1]);
        m.mix_amount = packInput(packer, description.inputs.at("amount"));
    }
    packer.packed.tables.materials[here] = m;
    return here;
}

void packMaterials(Packer& packer) { packer.materialIndices.assign(packer.scene.materials.size(), NONE); }

}  // namespace eikonal
