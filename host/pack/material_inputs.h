#pragma once
// Writes the parameters of a material's BSDF.

#include "pack/measured.h"
#include "pack/microfacet_energy.h"
#include "pack/textures.h"

#include <string>

namespace eikonal {

/// The tables of materials, and the parts that pack what their inputs refer to.
struct MaterialPacking {
    const PackContext& context;
    MaterialTables& tables;
    ColorPacker& colors;
    TexturePacker& textures;
    MeasuredPacker& measured;
    MicrofacetEnergyPacker& energy;
};

/// Collects the inputs of one material's BSDF; kinds of materials are packed with it.
class InputWriter {
public:
    /// regularize: microfacet widths are regularized.
    InputWriter(const MaterialPacking& in, const Material& description, bool regularize = false)
        : in_(in), description_(description), regularize_(regularize) {}

    const Input& get(const char* name) const { return description_.inputs.at(name); }
    bool has(const char* name) const { return description_.inputs.count(name) != 0; }

    void spectrum(uint slot, const char* name);
    /// "albedo" of the medium between two layers; black: there is no medium.
    void layerMedium(uint slot);
    /// A spectrum that may exceed 1.
    void coefficient(uint slot, const char* name);
    void spectrum(uint slot, glm::dvec3 value) { add(slot, input_spectrum, packRgb(value), NONE); }
    void color(uint slot, const eikonal::color& value) { add(slot, input_spectrum, value, NONE); }
    void constant(uint slot, double value) { add(slot, input_spectrum, in_.colors.constant(value), NONE); }
    /// An index of refraction, which may vary with the wavelength. 0 counts as 1, as in pbrt-v4.
    void index(uint slot, const char* name);
    bool disperses() const { return disperses_; }
    /// The BSDF refracts light or scatters it to the other side, so both sides are lit. (Not a thin sheet, which only lets light through.)
    void transmit() { transmits_ = true; }
    bool transmits() const { return transmits_; }
    /// Light passes nearly straight through: survey paths of the environment guide do.
    void beClear() { isClear_ = true; }
    bool isClear() const { return isClear_; }
    /// The k of a metal with eta = 1 that has this reflectance.
    void metal(uint slot, const char* name);
    void number(uint slot, const char* name);
    void number(uint slot, double value) { add(slot, input_number, in_.colors.constant(value), NONE); }
    void count(uint slot, const char* name);
    void file(uint slot);
    /// An integer that differs between the vertices of paths, for BSDFs whose evaluation is random.
    void vertexKey(uint slot);
    /// A roughness as a microfacet width.
    void width(uint slot, const char* name);
    /// Both widths; requires anisotropy if they differ.
    void widths(uint alongSlot, uint acrossSlot, const char* alongName = "uroughness", const char* acrossName = "vroughness");
    /// The table of the energy that microfacets of these roughnesses lose. index: the name of a dielectric's; null: all light is reflected.
    void lostEnergy(uint slot, const char* index = nullptr);
    /// Whether the material asks for the light that its microfacets scatter more than once.
    bool compensatesEnergy() const { return description_.compensatesEnergy; }
    /// Whether both roughnesses are so small that the surface is specular everywhere.
    bool isSmooth() const;

    bool isSpectral() const { return in_.context.spectral; }
    void require(Feature feature) const { in_.context.require(feature, why()); }
    /// The reason for required features: "file:line:column: material "name"".
    std::string why() const;

private:
    uint program(const Input& in, TextureUse use);
    uint texture(int index, TextureUse use = TextureUse::asItIs);
    void add(uint slot, input_kind kind, const eikonal::color& value, uint texture);
    void addInteger(uint slot, uint value, input_kind kind = input_integer);
    double widthOf(double roughness) const;

    const MaterialPacking& in_;
    const Material& description_;
    bool regularize_;
    bool disperses_ = false, transmits_ = false, isClear_ = false;
};

}  // namespace eikonal
