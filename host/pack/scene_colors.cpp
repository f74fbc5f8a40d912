#include "pack/scene_colors.h"

#include "kinds/material_kind.h"
#include "kinds/texture_kind.h"

#include <algorithm>
#include <cmath>

namespace eikonal {
namespace {

/// The part of diffuse light that a coat of index 1.5 reflects back to the surface below it, and that it lets through.
constexpr double insideCoat = 0.6, throughCoat = 0.92 * 0.4;

/// What leaves a layered surface: light is reflected by its base once or more often.
double coated(double base, double layer) {
    const double once = base * layer * layer;
    return throughCoat * once / (1 - insideCoat * std::min(once, 1.0));
}

/// What a medium between the layers lets through, with the light that it scatters.
DualColor layerOf(const DualColor& albedo, double thickness) {
    const double kept = std::exp(-2 * std::max(thickness, 0.0));  // both ways are oblique
    return albedo.map([=](double a) { return kept + (1 - kept) * std::clamp(a, 0.0, 1.0); });
}

/// Fresnel reflectance of a metal at normal incidence, where its colour is strongest.
double metalReflectance(double eta, double k) { return ((eta - 1) * (eta - 1) + k * k) / ((eta + 1) * (eta + 1) + k * k); }

/// Light that crosses hair of this absorption, and that which then crosses another: diameters of two units.
DualColor throughHair(const DualColor& sigmaA) {
    return sigmaA.map([](double sigma) {
        const double t = std::exp(-2 * std::max(sigma, 0.0));
        return 0.4 * (t + t * t + t * t * t);
    });
}

const Input* inputOf(const Material& m, const char* name) {
    const auto found = name ? m.inputs.find(name) : m.inputs.end();
    return found == m.inputs.end() ? nullptr : &found->second;
}

}  // namespace

SceneColors::SceneColors(const Scene& scene, const std::vector<std::shared_ptr<const ImageData>>& images)
    : scene_(scene), images_(images), textures_(scene.textures.size()), materials_(scene.materials.size()) {}

ColorSet SceneColors::ofImage(int image, bool isLight) const {
    constexpr int across = 96;  // texels that are looked at, along each side
    const ImageData& data = *images_[static_cast<size_t>(image)];
    std::vector<glm::dvec3> texels;
    const int columns = std::min(data.width, across), rows = std::min(data.height, across);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const int x = static_cast<int>((column + 0.5) * data.width / columns), y = static_cast<int>((row + 0.5) * data.height / rows);
            const auto channel = [&](int c) { return static_cast<double>(data.at(x, y, data.channels >= 3 ? c : 0)); };
            texels.emplace_back(channel(0), channel(1), channel(2));
        }
    return colorsOf(texels, isLight);
}

const ColorSet& SceneColors::ofTexture(int index, Use use) {
    std::optional<ColorSet>& known = textures_[static_cast<size_t>(index)][static_cast<size_t>(use)];
    if (known) return *known;
    const Texture& texture = scene_.textures[static_cast<size_t>(index)];
    std::vector<ColorSet> operands;
    for (const Input& operand : texture.operands)
        operands.push_back(ofInput(operand, texture.kind->traits.takesCoefficients ? Use::coefficient : use));
    ColorSet set;
    if (texture.kind->traits.colors) {
        set = texture.kind->traits.colors(texture, operands);
    } else if (texture.isFloat || (operands.empty() && texture.image == none)) {
        set = {{DualColor::constant(0.5)}};
    } else if (operands.empty()) {
        set = map(ofImage(texture.image, false), [&](const DualColor& c) {
            return texture.invert ? c.map([](double value) { return std::max(1 - value, 0.0); }) : c * std::max(texture.scale, 0.0);
        });
    } else {
        for (const ColorSet& operand : operands) set = unite(set, 1, operand, 1);
    }
    return *(known = std::move(set));
}

ColorSet SceneColors::ofInput(const Input& input, Use use) {
    if (input.texture != none) return ofTexture(input.texture, use);
    if (use == Use::coefficient) return {{DualColor::coefficient(input.value)}};
    /* The first few are fitted exactly; many come from a table, as they are packed */
    constexpr int few = 256;
    const bool isTabulated = input.value.kind() == Spectrum::Kind::rgb && input.value.space() == ColorSpace::srgb && ++reflectances_ > few;
    return {{isTabulated ? DualColor::texel(input.value.color(), true) : DualColor::reflectance(input.value)}};
}

