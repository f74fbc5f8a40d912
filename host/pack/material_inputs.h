#pragma once
// The parameters of BSDFs: where each has its words, and what is written there for a material.

#include "eikonal/formulas.h"
#include "pack/packer.h"

#include <algorithm>
#include <cmath>

namespace eikonal {

// Slots of every BSDF's parameters, from the lists: slot_diffuse::reflectance. A slot is its number of words in RGB rendering, and, above
// that, how many spectra come before it, each of which is longer in spectral rendering.
constexpr uint spectrumBefore = 256;
#define STEP_uint 1
#define STEP_float 1
#define STEP_spectrum (CHANNELS_RGB + spectrumBefore)
#define PARAMETER_SLOT(q, type, name, FEATURE) name, name##_last = name + STEP_##type - 1,
constexpr uint wordOf(uint slot, bool spectral) {
    return slot % spectrumBefore + (spectral ? (CHANNELS_SPECTRAL - CHANNELS_RGB) * (slot / spectrumBefore) : 0);
}
#define PARAMETER_SLOTS(bsdf, FEATURE, PARAMETERS) \
    namespace slot_##bsdf { enum : uint { PARAMETERS(PARAMETER_SLOT, bsdf) words }; }
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
        add(slot, input_spectrum, packReflectance(packer_, in.value),
            in.texture == none ? NONE : texture(in.texture, TextureUse::reflectance));
    }
    /// "albedo", of what is between two layers: black is nothing.
    void layerMedium(uint slot) {
        packer_.packed.require(Feature::LAYERS, why());
        const Input& in = get("albedo");
        if (in.texture != none || (in.value.isConstant() ? glm::dvec3(in.value.value()) : in.value.albedo()) != glm::dvec3(0))
            packer_.packed.require(Feature::LAYER_MEDIUM, why());
        spectrum(slot, "albedo");
    }
    /// One that may be larger than 1.
    void coefficient(uint slot, const char* name) {
        const Input& in = get(name);
        add(slot, input_spectrum, packCoefficient(packer_, in.value),
            in.texture == none ? NONE : texture(in.texture, TextureUse::coefficient));
    }
    void spectrum(uint slot, glm::dvec3 value) { add(slot, input_spectrum, packRgb(value), NONE); }
    void color(uint slot, const eikonal::color& value) { add(slot, input_spectrum, value, NONE); }
    void constant(uint slot, double value) { add(slot, input_spectrum, packConstant(packer_, value), NONE); }
    /// An index of refraction, which may be another for each wavelength. 0 counts as 1, as in pbrt-v4.
    void index(uint slot, const char* name) {
        const Input& in = get(name);
        if (in.texture != none) return number(slot, name);
        if (in.value.isFlat()) return number(slot, in.value.value() > 0 ? in.value.value() : 1);
        if (!packer_.spectral) {
            packer_.diagnostics.warnOnce("dispersion", in.where, "there is no dispersion in RGB: the mean of the index counts");
            return number(slot, name);
        }
        packer_.packed.require(Feature::DISPERSION, why());
        disperses_ = true;
        SampledCurve index;
        for (const double value : in.value.dense()) {
            index.wavelengths.push_back(shortestWavelength + static_cast<double>(index.wavelengths.size()));
            index.values.push_back(value > 0 ? value : 1);
        }
        add(slot, input_hero, packCoefficient(packer_, Spectrum::sampled(std::move(index))), NONE);
    }
    bool disperses() const { return disperses_; }
    /// The k of a metal with eta = 1 that has this reflectance.
    void metal(uint slot, const char* name) {
        const Input& in = get(name);
        if (packer_.spectral && !in.value.isConstant()) return add(slot, input_spectrum, {}, program(in, TextureUse::metal));
        const glm::dvec3 r = in.value.isConstant() ? glm::dvec3(in.value.value()) : in.value.albedo();
        add(slot, input_spectrum, packRgb({metal_k(r.x), metal_k(r.y), metal_k(r.z)}),
            in.texture == none ? NONE : texture(in.texture, TextureUse::metal));
    }
    void number(uint slot, const char* name) {
        const Input& in = get(name);
        add(slot, input_number, packConstant(packer_, in.value.value()), in.texture == none ? NONE : texture(in.texture));
    }
    void number(uint slot, double value) { add(slot, input_number, packConstant(packer_, value), NONE); }
    void count(uint slot, const char* name) {
        const double value = std::max(get(name).value.value(), 0.0);
        material_input i{NONE, wordOf(slot, packer_.spectral), input_integer, static_cast<uint>(value), {}};
        packer_.packed.tables.material_inputs.push_back(i);
    }
    void file(uint slot) {
        packer_.packed.tables.material_inputs.push_back(
            {NONE, wordOf(slot, packer_.spectral), input_integer, packMeasured(packer_, description_.file, description_.where), {}});
    }
    /// A roughness as a microfacet width.
    void width(uint slot, const char* name) {
        const Input& in = get(name);
        const TextureUse use = description_.remapRoughness ? (regularize_ ? TextureUse::regularRoughness : TextureUse::roughness)
                                                           : (regularize_ ? TextureUse::regularWidth : TextureUse::asItIs);
        add(slot, input_number, packConstant(packer_, widthOf(in.value.value())), in.texture == none ? NONE : texture(in.texture, use));
    }
    /// Those along and across a surface, which has directions if they differ.
    void widths(uint alongSlot, uint acrossSlot, const char* alongName = "uroughness", const char* acrossName = "vroughness") {
        width(alongSlot, alongName);
        width(acrossSlot, acrossName);
        const Input &u = get(alongName), &v = get(acrossName);
        if (u.texture != v.texture || (u.texture == none && u.value.value() != v.value.value()))
            packer_.packed.require(Feature::ANISOTROPY, why());
    }
    /// Whether both roughnesses are so small everywhere that the surface is a mirror.
    bool isSmooth() const {
        for (const char* name : {"uroughness", "vroughness"})
            if (get(name).texture != none || widthOf(get(name).value.value()) >= MIN_ALPHA) return false;
        return true;
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
        return regularize_ ? regular_width(alpha) : alpha;
    }
    Packer& packer_;
    const Material& description_;
    bool regularize_;
    bool disperses_ = false;
};

}  // namespace eikonal
