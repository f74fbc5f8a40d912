#include "pack/color_mode.h"

#include "error.h"
#include "kinds/integrator_kind.h"
#include "kinds/material_kind.h"
#include "kinds/medium_kind.h"
#include "pack/rgb_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace eikonal {
namespace {

bool isMeasured(const Spectrum& s) { return s.kind() != Spectrum::Kind::rgb; }

bool isMeasured(const Light& light) { return isMeasured(light.spectrum); }

bool isIndexOfMetal(const Material& m, const std::string& name) {
    const auto& indices = m.kind->metalIndices;
    return indices[0] && (name == indices[0] || name == indices[1]);
}

bool isMeasured(const Medium& m) {
    const bool isBlackbody = m.emissionScale > 0 && emissionOf(m) == MediumEmission::blackbody;
    return isMeasured(m.sigmaA) || isMeasured(m.sigmaS) || isMeasured(m.Le) || isBlackbody;
}

/// Whether inputs are given as spectra, directly or in their textures. Visits each texture once.
class MeasuredInputs {
public:
    explicit MeasuredInputs(const Scene& scene) : scene_(scene), known_(scene.textures.size()) {}

    bool has(const Input& input) {
        if (input.texture == none) return isMeasured(input.value);
        std::optional<bool>& known = known_[static_cast<size_t>(input.texture)];
        if (!known)
            known =
                std::ranges::any_of(scene_.textures[static_cast<size_t>(input.texture)].operands, [&](const Input& i) { return has(i); });
        return *known;
    }

private:
    const Scene& scene_;
    std::vector<std::optional<bool>> known_;  ///< of each texture
};

/// Except a metal's eta and k, which RGB rendering replaces with indices that reflect alike (color/spectrum.h).
bool isMeasured(MeasuredInputs& inputs, const Material& m) {
    for (const auto& [name, input] : m.inputs)
        if (!isIndexOfMetal(m, name) && inputs.has(input)) return true;
    const auto isMeasuredBody = [&](const DiffusionProfile& body) {
        return inputs.has({body.albedo, body.albedoTexture}) || inputs.has({body.length, body.pathTexture});
    };
    return (m.interior && isMeasured(*m.interior)) || (m.diffusion && m.diffusion->isTextured() && isMeasuredBody(*m.diffusion));
}

bool isMeasured(const AreaLight& light) { return isMeasured(light.L); }

/// Of those that are enough by themselves.
template <class Thing>
bool isMeasured(MeasuredInputs&, const Thing& thing) {
    return isMeasured(thing);
}

/// The first of a list that is given as a spectrum, in words.
template <class Thing>
std::string firstMeasured(MeasuredInputs& inputs, const std::vector<Thing>& things, const char* what) {
    for (const Thing& thing : things)
        if (isMeasured(inputs, thing)) return thing.where.toString() + ": " + what + " given as a spectrum";
    return {};
}

std::string percent(double error) { return error > 0.994 ? "100 % or more" : fmt::format("{:.2g} %", 100 * error); }

}  // namespace

std::string needOfWavelengths(const Scene& scene) {
    if (scene.film.spectrum) return scene.film.where.toString() + ": film \"spectral\"";
    if (scene.film.sensor != "cie1931") return scene.film.where.toString() + ": sensor \"" + scene.film.sensor + "\"";
    MeasuredInputs inputs(scene);
    for (const std::string& need :
         {firstMeasured(inputs, scene.materials, "a material"), firstMeasured(inputs, scene.lights, "a light"),
          firstMeasured(inputs, scene.areaLights, "an area light"), firstMeasured(inputs, scene.media, "a medium")})
        if (!need.empty()) return need;
    return {};
}

ColorChoice chooseColor(const Scene& scene, const std::vector<std::shared_ptr<const ImageData>>& images, const Box& near) {
    if (scene.colorMode == ColorMode::spectral || (scene.colorMode == ColorMode::rgb && !scene.film.spectrum))
        return {scene.colorMode == ColorMode::spectral, "--color"};
    if (scene.colorMode == ColorMode::rgb)
        throw SceneError(scene.film.where,
                         "film \"spectral\" stores spectra, which --color rgb does not compute; use --color spectral or --color auto");
    if (std::string need = needOfWavelengths(scene); !need.empty()) return {true, std::move(need)};
    if (!scene.integrator.kind->countsMaterials()) return {false, "the integrator does not look at colours"};
    const RgbError error = predictRgbError(scene, images, near);
    if (error.worst >= mostRgbError.inPart)
        return {true, fmt::format("{}: in RGB a channel could be off by up to {} (a bound that ignores visibility)", error.cause,
                                  percent(error.worst))};
    if (error.mean >= mostRgbError.inMean)
        return {true, fmt::format("in RGB the mean of the image would be off by {}", percent(error.mean))};
    return {false, fmt::format("predicted to be off by {} in the mean of the image, and by at most {} in a part of it", percent(error.mean),
                               percent(error.worst))};
}

}  // namespace eikonal