ColorSet SceneColors::ofMetal(const Material& m) {
    const Input &eta = m.inputs.at(m.kind->metalIndices[0]), &k = m.inputs.at(m.kind->metalIndices[1]);
    const auto reflectance = [](const DualColor& a, const DualColor& b) { return DualColor::combine(a, b, metalReflectance); };
    ColorSet set = combine(ofInput(eta, Use::coefficient), ofInput(k, Use::coefficient), reflectance);
    /* RGB rendering has indices that reflect like the metal */
    if (eta.texture == none && k.texture == none) {
        const ConductorIndices metal = conductorIndices(eta.value, k.value);
        for (int c = 0; c < 3; ++c) set.front().color.rgb[c] = metalReflectance(metal.eta[c], metal.k[c]);
    }
    return set;
}

ColorSet SceneColors::ofBody(const DiffusionProfile& body) {
    if (body.albedoTexture != none) return ofTexture(body.albedoTexture, Use::reflectance);
    DualColor albedo = DualColor::reflectance(body.albedo), length = DualColor::coefficient(body.length);
    if (body.atWavelengths) {
        albedo.spectrum = DualColor::reflectance(body.atWavelengths->albedo).spectrum;
        length.spectrum = DualColor::coefficient(body.atWavelengths->length).spectrum;
    }
    /* Light that leaves near where it entered, and light that was on its way for the mean length of the profile */
    const double mean = (length.rgb.x + length.rgb.y + length.rgb.z) / 3;
    const DualColor far = length.map([=](double d) { return d > 0 ? std::exp(-mean / d) : 0; });
    return {{albedo, 0.5}, {albedo * far, 0.5}};
}

ColorSet SceneColors::scattered(const Material& m) {
    if (m.diffusion) return ofBody(*m.diffusion);
    if (const Input* absorption = inputOf(m, "sigma_a")) return map(ofInput(*absorption, Use::coefficient), throughHair);
    ColorSet set;
    for (const char* name : {"reflectance", "transmittance", "base"})
        if (const Input* input = inputOf(m, name)) set = unite(set, 1, ofInput(*input, Use::reflectance), 1);
    if (set.empty() && inputOf(m, m.kind->metalIndices[0])) set = ofMetal(m);
    const Input *albedo = inputOf(m, "albedo"), *thickness = inputOf(m, "thickness");
    if (!albedo || !thickness) return set;
    const ColorSet layers = map(ofInput(*albedo, Use::reflectance), [&](const DualColor& a) {
        return layerOf(a, thickness->texture == none ? thickness->value.value() : 0.5);
    });
    return combine(set, layers, [](const DualColor& base, const DualColor& layer) { return DualColor::combine(base, layer, coated); });
}

const ColorSet& SceneColors::ofMaterial(int material) {
    static const ColorSet grey{{DualColor::constant(0.5)}};
    if (material == none) return grey;
    std::optional<ColorSet>& known = materials_[static_cast<size_t>(material)];
    if (!known) {
        const Material& m = scene_.materials[static_cast<size_t>(material)];
        known = m.mixed[0] == none ? scattered(m) : unite(ofMaterial(m.mixed[0]), 0.5, ofMaterial(m.mixed[1]), 0.5);
    }
    return *known;
}

DualColor SceneColors::emission(const Spectrum& light) const {
    constexpr size_t few = 256;
    const bool isTabulated = light.kind() == Spectrum::Kind::rgb && light.space() == ColorSpace::srgb &&
                             scene_.lights.size() + scene_.areaLights.size() > few;
    if (!isTabulated) return DualColor::emission(light);
    const DualColor color = DualColor::texel(light.color(), false);
    return {.spectrum = (color * DualColor::white()).spectrum, .rgb = color.rgb};
}

ColorSet SceneColors::ofLight(const Light& light) const {
    if (light.image == none) return {{emission(light.spectrum) * light.scale}};
    return map(ofImage(light.image, true),
               [&](const DualColor& c) { return DualColor{.spectrum = (c * DualColor::white()).spectrum, .rgb = c.rgb} * light.scale; });
}

ColorSet SceneColors::ofLight(const AreaLight& light) const {
    const DualColor L = emission(light.L) * light.scale;
    if (light.image == none) return {{L}};
    return map(ofImage(light.image, true), [&](const DualColor& c) { return c * L; });
}

}  // namespace eikonal
