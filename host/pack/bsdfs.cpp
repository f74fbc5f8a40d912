// Adding a BSDF adds a function here: which parameters it has is declared in include/eikonal/bsdfs.h.

#include "pack/bsdfs.h"

namespace eikonal {

static next_queue packDiffuse(InputWriter& in) {
    in.spectrum(slot_diffuse::reflectance, "reflectance");
    return next_diffuse;
}

static next_queue packDiffuseTransmission(InputWriter& in) {
    in.spectrum(slot_diffuse_transmission::reflectance, "reflectance");
    in.spectrum(slot_diffuse_transmission::transmittance, "transmittance");
    return next_diffuse_transmission;
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

static next_queue packConductor(InputWriter& in) {
    if (in.isSmooth()) {
        packMetal(in, slot_specular_conductor::eta, slot_specular_conductor::k);
        return next_specular_conductor;
    }
    packMetal(in, slot_conductor::eta, slot_conductor::k);
    in.widths(slot_conductor::alpha_x, slot_conductor::alpha_y);
    return next_conductor;
}

static next_queue packDielectric(InputWriter& in) {
    if (in.isSmooth()) {
        in.index(slot_specular_dielectric::eta, "eta");
        return next_specular_dielectric;
    }
    in.index(slot_dielectric::eta, "eta");
    in.widths(slot_dielectric::alpha_x, slot_dielectric::alpha_y);
    return next_dielectric;
}

static next_queue packThinDielectric(InputWriter& in) {
    in.index(slot_thin_dielectric::eta, "eta");
    return next_thin_dielectric;
}

static next_queue packCoatedDiffuse(InputWriter& in) {
    in.spectrum(slot_coated_diffuse::reflectance, "reflectance");
    in.index(slot_coated_diffuse::eta, "eta");
    in.widths(slot_coated_diffuse::alpha_x, slot_coated_diffuse::alpha_y);
    in.number(slot_coated_diffuse::thickness, "thickness");
    in.layerMedium(slot_coated_diffuse::albedo);
    in.number(slot_coated_diffuse::g, "g");
    in.count(slot_coated_diffuse::max_depth, "maxdepth");
    in.count(slot_coated_diffuse::samples, "nsamples");
    return next_coated_diffuse;
}

static next_queue packCoatedConductor(InputWriter& in) {
    const double index = in.get("eta").value.value();
    packMetal(in, slot_coated_conductor::metal_eta, slot_coated_conductor::metal_k, "metal_eta", "metal_k", index > 0 ? index : 1);
    in.widths(slot_coated_conductor::metal_alpha_x, slot_coated_conductor::metal_alpha_y, "metal_uroughness", "metal_vroughness");
    in.index(slot_coated_conductor::eta, "eta");
    in.widths(slot_coated_conductor::alpha_x, slot_coated_conductor::alpha_y);
    in.number(slot_coated_conductor::thickness, "thickness");
    in.layerMedium(slot_coated_conductor::albedo);
    in.number(slot_coated_conductor::g, "g");
    in.count(slot_coated_conductor::max_depth, "maxdepth");
    in.count(slot_coated_conductor::samples, "nsamples");
    return next_coated_conductor;
}

static next_queue packHair(InputWriter& in) {
    in.coefficient(slot_hair::sigma_a, "sigma_a");
    in.number(slot_hair::h, "h");
    in.number(slot_hair::eta, "eta");
    in.number(slot_hair::beta_m, "beta_m");
    in.number(slot_hair::beta_n, "beta_n");
    in.number(slot_hair::scale_tilt, "alpha");
    in.packer().packed.require(Feature::ANISOTROPY, in.why());
    return next_hair;
}

static next_queue packMeasuredMaterial(InputWriter& in) {
    in.file(slot_measured::file);
    in.packer().packed.require(Feature::ANISOTROPY, in.why());
    return next_measured;
}

static next_queue packPrincipled(InputWriter& in) {
    in.spectrum(slot_principled::base, "base");
    in.number(slot_principled::metallic, "metallic");
    in.number(slot_principled::eta, "eta");
    in.widths(slot_principled::alpha_x, slot_principled::alpha_y);
    in.number(slot_principled::coat, "coat");
    in.width(slot_principled::coat_alpha, "coatroughness");
    in.number(slot_principled::sheen, "sheen");
    return next_principled;
}

next_queue packBsdf(InputWriter& in, MaterialKind kind) {
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
        case MaterialKind::interface: return next_crossing;
        case MaterialKind::mix: return next_mix;
    }
    return next_none;
}

}  // namespace eikonal
