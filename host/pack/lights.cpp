// Lights without a shape; then the light sampler.

#include "pack/lights.h"

#include "kinds/integrator_kind.h"
#include "pack/alias_table.h"
#include "pack/environment_guide.h"
#include "pack/light_sampler.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string_view>

namespace eikonal {

/// The parameter that makes a light bright: its spectrum, or its "scale".
static std::string spectrumParameter(const LightKind& kind) {
    const std::string_view parameters = kind.traits.parameters, type = "spectrum ";
    const size_t at = parameters.find(type);
    if (at == std::string_view::npos) return "\"scale\"";
    const std::string_view name = parameters.substr(at + type.size());
    return fmt::format("\"{}\"", name.substr(0, name.find_first_of(" ;")));
}

void LightPacker::pack() {
    if (!context_.scene.integrator.kind->countsMaterials()) return;
    LightImages images;
    const LightPacking in{context_, tables_, colors_, images};
    size_t firstInfinite = 0;  // lights from this one on are infinitely far away
    for (const bool infinite : {false, true}) {
        firstInfinite = tables_.lights.size();
        for (const Light& description : context_.scene.lights)
            if (isInfinite(*description.kind) == infinite) add(in, description);
    }
    packLightSampler(context_, tables_, frame_, std::move(powers_), firstInfinite);
    packGuide();
}

bool LightPacker::isLeftToBsdfs(const LightKind& kind) const {
    return kind.traits.isLeftToBsdfs && followsBsdfs(context_.scene.integrator);
}

/// Whether the light sampler chooses it as a light that is infinitely far away.
bool LightPacker::isInfinite(const LightKind& kind) const {
    return (kind.place == LightPlace::DISTANT || kind.place == LightPlace::INFINITE) && !isLeftToBsdfs(kind);
}

/// light::group of a light of this group; empty: the default group.
uint LightPacker::groupNumber(const std::string& name) {
    if (name.empty()) return DEFAULT_GROUP;
    const auto found = std::ranges::find(groups_, name);
    if (found == groups_.end()) groups_.push_back(name);
    return static_cast<uint>(std::ranges::find(groups_, name) - groups_.begin());
}

void LightPacker::add(const LightPacking& in, const Light& description) {
    const LightKind& kind = *description.kind;
    PackedLight packed = kind.traits.pack(in, description);
    packed.l.group = groupNumber(description.group);
    colors_.checkRange(packed.l.L, description.where, spectrumParameter(kind) + " of a light");
    context_.require(kind.feature, description.where.toString());
    if (kind.place == LightPlace::INFINITE) tables_.environments.push_back(static_cast<uint>(tables_.lights.size()));
    tables_.lights.push_back(packed.l);
    powers_.push_back(isLeftToBsdfs(kind) ? 0 : packed.power);
    emitted_.push_back({kind.traits.startsPaths ? packed.power : 0, nullptr});
}

/// Points of a light, or around it, that have to be in one medium: scene space.
static std::vector<glm::dvec3> pointsAround(const light& l, bool isArea) {
    if (!isArea) return {toGlm(l.p)};
    const LightBounds bounds = boundsOfLight(l, 0);
    std::vector<glm::dvec3> points;
    for (unsigned i = 0; i < 8; ++i) points.push_back(bounds.box.corner(i));
    if (bounds.normals < std::numbers::pi) points.push_back(bounds.box.center());   // of a ball it is far from the surface
    return points;
}

/// The medium around a light: in Scene::media, or `none`. Nothing if it cannot be told, is not what the light's own shape says, or the
/// light may be inside a subsurface body.
std::optional<int> LightPacker::mediumAround(const LightMedia& media, const light& l, const Shape* shape) const {
    /* What shines inwards shines into the body */
    if (shape && l.two_sided && media.isBody(*shape)) return {};
    std::optional<int> found;
    for (const glm::dvec3& at : pointsAround(l, shape)) {
        const glm::dvec3 p = transformPoint(context_.space.worldFromScene(), at);
        const std::optional<int> here = context_.hasMedia ? media.at(p, shape) : none;
        if (!here || (found && *found != *here) || media.mayBeInBody(p)) return {};
        found = here;
    }
    /* It shines on the side of its normal, or on both */
    const bool disagrees = context_.hasMedia && shape && shape->interface && (l.two_sided || shape->interface->outside != *found);
    return disagrees ? std::nullopt : found;
}

/// Which medium is around each light. Where that cannot be told, or it may be a subsurface body, no light paths begin.
void LightPacker::placeInMedia() {
    if (!context_.hasMedia && !context_.has(Feature::SUBSURFACE)) return;
    const auto begin = [](const Emission& e) { return e.power > 0; };
    if (std::ranges::none_of(emitted_, begin)) return;
    const LightMedia media(context_.scene);
    /* Light paths from far away do not get through a medium without an end */
    const bool isLitFromFar = !context_.hasMedia || media.outside() == none;
    for (size_t i = 0; i < emitted_.size(); ++i) {
        Emission& e = emitted_[i];
        light& l = tables_.lights[i];
        const LightPlace place = kindOf(l).place;
        if (place == LightPlace::DISTANT || place == LightPlace::INFINITE) {
            if (!isLitFromFar) e.power = 0;
            continue;
        }
        const std::optional<int> found = mediumAround(media, l, e.shape);
        if (!found) e.power = 0;
        l.medium = static_cast<uint>(found.value_or(none));   // none is NONE
    }
    if (std::ranges::none_of(emitted_, begin))
        context_.diagnostics.warn({}, "no paths begin at the lights of this scene, since it cannot be told which media they are in, they "
                                      "are in subsurface bodies, or they shine through a medium without an end; add --integrator volpath");
}

/// By power; and how splats are scaled.
void LightPacker::packEmission() {
    if (!context_.has(Feature::LIGHT_PATHS) || emitted_.empty()) return;
    placeInMedia();
    std::vector<double> powers;
    for (const Emission& e : emitted_) powers.push_back(std::max(e.power, 0.0));
    const double total = std::accumulate(powers.begin(), powers.end(), 0.0);
    raiseToLeastPower(powers);
    tables_.emission_aliases = makeAliasTable(powers);
    frame_.emission_count = total > 0 ? static_cast<uint>(powers.size()) : 0;
    const double radius = context_.whole.empty() ? 1 : 1.001 * context_.whole.radius() * context_.space.scale;
    const glm::dvec3 center = context_.whole.empty()
                                  ? glm::dvec3(0)
                                  : transformPoint(context_.space.sceneFromWorld(), (context_.whole.low + context_.whole.high) * 0.5);
    for (size_t i = 0; i < emitted_.size(); ++i) {
        light& l = tables_.lights[i];
        l.emission_pmf = total > 0 ? tables_.emission_aliases[i].pmf : 0;
        const LightPlace place = kindOf(l).place;
        if ((place != LightPlace::DISTANT && place != LightPlace::INFINITE) || !kindOf(l).traits.startsPaths) continue;
        l.p = toVec3(center);
        l.radius = static_cast<float>(radius);
    }
    /* A splat is a light's power times the density of camera rays, a BSDF and the inverse of a squared distance in scene space, where all
       are of the order of one */
    const camera& view = frame_.view;
    const double image = double{view.step_x} * double{view.step_y} * frame_.width * frame_.height,
                 typical = total / std::max(std::abs(image), 1e-30);
    frame_.splat_scale = total > 0 ? static_cast<float>(std::exp2(std::clamp(-std::round(std::log2(typical)), -100., 100.))) : 1.0f;
}

/// Prepares an environment guide, if it may pay.
void LightPacker::packGuide() {
    const IntegratorDescription& integrator = context_.scene.integrator;
    const auto isGuided = [](const light& l) { return kindOf(l).traits.isLeftToBsdfs; };
    if (!followsBsdfs(integrator) || !samplesLights(integrator) || context_.has(Feature::LIGHT_TREE) ||
        std::ranges::none_of(tables_.lights, isGuided))
        return;
    if (integrator.environmentGuide == EnvironmentGuide::never) return;
    if (!GuideBudget::of(frame_.width, frame_.height, context_.scene.sampler.pixelSamples).isEnough()) return;
    context_.require(Feature::ENVIRONMENT_GUIDE,
                     "a uniform infinite light, and enough samples to learn where it is visible");
    context_.require(Feature::LIGHTS, "the same");
    packUnlearnedGuide(tables_);
    if (tables_.light_aliases.empty()) tables_.light_aliases = makeAliasTable(std::vector<double>(tables_.lights.size(), 0.0));
}

}  // namespace eikonal
