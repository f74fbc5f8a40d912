#include "bsdf_probe.h"

#include <fmt/format.h>

#include "measured_file.h"
#include "stage.h"

#include <unistd.h>

#include <algorithm>
#include <bit>
#include <filesystem>
#include <map>

namespace eikonal {

std::vector<BsdfKind> bsdfKinds() {
    std::vector<BsdfKind> kinds;
    const auto words = [](const std::string& type, size_t inRgb, bool spectral) {
        return type == "spectrum" && spectral ? size_t{CHANNELS_SPECTRAL} : inRgb;
    };
#define ADD_PARAMETER(q, type, name, FEATURE) kind.parameters.push_back({#type, #name, words(#type, WORDS_##type, spectral)});
#define ADD_KIND(bsdf, FEATURE, PARAMETERS)                                                             \
    {                                                                                                   \
        BsdfKind kind{#bsdf, spectral, {}};                                                             \
        PARAMETERS(ADD_PARAMETER, bsdf) if (hasKernelFile("bsdf/" #bsdf ".clh")) kinds.push_back(kind); \
    }
    for (bool spectral : {false, true}) { BSDFS(ADD_KIND) }
#undef ADD_KIND
#undef ADD_PARAMETER
    return kinds;
}

static float pick(Random& random, std::initializer_list<float> values) {
    return values.begin()[random.below(static_cast<uint>(values.size()))];
}

static float drawFloat(const BsdfParameter& p, Range range, Random& random) {
    const bool smooth = range == Range::smooth;
    const std::string& n = p.name;
    if (n == "eta" && p.type == "float")
        return smooth ? (random.below(2) ? random.between(1.1f, 2.5f) : 1 / random.between(1.1f, 2.5f))
                      : pick(random, {1.0f, 1.0001f, 0.9999f, 3.0f, 0.3f, 1.5f});
    if (n == "eta") return smooth ? random.between(0.1f, 4) : pick(random, {1e-3f, 0.05f, 1, 10});
    if (n == "k") return smooth ? random.between(0, 8) : pick(random, {0, 1e-3f, 1, 30});
    if (n.starts_with("alpha")) return smooth ? random.logBetween(0.15f, 1) : pick(random, {0, MIN_ALPHA, 0.01f, 0.3f, 1});
    if (n == "metallic" || n == "coat" || n == "sheen") return smooth ? random.unit() : pick(random, {0, 1});
    if (n == "coat_alpha" || n == "metal_alpha_x" || n == "metal_alpha_y")
        return smooth ? random.logBetween(0.15f, 1) : pick(random, {0, MIN_ALPHA, 0.01f, 0.3f, 1});
    if (n == "metal_eta") return smooth ? random.between(0.1f, 4) : pick(random, {1e-3f, 0.05f, 1, 10});
    if (n == "metal_k") return smooth ? random.between(0, 8) : pick(random, {0, 1e-3f, 1, 30});
    if (n == "sigma_a") return smooth ? random.between(0, 3) : pick(random, {0, 1e-3f, 30, 200});
    if (n == "h") return smooth ? random.between(-0.95f, 0.95f) : pick(random, {-1, 0, 0.5f, 1});
    if (n == "beta_m" || n == "beta_n") return smooth ? random.between(0.35f, 1) : pick(random, {0, 0.01f, 0.05f, 0.3f, 1});
    if (n == "scale_tilt") return smooth ? random.between(-3, 5) : pick(random, {-10, 0, 2, 30});
    if (n == "passing") return 1;
    if (n == "thickness") return smooth ? random.between(0.001f, 0.2f) : pick(random, {0, 1e-6f, 10});
    if (n == "g") return smooth ? random.between(-0.8f, 0.8f) : pick(random, {-0.99f, 0, 0.99f});
    return smooth ? random.unit() : pick(random, {0, 1});
}

/// Surfaces whose microfacets' lost energy is in tables, one for each, in this order: those of tests, and isotropic ones of tables.
struct CompensatedSurface { float alphaX, alphaY, eta; Range range; };
static const std::vector<CompensatedSurface>& compensatedSurfaces(const BsdfKind& kind) {
    using enum Range;
    static const auto withTables = [](std::vector<CompensatedSurface> surfaces, const std::vector<float>& indices) {
        for (float alpha : tableWidths)
            for (float eta : indices) surfaces.push_back({alpha, alpha, eta, alpha < 0.15f ? extreme : smooth});
        return surfaces;
    };
    static const std::vector<CompensatedSurface> metals = withTables({{.3f, .9f, 0, smooth}, {1, .25f, 0, smooth},
                                                                      {.0011f, .0011f, 0, extreme}, {1, .01f, 0, extreme},
                                                                      {4, 4, 0, extreme}}, {0}),
        glasses = withTables({{.4f, .8f, 1.2f, smooth}, {.9f, .3f, 2.2f, smooth}, {.5f, .5f, .5f, smooth}, {.0011f, .0011f, 1.5f, extreme},
                              {.01f, .01f, 1.0001f, extreme}, {1, 1, .9999f, extreme}, {.3f, .3f, 3, extreme}, {1, 1, .3f, extreme},
                              {1, .01f, 1.5f, extreme}}, tableIndices);
    return kind.name == "compensated_conductor" ? metals : glasses;
}
static bool isCompensated(const BsdfKind& kind) { return kind.parameters.front().name == "energy"; }

std::vector<uint> drawParameters(const BsdfKind& kind, Range range, Random& random) {
    std::vector<uint> words;
    uint compensated = 0;
    if (isCompensated(kind))
        do compensated = random.below(static_cast<uint>(compensatedSurfaces(kind).size()));
        while (compensatedSurfaces(kind)[compensated].range != range);
    float room = 1;   /* what reflectance leaves for transmittance */
    for (const BsdfParameter& p : kind.parameters)
        for (size_t w = 0; w < p.words; ++w) {
            if (p.name == "energy") {
                words.push_back(compensated);
                continue;
            }
            if (p.type == "uint") {
                words.push_back(p.name == "file" ? 0 : p.name == "samples" ? 1 : range == Range::smooth ? 10 : 1 + random.below(100));
                continue;
            }
            float value = drawFloat(p, range, random);
            if (isCompensated(kind)) {
                const CompensatedSurface& surface = compensatedSurfaces(kind)[compensated];
                if (p.name == "alpha_x") value = surface.alphaX;
                if (p.name == "alpha_y") value = surface.alphaY;
                if (p.name == "eta" && p.type == "float") value = surface.eta;
            }
            /* Total reflection from outside cuts the density off, which the tests' grids of directions do not resolve */
            if (kind.name == "subsurface_exit" && p.name == "eta" && range == Range::smooth) value = std::max(value, 1 / value);
            if (p.name == "transmittance") value *= room;
            else if (p.name == "reflectance") room = std::min(room, 1 - value);
            words.push_back(std::bit_cast<uint>(value));
        }
    return words;
}

std::vector<uint> parametersOf(const BsdfKind& kind, const std::function<float(const BsdfParameter&)>& valueOf) {
    std::vector<uint> words;
    const auto named = [&](const char* name) {
        for (const BsdfParameter& p : kind.parameters)
            if (p.name == name) return valueOf(p);
        return 0.0f;
    };
    for (const BsdfParameter& p : kind.parameters) {
        const float value = valueOf(p);
        uint word = p.type == "uint" ? static_cast<uint>(value) : std::bit_cast<uint>(value);
        if (p.name == "energy") {
            const auto& all = compensatedSurfaces(kind);
            const float eta = kind.name == "compensated_conductor" ? 0 : named("eta");
            const auto found = std::ranges::find_if(all, [&](const CompensatedSurface& s) {
                return s.alphaX == named("alpha_x") && s.alphaY == named("alpha_y") && s.eta == eta;
            });
            if (found == all.end()) throw std::runtime_error("no table of lost energy for these parameters");
            word = static_cast<uint>(found - all.begin());
        }
        words.insert(words.end(), p.words, word);
    }
    return words;
}

std::string describeParameters(const BsdfKind& kind, const std::vector<uint>& words) {
    std::string text = kind.name + "(";
    size_t at = 0;
    for (const BsdfParameter& p : kind.parameters)
        for (size_t w = 0; w < p.words; ++w, ++at)
            text += p.type == "uint" ? fmt::format(" {} {}", p.name, words[at])
                                     : fmt::format(" {} {}", p.name, std::bit_cast<float>(words[at]));
    return text + ")";
}

void BsdfInputs::add(const std::vector<uint>& b, vec3 w, vec3 elsewhere, Random& random) {
    parameters.words = b.size();
    parameters.data.insert(parameters.data.end(), b.begin(), b.end());
    wo.push_back(w);
    lobe.push_back(random.unit());
    u.push_back(random.square());
    given.push_back(elsewhere);
}

/// A scene with one measured surface: GGX facets that reflect 0.7 of the light, without a grain but measured as if there were one.
static PackedScene packMeasured(ColorMode color) {
    const std::filesystem::path file = std::filesystem::temp_directory_path() / ("eikonal-measured-" + std::to_string(getpid()) + ".bsdf");
    MeasuredFile measured;
    measured.isotropic = false;
    measured.reflectance = [](double) { return 0.7; };
    measured.write(file.string());
    PackedScene scene =
        packText("WorldBegin\nMaterial \"measured\" \"string filename\" \"" + file.string() + "\"\nShape \"sphere\"\n", color);
    std::filesystem::remove(file);
    return scene;
}
/// A scene with the tables of lost energy of a kind.
static PackedScene packCompensated(const BsdfKind& kind) {
    std::string text = "WorldBegin\n";
    for (const CompensatedSurface& s : compensatedSurfaces(kind)) {
        text += fmt::format("Material \"{}\" \"bool energycompensation\" true \"bool remaproughness\" false "
                            "\"float uroughness\" {} \"float vroughness\" {}",
                            s.eta > 0 ? "dielectric" : "conductor", s.alphaX, s.alphaY);
        if (s.eta > 0) text += fmt::format(" \"float eta\" {}", s.eta);
        text += "\nShape \"sphere\"\n";
    }
    return packText(text, kind.spectral ? ColorMode::spectral : ColorMode::rgb);
}
static PackedScene packTables(const BsdfKind& kind) {
    return isCompensated(kind) ? packCompensated(kind) : packMeasured(kind.spectral ? ColorMode::spectral : ColorMode::rgb);
}
/// One scene serves all probes of a kind, or of all kinds that are not compensated.
struct ProbedScene {
    explicit ProbedScene(const BsdfKind& kind) : packed(packTables(kind)), tables(testContext(), packed) {}
    PackedScene packed;
    DeviceScene tables;
};
static const ProbedScene& probedScene(const BsdfKind& kind) {
    static std::map<std::pair<std::string, bool>, ProbedScene> scenes;
    return scenes.try_emplace({isCompensated(kind) ? kind.name : "", kind.spectral}, kind).first->second;
}

static FunctionText probeText(const BsdfKind& kind) {
    const std::string& name = kind.name;
    FunctionText text;
    text.constants = probedScene(kind).packed.constants;
    text.features = (kind.spectral ? Features::allSpectral() : Features::all()).without(Feature::ENVIRONMENT_GUIDE);
    text.include = fmt::format("bsdf/{}.clh", name);
    text.type = "bsdf_result";
    text.inputs = {name + "_item parameters", "vec3 wo", "float lobe", "vec2 u", "vec3 given"};
    text.declarations = fmt::format(R"(
typedef struct {{
    vec3 wi; rgb weight; float pdf; int is_delta; float eta;
    rgb f, f_back; float pdf_here;
    rgb f_given; float pdf_given;
    int kind_is_delta, is_random, is_one_way;
    float split;
}} bsdf_result;
#if HAS_SPECTRAL
FN rgb three_of(spectrum s) {{ return make_rgb(s.r, s.g, s.x); }}
#else
FN rgb three_of(spectrum s) {{ return make_rgb(s.r, s.g, s.b); }}
#endif
#ifndef {0}_is_random
#define {0}_is_random 0
#endif
#ifndef {0}_is_one_way
#define {0}_is_one_way 0
#endif
#if !{0}_is_delta
FN float split_{0}({0}_bound b, vec3 wo) {{ return 0.0f; }}
#endif
)", name);
    text.tables = "BSDF_TABLES(TABLE) COLOR_TABLES(TABLE)";
    text.body = fmt::format(R"(
    bsdf_tables tables = BIND_BSDFS;
    color_tables colors = BIND_COLORS;
    {0}_bound b = bind_tables(parameters, tables, path_wavelengths(colors, 0, 0));
    bsdf_sample s = sample_{0}(b, wo, lobe, u);
    result.wi = s.wi; result.weight = three_of(s.weight); result.pdf = s.pdf; result.is_delta = s.is_delta; result.eta = s.eta;
    result.f = three_of(eval_{0}(b, wo, s.wi));
    result.f_back = three_of(eval_{0}(b, s.wi, wo));
    result.pdf_here = pdf_{0}(b, wo, s.wi);
    result.f_given = three_of(eval_{0}(b, wo, given));
    result.pdf_given = pdf_{0}(b, wo, given);
    result.kind_is_delta = {0}_is_delta;
    result.is_random = {0}_is_random;
    result.is_one_way = {0}_is_one_way;
    result.split = split_{0}(b, wo);)", name);
    return text;
}

std::vector<BsdfResult> BsdfProbe::operator()(const BsdfInputs& in) const {
    return function_.with(probedScene(kind_).tables, in.parameters, in.wo, in.lobe, in.u, in.given);
}

BsdfProbe::BsdfProbe(const BsdfKind& kind) : function_(probeText(kind)), kind_(kind) {}

}  // namespace eikonal
