// Materials as BSDFs with parameters. Adding a BSDF adds a function here: which parameters it has is declared in bsdfs.h.

#include "pack/packer.h"

#include "scene/diffuse_albedo.h"

#include <cmath>
#include <cstring>

namespace eikonal {

// Slots of every BSDF's parameters, from the lists: slot_diffuse::reflectance. A slot is its number of words in RGB rendering, and, above that,
// how many spectra come before it, each of which is longer in spectral rendering.
constexpr uint spectrumBefore = 256;
#define STEP_uint 1
#define STEP_float 1
#define STEP_spectrum (CHANNELS_RGB + spectrumBefore)
#define PARAMETER_SLOT(q, type, name, FEATURE) name, name##_last = name + STEP_##type - 1,
constexpr uint wordOf(uint slot, bool spectral) { return slot % spectrumBefore + (spectral ? (CHANNELS_SPECTRAL - CHANNELS_RGB) * (slot / spectrumBefore) : 0); }
#define PARAMETER_SLOTS(bsdf, FEATURE, PARAMETERS) \
    namespace slot_##bsdf { enum : uint { PARAMETERS(PARAMETER_SLOT, bsdf) words }; } \
    static_assert(wordOf(slot_##bsdf::words, true) <= BSDF_MAX_WORDS);
BSDFS(PARAMETER_SLOTS)

/// Collects the inputs of one material's BSDF.
class InputWriter {
public:
    /// regularize: microfacet widths become those that regularization gives them.
    InputWriter(Packer& packer, const Material& description, bool regularize = false)
        : packer_(packer), description_(description), regularize_(regularize) {}

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
    void color(uint slot, const eikonal::color& value) { add(slot, input_spectrum, value, NONE); }
    void constant(uint slot, double value) { add(slot, input_spectrum, packConstant(packer_, value), NONE); }
    /// An index of refraction, which may be another for each wavelength.
    void index(uint slot, const char* name) {
        const Input& in = get(name);
        if (in.texture != none || in.value.kind() != Spectrum::Kind::sampled) return number(slot, name);
        if (!packer_.spectral) {
            packer_.diagnostics.warnOnce("dispersion", in.where, "there is no dispersion in RGB: the mean of the index counts");
            return number(slot, name);
        }
        packer_.packed.require(Feature::DISPERSION, why());
        disperses_ = true;
        add(slot, input_hero, packCoefficient(packer_, in.value), NONE);
    }
    bool disperses() const { return disperses_; }
    /// The k of a metal with eta = 1 that has this reflectance.
    void metal(uint slot, const char* name) {
        const Input& in = get(name);
        if (packer_.spectral && !in.value.isConstant()) return add(slot, input_spectrum, {}, program(in, TextureUse::metal));
        const glm::dvec3 r = glm::clamp(in.value.isConstant() ? glm::dvec3(in.value.value()) : in.value.albedo(), 0.0, 0.9999);
        add(slot, input_spectrum, packRgb(2.0 * glm::sqrt(r / (1.0 - r))), in.texture == none ? NONE : texture(in.texture, TextureUse::metal));
    }
    void number(uint slot, const char* name) {
        const Input& in = get(name);
        add(slot, input_number, packConstant(packer_, in.value.value()), in.texture == none ? NONE : texture(in.texture));
    }
    void number(uint slot, double value) { add(slot, input_number, packConstant(packer_, value), NONE); }
    void count(uint slot, const char* name) {
        material_input i{NONE, wordOf(slot, packer_.spectral), input_count, static_cast<uint>(std::max(get(name).value.value(), 0.0)), {}};
        packer_.packed.tables.material_inputs.push_back(i);
    }
    void file(uint slot) {
        packer_.packed.tables.material_inputs.push_back({NONE, wordOf(slot, packer_.spectral), input_count, packMeasured(packer_, description_.file, description_.where), {}});
    }
    /// A roughness as a microfacet width.
    void width(uint slot, const char* name) {
        const Input& in = get(name);
        const TextureUse use = description_.remapRoughness ? (regularize_ ? TextureUse::regularRoughness : TextureUse::roughness)
                                                           : (regularize_ ? TextureUse::regularWidth : TextureUse::asItIs);
        add(slot, input_number, packConstant(packer_, widthOf(in.value.value())), in.texture == none ? NONE : texture(in.texture, use));
    }
    /// Whether both roughnesses are so small everywhere that the surface is a mirror.
    bool isSmooth() const {
        for (const char* name : {"uroughness", "vroughness"})
            if (get(name).texture != none || widthOf(get(name).value.value()) >= MIN_ALPHA) return false;
        return true;
    }
    bool isAnisotropic(const char* alongName = "uroughness", const char* acrossName = "vroughness") const {
        const Input &u = get(alongName), &v = get(acrossName);
        return u.texture != v.texture || (u.texture == none && u.value.value() != v.value.value());
    }
    /// What asks for features, for people: "file:line:column: material "name"", without what the description lacks.
    std::string why() const {
        if (!description_.where.file) return "the material of shapes without one";
        return description_.where.toString() + (description_.name.empty() ? ": a material" : ": material \"" + description_.name + "\"");
    }
    Packer& packer() { return packer_; }

private:
    /// A texture, or a value that becomes one.
    uint program(const Input& in, TextureUse use) {
        packer_.packed.require(Feature::TEXTURED, why());
        return packColorInput(packer_, in, use);
    }
    uint texture(int index, TextureUse use = TextureUse::asItIs) {
        packer_.packed.require(Feature::TEXTURED, why());
        return packTexture(packer_, index, use);
    }
    void add(uint slot, input_kind kind, const eikonal::color& value, uint texture) {
        packer_.packed.tables.material_inputs.push_back({texture, wordOf(slot, packer_.spectral), static_cast<uint>(kind), 0, value});
    }
    double widthOf(double roughness) const {
        const double alpha = description_.remapRoughness ? std::sqrt(std::max(roughness, 0.0)) : roughness;
        return regularize_ && alpha < 0.3 ? std::clamp(2 * alpha, 0.1, 0.3) : alpha;
    }
    Packer& packer_;
    const Material& description_;
    bool regularize_;
    bool disperses_ = false;
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

/// A metal's indices: measured, textured, or those that give a reflectance at normal incidence (pbrt-v4: eta = 1). Measured ones are
/// fitted to what the metal reflects in a medium of index `around`.
static void packMetal(InputWriter& in, uint etaSlot, uint kSlot, const char* eta = "eta", const char* k = "k", double around = 1) {
    if (in.has("reflectance")) {
        in.constant(etaSlot, 1);
        in.metal(kSlot, "reflectance");
    } else if (in.packer().spectral || in.get(eta).texture != none || in.get(k).texture != none) {
        in.coefficient(etaSlot, eta);
        in.coefficient(kSlot, k);
    } else {
        const ConductorIndices metal = conductorIndices(in.get(eta).value * (1 / around), in.get(k).value * (1 / around));
        in.spectrum(etaSlot, metal.eta * around);
        in.spectrum(kSlot, metal.k * around);
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
        in.index(slot_specular_dielectric::eta, "eta");
        return hop_specular_dielectric;
    }
    in.index(slot_dielectric::eta, "eta");
    in.width(slot_dielectric::alpha_x, "uroughness");
    in.width(slot_dielectric::alpha_y, "vroughness");
    if (in.isAnisotropic()) in.packer().packed.require(Feature::ANISOTROPY, in.why());
    return hop_dielectric;
}

static hop packThinDielectric(InputWriter& in) {
    in.index(slot_thin_dielectric::eta, "eta");
    return hop_thin_dielectric;
}

static hop packCoatedDiffuse(InputWriter& in) {
    in.spectrum(slot_coated_diffuse::reflectance, "reflectance");
    in.index(slot_coated_diffuse::eta, "eta");
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

static hop packCoatedConductor(InputWriter& in) {
    const double index = in.get("eta").value.value();
    packMetal(in, slot_coated_conductor::metal_eta, slot_coated_conductor::metal_k, "metal_eta", "metal_k", index > 0 ? index : 1);
    in.width(slot_coated_conductor::metal_alpha_x, "metal_uroughness");
    in.width(slot_coated_conductor::metal_alpha_y, "metal_vroughness");
    in.number(slot_coated_conductor::eta, index > 0 ? index : 1);
    in.width(slot_coated_conductor::alpha_x, "uroughness");
    in.width(slot_coated_conductor::alpha_y, "vroughness");
    in.number(slot_coated_conductor::thickness, "thickness");
    in.spectrum(slot_coated_conductor::albedo, "albedo");
    in.number(slot_coated_conductor::g, "g");
    in.count(slot_coated_conductor::max_depth, "maxdepth");
    in.count(slot_coated_conductor::samples, "nsamples");
    if (in.isAnisotropic() || in.isAnisotropic("metal_uroughness", "metal_vroughness")) in.packer().packed.require(Feature::ANISOTROPY, in.why());
    return hop_coated_conductor;
}

static hop packHair(InputWriter& in) {
    in.coefficient(slot_hair::sigma_a, "sigma_a");
    in.number(slot_hair::h, "h");
    in.number(slot_hair::eta, "eta");
    in.number(slot_hair::beta_m, "beta_m");
    in.number(slot_hair::beta_n, "beta_n");
    in.number(slot_hair::scale_tilt, "alpha");
    in.packer().packed.require(Feature::ANISOTROPY, in.why());
    return hop_hair;
}

static hop packMeasuredMaterial(InputWriter& in) {
    in.file(slot_measured::file);
    in.packer().packed.require(Feature::ANISOTROPY, in.why());
    return hop_measured;
}

static hop packPrincipled(InputWriter& in) {
    in.spectrum(slot_principled::base, "base");
    in.number(slot_principled::metallic, "metallic");
    in.number(slot_principled::eta, "eta");
    in.width(slot_principled::alpha_x, "uroughness");
    in.width(slot_principled::alpha_y, "vroughness");
    in.number(slot_principled::coat, "coat");
    in.width(slot_principled::coat_alpha, "coatroughness");
    in.number(slot_principled::sheen, "sheen");
    if (in.isAnisotropic()) in.packer().packed.require(Feature::ANISOTROPY, in.why());
    return hop_principled;
}

static hop packBsdf(InputWriter& in, MaterialKind kind) {
    switch (kind) {
        case MaterialKind::diffuse: return packDiffuse(in);
        case MaterialKind::diffuseTransmission: return packDiffuseTransmission(in);
        case MaterialKind::conductor: return packConductor(in);
        case MaterialKind::dielectric:
        case MaterialKind::subsurface: return packDielectric(in);
        case MaterialKind::thinDielectric: return packThinDielectric(in);
        case MaterialKind::coatedDiffuse: return packCoatedDiffuse(in);
        case MaterialKind::coatedConductor: return packCoatedConductor(in);
        case MaterialKind::hair: return packHair(in);
        case MaterialKind::measured: return packMeasuredMaterial(in);
        case MaterialKind::principled: return packPrincipled(in);
        case MaterialKind::interface: return hop_passage;
        case MaterialKind::mix: return hop_mix;
    }
    return hop_none;
}

bool transmits(hop h) { return h == hop_dielectric || h == hop_specular_dielectric || h == hop_diffuse_transmission || h == hop_hair; }

static constexpr material blank{hop_none, 0, 0, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, 0};

/// Which features a hop's BSDF brings.
static void requireBsdf(Packer& packer, hop h, const std::string& why) {
#define REQUIRE_BSDF(name, FEATURE, PARAMETERS) if (h == hop_##name) packer.packed.require(Feature::FEATURE, why);
    BSDFS(REQUIRE_BSDF)
#undef REQUIRE_BSDF
    if (transmits(h)) packer.packed.require(Feature::TRANSMISSION, why);
    if (h == hop_passage) packer.packed.require(Feature::INTERFACE, why);
    if (h == hop_mix) packer.packed.require(Feature::MIX, why);
}

/// What refracts light exactly lets nobody aim at a light from inside; those that have no size are not found otherwise.
static void warnOfPoints(Packer& packer) {
    for (const Light& l : packer.scene.lights)
        if (std::holds_alternative<PointLight>(l.kind) || std::holds_alternative<SpotLight>(l.kind) || std::holds_alternative<DistantLight>(l.kind))
            packer.diagnostics.warnOnce("lights without a size", l.where,
                                        "light from a point or of one direction does not get below the smooth surface of material \"subsurface\"; with a \"roughness\" it does");
}

/// How light spreads below a surface, and what lets it out.
static uint packProfile(Packer& packer, InputWriter& in, const Material& description) {
    SceneTables& tables = packer.packed.tables;
    const auto [place, isNew] = packer.profiles.try_emplace(description.diffusion.get(), static_cast<uint>(tables.profiles.size()));
    if (!isNew) return place->second;
    for (Feature feature : {Feature::SUBSURFACE, Feature::DIFFUSION, Feature::BSDF_EMERGENCE}) packer.packed.require(feature, in.why());
    const color albedo = packReflectance(packer, description.diffusion->albedo);
    material surface = blank;
    surface.hop = hop_emergence;
    surface.first_input = static_cast<uint>(tables.material_inputs.size());
    const double eta = in.get("eta").value.value();
    in.color(slot_emergence::albedo, albedo);
    in.number(slot_emergence::eta, eta);
    in.number(slot_emergence::passing, boundaryTransmittance(eta));
    surface.input_count = static_cast<uint>(tables.material_inputs.size()) - surface.first_input;
    tables.profiles.push_back({albedo, packCoefficient(packer, description.diffusion->length, packer.space.scale), static_cast<uint>(tables.materials.size())});
    tables.materials.push_back(surface);
    return place->second;
}

/// What stands in for a body that light enters where trees of rays are followed, which branch at surfaces only.
static Material coatOver(Packer& packer, const Material& body) {
    packer.diagnostics.unsupported("subsurface in trees", body.where, "integrator \"whitted\" follows no light inside of bodies of material \"subsurface\"; a coated diffuse surface of the same albedo stands in for it");
    Material coat = body;
    coat.kind = MaterialKind::coatedDiffuse;
    coat.inputs["reflectance"].value = body.diffusion->albedo;
    for (const auto& [name, value] : {std::pair("thickness", 0.01), std::pair("g", 0.0), std::pair("albedo", 0.0), std::pair("maxdepth", 10.0), std::pair("nsamples", 1.0)})
        coat.inputs[name].value = Spectrum::constant(value);
    return coat;
}

/// Everything but what a mix is mixed of, and the twin for regularization.
static void packMaterial(Packer& packer, const Material& description, material& m, bool regularize = false) {
    SceneTables& tables = packer.packed.tables;
    const bool isSurface = description.kind != MaterialKind::interface && description.kind != MaterialKind::mix;
    if (isSurface && !countsMaterials(packer.scene.integrator)) { m.hop = hop_occlusion; return; }
    if (description.kind == MaterialKind::subsurface && packer.scene.integrator.kind == IntegratorKind::whitted) return packMaterial(packer, coatOver(packer, description), m, regularize);
    InputWriter inputs(packer, description, regularize);
    m.first_input = static_cast<uint>(tables.material_inputs.size());
    const hop h = packBsdf(inputs, description.kind);
    m.hop = h;
    m.disperses = inputs.disperses() ? 1 : 0;
    m.input_count = static_cast<uint>(tables.material_inputs.size()) - m.first_input;
    requireBsdf(packer, h, inputs.why());
    if (description.kind == MaterialKind::subsurface && description.method == SubsurfaceMethod::diffusion) m.profile = packProfile(packer, inputs, description);
    if (description.kind == MaterialKind::subsurface && description.method == SubsurfaceMethod::randomWalk) {
        m.interior = packInterior(packer, description.interior, inputs.why());
        if (h == hop_specular_dielectric) warnOfPoints(packer);
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
    std::vector<material>& materials = packer.packed.tables.materials;
    if (index == none) {
        if (packer.defaultMaterial == NONE) {
            Material grey;
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
    if (description.kind == MaterialKind::mix) {
        m.mix_a = packedMaterial(packer, description.mixed[0]);
        m.mix_b = packedMaterial(packer, description.mixed[1]);
        m.mix_amount = packInput(packer, description.inputs.at("amount"));
    }
    m.regular = here;
    if (packer.scene.integrator.regularize && m.hop != hop_occlusion && description.inputs.count("uroughness")) {
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
