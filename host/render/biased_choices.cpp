#include "render/biased_choices.h"

#include "kinds/integrator_kind.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace eikonal {

std::vector<std::string> inexactFlags(const std::string& compilerFlags) {
    std::vector<std::string> found;
    for (const char* flag : {"-cl-fast-relaxed-math", "-cl-unsafe-math-optimizations"})
        if (compilerFlags.find(flag) != std::string::npos) found.emplace_back(flag);
    return found;
}

std::string partOfTransport(const Scene& scene) {
    const IntegratorKind& kind = *scene.integrator.kind;
    if (kind.surfaceQueue) return "ambient occlusion instead of light";
    if (kind.splitsRays) return "a tree of rays instead of paths";
    if (kind.mostDepth == 1) return "direct light only";
    return !kind.countsMedia && !scene.media.empty() ? "no participating media" : "";
}

std::vector<BiasedChoice> biasedChoices(const Scene& scene, const PackedScene& packed, double mergeRadius,
                                        const std::string& compilerFlags) {
    std::vector<BiasedChoice> choices;
    if (!packed.features.has(Feature::SPECTRAL)) {
        const bool isPredicted = scene.colorMode == ColorMode::automatic;
        choices.push_back({"RGB colour" + (isPredicted ? ", " + packed.color.why : ""), "--color=spectral"});
    }
    if (scene.integrator.regularize) choices.push_back({"regularised microfacets", "--regularize=off"});
    if (scene.forcesDiffuse) choices.push_back({"every surface diffuse", "no Option \"forcediffuse\""});
    if (scene.film.maxComponentValue > 0)
        choices.push_back({fmt::format("samples clamped at {:g}", scene.film.maxComponentValue), "--max-component-value=0"});
    if (scene.film.reweightsFireflies) choices.push_back({"fireflies re-weighted, into the layer fireflies", "--fireflies=keep"});
    if (packed.features.has(Feature::DIFFUSION)) choices.push_back({"subsurface scattering by diffusion", "--subsurface=randomwalk"});
    if (packed.features.has(Feature::MERGING)) {
        const double last = mergeRadius * std::pow(static_cast<double>(std::max(packed.samples, 1)), -0.125);
        choices.push_back({fmt::format("light paths merged within {:.3g}, and {:.3g} by sample {}: the bias vanishes as samples are added",
                                       mergeRadius, last, packed.samples),
                           "--integrator=bdpt"});
    }
    if (const std::string part = partOfTransport(scene); !part.empty()) choices.push_back({part, "--integrator=volpath"});
    for (const std::string& flag : inexactFlags(compilerFlags))
        choices.push_back({"compiler flag " + flag, "no --build-options, no --math-flags"});
    return choices;
}

std::string describe(const std::vector<BiasedChoice>& choices) {
    std::string text;
    for (const BiasedChoice& choice : choices) text = withChoice(text, choice);
    return text;
}

std::string withChoice(const std::string& described, const BiasedChoice& choice) {
    const std::string more = fmt::format("{} (without it: {})", choice.what, choice.remedy);
    if (described.find(more) != std::string::npos) return described;
    return described + (described.empty() ? "" : "; ") + more;
}

}  // namespace eikonal
