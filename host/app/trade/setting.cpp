#include "app/trade/setting.h"

#include "kinds/integrator_kind.h"
#include "render/session.h"

#include <fmt/format.h>

#include <algorithm>

namespace eikonal {
namespace {

/// Collects the values of one knob.
class Knob {
public:
    Knob(std::vector<Setting>& settings, std::string name) : settings_(settings), name_(std::move(name)) {}
    Setting& add(const std::string& value, std::vector<std::string> options, bool addsBias = false) {
        settings_.push_back({name_, value, std::move(options), addsBias, addsBias, Ladder::samples, false});
        return settings_.back();
    }

private:
    std::vector<Setting>& settings_;
    std::string name_;
};

/// Whether paths are followed through the scene's BSDFs.
bool tracesPaths(const Scene& scene) { return followsBsdfs(scene.integrator); }

void addDepths(std::vector<Setting>& settings, int depth) {
    Knob knob(settings, "depth");
    for (int d : {1, 2, 3, 5, 8, 13, 21, 34})
        if (d < depth) knob.add(fmt::format("{}", d), {fmt::format("--max-depth={}", d)}, true);
    if (depth > 0 && depth <= 64) knob.add(fmt::format("{}", 2 * depth), {fmt::format("--max-depth={}", 2 * depth)}, true);
}

/// The integrators that follow light, beside the user's own; those that merge are biased until their radius vanishes. `follower`: as of
/// followerOf.
void addLightPaths(Knob& knob, const Session& session, const IntegratorKind* follower) {
    const auto add = [&](const IntegratorKind& kind, bool addsBias) { knob.add(kind.name, {integratorOption(kind)}, addsBias); };
    if (session.packed().features.has(Feature::LIGHT_PATHS)) add(volpath_integrator, true);
    for (const IntegratorKind* kind : {&bdpt_integrator, &vcm_integrator, &sppm_integrator})
        if (session.scene().integrator.kind != kind) add(*kind, kind != &bdpt_integrator || kind != follower);
}

void addIntegrators(std::vector<Setting>& settings, const Session& session, const IntegratorKind* follower) {
    const IntegratorKind* own = session.scene().integrator.kind;
    Knob knob(settings, "integrator");
    if (follower) addLightPaths(knob, session, follower);
    const bool hasMedia = session.packed().features.has(Feature::MEDIA);
    if (hasMedia) knob.add("path", {"--integrator=path"}, true);
    if (own->mostDepth > 1) knob.add("direct", {"--integrator=direct"}, true);
    for (const char* threshold : {"0.004", "0.064"})
        for (const char* bundle : {"0", "4"})
            knob.add(fmt::format("whitted, threshold {}, bundle {}", threshold, bundle),
                     {"--integrator=whitted", fmt::format("--threshold={}", threshold), fmt::format("--bundle={}", bundle)}, true);
}

void addGuiding(std::vector<Setting>& settings, const Session& session) {
    const bool canBeGuided = session.packed().frame().max_depth > 1 && !session.packed().features.has(Feature::LIGHT_PATHS);
    if (canBeGuided && !session.packed().features.has(Feature::PATH_GUIDE)) Knob(settings, "path guiding").add("on", {"--guiding=on"});
}

void addRoulette(std::vector<Setting>& settings) {
    Knob knob(settings, "Russian roulette");
    knob.add("root from the 5th surface", {"--roulette=root", "--roulette-depth=4"});
    knob.add("throughput from the 2nd, as pbrt-v4", {"--roulette=throughput", "--roulette-depth=1"});
    knob.add("late", {"--roulette=root", "--roulette-depth=12"});
}

void addBiasedNoiseReduction(std::vector<Setting>& settings, double brightness) {
    Knob(settings, "regularisation").add("on", {"--regularize=on"}, true);
    Knob(settings, "fireflies").add("reweight", {"--fireflies=reweight"}, true);
    Knob clamping(settings, "clamping");
    for (int factor : {4, 16, 64, 256})
        clamping.add(fmt::format("at {} x the mean", factor), {fmt::format("--max-component-value={:.2g}", factor * brightness)}, true);
}

void addCompilerFlags(std::vector<Setting>& settings, const Stages& stages) {
    Knob knob(settings, "compiler flags");
    for (const char* flag : {"-cl-mad-enable", "-cl-denorms-are-zero", "-cl-unsafe-math-optimizations", "-cl-fast-relaxed-math"}) {
        knob.add(flag, {fmt::format("--math-flags={} {}", shippedMathFlags, flag)}, true).compiles = true;
        for (const Stage& stage : stages.all())
            knob.add(fmt::format("{} in {}", flag, stage.name), {fmt::format("--math-flags={}:{} {}", stage.name, shippedMathFlags, flag)},
                     true)
                .compiles = true;
    }
}

}  // namespace

std::vector<Setting> settingsFor(const Session& session, double brightness, bool withCompilerFlags,
                                 const IntegratorKind* follower) {
    const Scene& scene = session.scene();
    const PackedScene& packed = session.packed();
    std::vector<Setting> settings{{"as given", "", {}, false, false, Ladder::samples, false}};
    const bool paths = tracesPaths(scene);
    if (paths) addDepths(settings, scene.integrator.maxDepth);
    addIntegrators(settings, session, follower);
    if (paths) addGuiding(settings, session);
    if (paths) addRoulette(settings);
    Knob color(settings, "colour");
    if (packed.features.has(Feature::SPECTRAL)) color.add("rgb", {"--color=rgb"}, true);
    else color.add("wavelengths", {"--color=spectral"});
    if (packed.features.has(Feature::SUBSURFACE)) {
        Knob subsurface(settings, "subsurface");
        for (const auto& [name, method] : subsurfaceMethodNames)
            subsurface.add(name, {fmt::format("--subsurface={}", name)}, method == SubsurfaceMethod::diffusion);
    }
    Knob lights(settings, "light sampler");
    if (packed.counts.lights > 1 && samplesLights(scene.integrator))
        for (const auto& [name, kind] : lightSamplerNames)
            if (kind != scene.integrator.lightSampler) lights.add(name, {fmt::format("--light-sampler={}", name)});
    Knob guide(settings, "environment guide");
    if (packed.features.has(Feature::ENVIRONMENT_GUIDE))
        for (const char* when : {"always", "never"}) guide.add(when, {fmt::format("--environment-guide={}", when)});
    Knob sampler(settings, "sampler");
    for (const auto& [name, kind] : samplerNames)
        if (kind != scene.sampler.kind) sampler.add(name, {fmt::format("--sampler={}", name)});
    Knob(settings, "adaptive sampling").add("on", {}).ladder = Ladder::targetErrors;
    addBiasedNoiseReduction(settings, brightness);
    const std::vector<std::string> causes = referenceOptions(session, follower);
    if (causes.size() > 1) settings.push_back({"unbiased", "", causes, false, false, Ladder::samples, false});
    if (withCompilerFlags) addCompilerFlags(settings, session.stages());
    const bool merges = packed.features.has(Feature::MERGING);
    for (Setting& s : settings) {
        s.isBiased |= std::ranges::any_of(causes, [&](const std::string& c) { return std::ranges::find(s.options, c) == s.options.end(); });
        s.isBiased |= merges && std::ranges::none_of(s.options, [](const std::string& o) { return o.starts_with("--integrator="); });
    }
    return settings;
}

std::vector<std::string> referenceOptions(const Session& session, const IntegratorKind* follower) {
    std::vector<std::string> options;
    for (const BiasedChoice& c : session.biasedChoices())
        if (c.remedy.starts_with("--") && !c.remedy.starts_with("--integrator")) options.push_back(c.remedy);
    if (follower && follower != session.scene().integrator.kind) options.push_back(integratorOption(*follower));
    return options;
}

std::string integratorOption(const IntegratorKind& kind) { return fmt::format("--integrator={}", kind.name); }

std::vector<std::string> overridden(const std::vector<std::string>& base, const std::vector<std::string>& more) {
    const auto name = [](const std::string& option) { return option.substr(0, option.find('=')); };
    std::vector<std::string> all;
    for (const std::string& option : base)
        if (std::ranges::none_of(more, [&](const std::string& m) { return name(m) == name(option); })) all.push_back(option);
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

}  // namespace eikonal
