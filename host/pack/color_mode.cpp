#include "pack/color_mode.h"

#include <variant>

namespace eikonal {
namespace {

bool isMeasured(const Spectrum& s) { return s.kind() != Spectrum::Kind::rgb; }

bool isMeasured(const Light& light) {
    return std::visit([](const auto& kind) {
        if constexpr (requires { kind.I; }) return isMeasured(kind.I);
        else if constexpr (requires { kind.L; }) return isMeasured(kind.L);
        else return false;
    }, light.kind);
}

bool isIndexOfMetal(const Material& m, const std::string& name) {
    return name == "k" || name == "metal_eta" || name == "metal_k" || (name == "eta" && m.kind == MaterialKind::conductor);
}

bool isMeasured(const Medium& m) { return isMeasured(m.sigmaA) || isMeasured(m.sigmaS) || isMeasured(m.Le); }

/// A metal's eta and k are left to three indices that reflect as it does (spectra/spectrum.h).
bool isMeasured(const Material& m) {
    for (const auto& [name, input] : m.inputs)
        if (input.texture == none && isMeasured(input.value) && !isIndexOfMetal(m, name)) return true;
    return (m.interior && isMeasured(*m.interior)) || (m.diffusion && m.diffusion->texture != none && isMeasured(m.diffusion->length));
}

bool isMeasured(const AreaLight& light) { return isMeasured(light.L); }

/// The first of a list that is measured, in words.
template <class Thing> std::string firstMeasured(const std::vector<Thing>& things, const char* what) {
    for (const Thing& thing : things)
        if (isMeasured(thing)) return thing.where.toString() + ": " + what + " given by its spectrum";
    return {};
}

}  // namespace

std::string needOfWavelengths(const Scene& scene) {
    if (scene.film.sensor != "cie1931") return scene.film.where.toString() + ": sensor \"" + scene.film.sensor + "\"";
    for (const std::string& need : {firstMeasured(scene.materials, "a material"), firstMeasured(scene.lights, "a light"),
                                    firstMeasured(scene.areaLights, "an area light"), firstMeasured(scene.media, "a medium")})
        if (!need.empty()) return need;
    return {};
}

}  // namespace eikonal
