#include "read/pbrt/without_effect.h"

#include <algorithm>
#include <charconv>

namespace eikonal::pbrt {
namespace {

constexpr Answer silence = Answer::silence, warning = Answer::warning;

constexpr const char* ownHierarchy = "Eikonal has one kind of acceleration structure, built by the surface area heuristic";
constexpr const char* finestLevel = "images are interpolated bilinearly at their finest level, and the samples of a pixel average them";
constexpr const char* owenScrambling = "all Sobol' sequences are Owen-scrambled";
constexpr const char* ptexOnly = "only Ptex textures use them, each of which is named in a warning";

constexpr const char* noStrategyImages = "no images of single strategies are written";

constexpr WithoutEffect lines[] = {
    {"accelerator", nullptr, nullptr, nullptr, silence, ownHierarchy},
    {"film", nullptr, "diagonal", nullptr, silence, "only the film of the camera \"realistic\" has a size, and there it counts"},
    {"shape", "trianglemesh", "faceIndices", nullptr, silence, ptexOnly},
    {"shape", "bilinearmesh", "faceIndices", nullptr, silence, ptexOnly},
    {"shape", "bilinearmesh", "emissionfilename", nullptr, silence,
     "it guides light sampling, which is uniform over a patch, towards the same image; the file must exist"},
    {"texture", "imagemap", "filter", "trilinear", silence, finestLevel},
    {"texture", "imagemap", "filter", "ewa", silence, finestLevel},
    {"texture", "imagemap", "filter", "EWA", silence, finestLevel},
    {"texture", "imagemap", "maxanisotropy", nullptr, silence, finestLevel},
    {"integrator", nullptr, "lightsampler", "exhaustive", silence, "\"bvh\" chooses lights by the same bounds, with the same expectation"},
    {"integrator", "bdpt", "visualizestrategies", nullptr, warning, noStrategyImages},
    {"integrator", "bdpt", "visualizeweights", nullptr, warning, noStrategyImages},
    {"integrator", "sppm", "photonsperiteration", nullptr, warning, "there is one light path for each pixel and sample"},
    {"integrator", "sppm", "seed", nullptr, silence, "light paths have random numbers of their own, by the sampler's seed"},
    {"sampler", nullptr, "randomization", "owen", silence, owenScrambling},
    {"sampler", nullptr, "randomization", "fastowen", silence, owenScrambling},
    {"sampler", nullptr, "randomization", "permutedigits", warning, owenScrambling},
    {"sampler", nullptr, "randomization", "none", warning, owenScrambling},
    {"sampler", "stratified", "jitter", "false", warning,
     "a Sobol' sequence stands in for the strata, and is scrambled within them"},
    {"option", "disabletexturefiltering", nullptr, nullptr, silence, finestLevel},
    {"option", "rendercoordsys", nullptr, nullptr, silence, "Eikonal renders in a space of its own, fitted to the scene"},
    {"option", "wavefront", nullptr, nullptr, silence, "Eikonal is always a wavefront renderer"},
    {"option", "disablewavelengthjitter", nullptr, nullptr, warning, "spectral rendering always samples wavelengths"},
    {"option", "pixelstats", nullptr, nullptr, warning,
     "no such images are written; `--aov sampleCount,variance` shows where samples went"},
};

/// A number as the default of a row is: the parameter's only value; nothing if it has several.
bool equals(const Parameter& parameter, const std::string& text) {
    const auto isOnly = [](const auto& list, const auto& value) { return list.size() == 1 && list.front() == value; };
    if (const auto* flags = std::get_if<std::vector<bool>>(&parameter.values)) return isOnly(*flags, text == "true");
    if (const auto* words = std::get_if<std::vector<std::string>>(&parameter.values)) return isOnly(*words, text);
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) return false;
    if (const auto* integers = std::get_if<std::vector<int>>(&parameter.values)) return isOnly(*integers, number);
    if (const auto* numbers = std::get_if<std::vector<double>>(&parameter.values)) return isOnly(*numbers, number);
    return false;
}

bool isAbout(const WithoutEffect& line, const Kind& kind, const Parameter& parameter) {
    return kind.noun == line.noun && (!line.kind || kind.name == line.kind) && (!line.parameter || parameter.name == line.parameter) &&
           (!line.value || equals(parameter, line.value));
}

}  // namespace

std::span<const WithoutEffect> withoutEffect() { return lines; }

bool isDefault(const Rule& rule, const Parameter& parameter) { return !rule.fallback.empty() && equals(parameter, rule.fallback); }

const WithoutEffect* withoutEffect(const Kind& kind, const Parameter& parameter) {
    const Rule* rule = kind.ruleFor(parameter);
    if (!rule || isDefault(*rule, parameter)) return nullptr;
    const auto found = std::ranges::find_if(lines, [&](const WithoutEffect& line) { return isAbout(line, kind, parameter); });
    return found == std::end(lines) ? nullptr : found;
}

}  // namespace eikonal::pbrt
