#include "pack/material_inputs.h"

#include "eikonal/formulas.h"
#include "pack/material_slots.h"

#include <algorithm>
#include <cmath>

namespace eikonal {

void InputWriter::spectrum(uint slot, const char* name) {
    const Input& in = get(name);
    add(slot, input_spectrum, in_.colors.reflectance(in.value), in.texture == none ? NONE : texture(in.texture, TextureUse::reflectance));
}

void InputWriter::layerMedium(uint slot) {
    require(Feature::LAYERS);
    const Input& in = get("albedo");
    if (in.texture != none || (in.value.isConstant() ? glm::dvec3(in.value.value()) : in.value.albedo()) != glm::dvec3(0))
        require(Feature::LAYER_MEDIUM);
    spectrum(slot, "albedo");
}

void InputWriter::coefficient(uint slot, const char* name) {
    const Input& in = get(name);
    add(slot, input_spectrum, in_.colors.coefficient(in.value), in.texture == none ? NONE : texture(in.texture, TextureUse::coefficient));
}

void InputWriter::index(uint slot, const char* name) {
    const Input& in = get(name);
    if (in.texture != none) return number(slot, name);
    if (in.value.isFlat()) return number(slot, in.value.value() > 0 ? in.value.value() : 1);
    if (!isSpectral()) {
        in_.context.diagnostics.warnOnce("dispersion", in.where, "RGB rendering has no dispersion; the mean index is used");
        return number(slot, name);
    }
    require(Feature::DISPERSION);
    disperses_ = true;
    DenseCurve index = in.value.dense();
    for (double& value : index) value = value > 0 ? value : 1;
    add(slot, input_hero, in_.colors.coefficient(Spectrum::sampled(index)), NONE);
}

void InputWriter::metal(uint slot, const char* name) {
    const Input& in = get(name);
    if (isSpectral() && !in.value.isConstant()) return add(slot, input_spectrum, {}, program(in, TextureUse::metal));
    const glm::dvec3 r = in.value.isConstant() ? glm::dvec3(in.value.value()) : in.value.albedo();
    add(slot, input_spectrum, packRgb({metal_k(r.x), metal_k(r.y), metal_k(r.z)}),
        in.texture == none ? NONE : texture(in.texture, TextureUse::metal));
}

void InputWriter::number(uint slot, const char* name) {
    const Input& in = get(name);
    add(slot, input_number, in_.colors.constant(in.value.value()), in.texture == none ? NONE : texture(in.texture));
}

void InputWriter::count(uint slot, const char* name) { addInteger(slot, static_cast<uint>(std::max(get(name).value.value(), 0.0))); }

void InputWriter::vertexKey(uint slot) { addInteger(slot, 0, input_vertex_key); }

void InputWriter::file(uint slot) { addInteger(slot, in_.measured.file(description_.file, description_.where)); }

void InputWriter::width(uint slot, const char* name) {
    const Input& in = get(name);
    const TextureUse use = description_.remapRoughness ? (regularize_ ? TextureUse::regularRoughness : TextureUse::roughness)
                                                       : (regularize_ ? TextureUse::regularWidth : TextureUse::asItIs);
    add(slot, input_number, in_.colors.constant(widthOf(in.value.value())), in.texture == none ? NONE : texture(in.texture, use));
}

void InputWriter::widths(uint alongSlot, uint acrossSlot, const char* alongName, const char* acrossName) {
    width(alongSlot, alongName);
    width(acrossSlot, acrossName);
    const Input &u = get(alongName), &v = get(acrossName);
    if (u.texture != v.texture || (u.texture == none && u.value.value() != v.value.value())) require(Feature::ANISOTROPY);
}

void InputWriter::lostEnergy(uint slot, const char* index) {
    const Input &u = get("uroughness"), &v = get("vroughness");
    const auto widthOfInput = [&](const Input& in) {
        return in.texture == none ? std::optional<double>(widthOf(in.value.value())) : std::nullopt;
    };
    MicrofacetSurface surface{widthOfInput(u), widthOfInput(v)};
    surface.isotropic = u.texture == v.texture && (u.texture != none || *surface.alphaX == *surface.alphaY);
    if (index) {
        const Input& in = get(index);
        const auto indexOf = [](double value) { return value > 0 ? value : 1; };
        surface.lowestIndex = surface.highestIndex = indexOf(in.value.value());
        if (isSpectral() && !in.value.isFlat())
            for (const double value : in.value.dense()) {
                surface.lowestIndex = std::min(surface.lowestIndex, indexOf(value));
                surface.highestIndex = std::max(surface.highestIndex, indexOf(value));
            }
    }
    addInteger(slot, in_.energy.table(surface));
}

bool InputWriter::isSmooth() const {
    for (const char* name : {"uroughness", "vroughness"})
        if (get(name).texture != none || widthOf(get(name).value.value()) >= MIN_ALPHA) return false;
    return true;
}

std::string InputWriter::why() const {
    if (!description_.where.file) return "the material of shapes without one";
    return description_.where.toString() + (description_.name.empty() ? ": a material" : ": material \"" + description_.name + "\"");
}

/// A texture, or a constant as a texture program.
uint InputWriter::program(const Input& in, TextureUse use) {
    require(Feature::TEXTURED);
    return in_.textures.colorInput(in, use);
}

uint InputWriter::texture(int index, TextureUse use) {
    require(Feature::TEXTURED);
    return in_.textures.texture(index, use);
}

void InputWriter::add(uint slot, input_kind kind, const eikonal::color& value, uint texture) {
    in_.tables.material_inputs.push_back({texture, wordOf(slot, isSpectral()), static_cast<uint>(kind), 0, value});
}

void InputWriter::addInteger(uint slot, uint value, input_kind kind) {
    in_.tables.material_inputs.push_back({NONE, wordOf(slot, isSpectral()), static_cast<uint>(kind), value, {}});
}

double InputWriter::widthOf(double roughness) const {
    const double alpha = description_.remapRoughness ? std::sqrt(std::max(roughness, 0.0)) : roughness;
    return regularize_ ? regular_width(alpha) : alpha;
}

}  // namespace eikonal
