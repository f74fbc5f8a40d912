#include "bsdf_probe.h"

#include <fmt/format.h>

#include "measured_file.h"
#include "stage.h"

#include <unistd.h>

#include <bit>
#include <filesystem>

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

std::vector<uint> drawParameters(const BsdfKind& kind, Range range, Random& random) {
    std::vector<uint> words;
    float room = 1;   /* what reflectance leaves for transmittance */
    for (const BsdfParameter& p : kind.parameters)
        for (size_t w = 0; w < p.words; ++w) {
            if (p.type == "uint") {
                words.push_back(p.name == "file" ? 0 : p.name == "samples" ? 1 : range == Range::smooth ? 10 : 1 + random.below(100));
                continue;
            }
            float value = drawFloat(p, range, random);
            /* Total reflection from outside cuts the density off, which the tests' grids of directions do not resolve */
            if (kind.name == "subsurface_exit" && p.name == "eta" && range == Range::smooth) value = std::max(value, 1 / value);
            if (p.name == "transmittance") value *= room;
            else if (p.name == "reflectance") room = std::min(room, 1 - value);
            words.push_back(std::bit_cast<uint>(value));
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
static const PackedScene& measuredScene(bool spectral) {
    static const PackedScene inRgb = packMeasured(ColorMode::rgb), atWavelengths = packMeasured(ColorMode::spectral);
    return spectral ? atWavelengths : inRgb;
}
static const DeviceScene& measuredTables(bool spectral) {
    static const DeviceScene inRgb(testContext(), measuredScene(false)), atWavelengths(testContext(), measuredScene(true));
    return spectral ? atWavelengths : inRgb;
}

static FunctionText probeText(const BsdfKind& kind) {
    const std::string& name = kind.name;
    FunctionText text;
    text.constants = measuredScene(kind.spectral).constants;
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
    return function_.with(measuredTables(spectral_), in.parameters, in.wo, in.lobe, in.u, in.given);
}

BsdfProbe::BsdfProbe(const BsdfKind& kind) : function_(probeText(kind)), spectral_(kind.spectral) {}

}  // namespace eikonal
