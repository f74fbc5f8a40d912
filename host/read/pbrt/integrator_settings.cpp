// Fills in the scene's integrator from the parameters of an Integrator directive.

#include "read/pbrt/settings.h"

#include <fmt/format.h>

#include <bit>

namespace eikonal::pbrt {

void Settings::applyLightSampler(const Arguments& arguments) {
    const std::string name = arguments.text("lightsampler");
    LightSampler& sampler = reading_.scene.integrator.lightSampler;
    std::vector<std::string> words;
    for (const auto& [word, value] : lightSamplerNames) {
        words.emplace_back(word);
        if (name == word) { sampler = value; return; }
    }
    /* pbrt-v4's fourth light sampler; the light tree approximates it, with the same expectation */
    if (name == "exhaustive") { sampler = LightSampler::bvh; return; }
    const std::string near = nearestWord(name, words);
    throw SceneError(arguments.whereOf("lightsampler"), "there is no light sampler \"" + name + "\"; " +
                                                            (near.empty() ? "there are \"bvh\", \"power\" and \"uniform\"" : "did you mean \"" + near + "\"?"));
}

/// Throws SceneError unless the value is a power of two from 1 to mostTreeRays, or equal to `orElse`.
static int treeRays(const Arguments& arguments, const std::string& name, int orElse) {
    const int rays = arguments.integer(name);
    if (rays != orElse && (rays < 1 || rays > mostTreeRays || !std::has_single_bit(static_cast<unsigned>(rays))))
        throw SceneError(arguments.whereOf(name), fmt::format("\"integer {}\" is {}; it must be {}a power of two from 1 to {}", name, rays,
                                                              orElse == 0 ? "0 or " : "", mostTreeRays));
    return rays;
}

void Settings::applyIntegrator(const Arguments& arguments) {
    IntegratorDescription& integrator = reading_.scene.integrator;
    const Kind& kind = arguments.kind();
    integrator.where = arguments.where();
    integrator.kind = static_cast<IntegratorKind>(kind.value);
    if (kind.standIn) integrator.standsFor = kind.name;
    integrator.maxDepth = arguments.integer("maxdepth");
    if (integrator.maxDepth < 0) throw SceneError(arguments.whereOf("maxdepth"), "\"integer maxdepth\" must not be negative");
    if (kind.rule("lightsampler") && arguments.has("lightsampler")) applyLightSampler(arguments);
    if (kind.rule("regularize")) integrator.regularize = arguments.flag("regularize");
    if (integrator.kind == IntegratorKind::simplePath) {
        integrator.sampleLights = arguments.flag("samplelights");
        integrator.sampleBsdf = arguments.flag("samplebsdf");
    }
    if (integrator.kind == IntegratorKind::ambientOcclusion) {
        integrator.cosine = arguments.flag("cossample");
        if (arguments.has("maxdistance")) integrator.maxDistance = arguments.number("maxdistance");
        integrator.colorSpace = arguments.space();
    }
    if (integrator.kind == IntegratorKind::whitted) {
        integrator.rays = treeRays(arguments, "rays", 1);
        integrator.bundle = treeRays(arguments, "bundle", 0);
        integrator.threshold = arguments.number("threshold");
    }
}

}  // namespace eikonal::pbrt
