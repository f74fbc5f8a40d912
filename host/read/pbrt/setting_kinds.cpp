#include "read/pbrt/setting_kinds.h"

#include "scene/film.h"
#include "kinds/camera_kind.h"
#include "kinds/filter_kind.h"
#include "kinds/integrator_kind.h"

#include <algorithm>
#include <initializer_list>
#include <list>
#include <string>
#include <utility>

namespace eikonal::pbrt {
namespace {

constexpr const char* screenParameters =
    "float frameaspectratio in (0, inf); floats screenwindow; float lensradius = 0 clamped to [0, inf); float focaldistance = 1e6; float "
    "shutteropen = 0; float shutterclose = 1";
constexpr const char* filmParameters =
    "integer xresolution = 1280; integer yresolution = 720; floats cropwindow; integers pixelbounds; string filename; float diagonal = 35 "
    "in (0, inf);"
    "string sensor = cie1931; float iso = 100 in (0, inf); float whitebalance = 0 in [0, inf); float maxcomponentvalue = 0 in (0, inf); "
    "bool savefp16 = false";
constexpr const char *bdptInstead = "\"bdpt\" is used instead, which converges to the same image",
                     *vcmInstead = "\"vcm\" is used instead, which converges to the same image",
                     *volpathInstead = "\"volpath\" is used instead, which renders the scene, not the function";

const KindTable& cameraKinds() {
    static const KindTable table = [] {
        std::vector<Row> rows;
        for (const CameraKind& kind : cameraKindList()) rows.push_back({kind.name, kind.value, kind.traits.parameters});
        return KindTable("camera", screenParameters, rows);
    }();
    return table;
}

const KindTable& filmKinds() {
    static const KindTable table(
        "film", filmParameters,
        {
            {"rgb", int(FilmKind::rgb), ""},
            {"gbuffer", int(FilmKind::gbuffer), "string coordinatesystem = camera in {camera, world}"},
            {"spectral", int(FilmKind::spectral),
             "integer nbuckets = 16 in [1, 512]; float lambdamin = 360 in [360, 830]; float lambdamax = 830 in [360, 830]"},
        });
    return table;
}

const KindTable& filterKinds() {
    static const KindTable table = [] {
        std::vector<Row> rows;
        for (const FilterKind* kind : filterKindList()) rows.push_back({kind->name, static_cast<int>(rows.size()), kind->parameters});
        return KindTable("pixel filter", "", rows);
    }();
    return table;
}

const KindTable& samplerKinds() {
    constexpr const char* sobol = "integer pixelsamples = 16; string randomization = fastowen in {none, permutedigits, owen, fastowen}";
    static const KindTable table("sampler", "integer seed", {
        {"zsobol", int(SamplerKind::zsobol), sobol},
        {"paddedsobol", int(SamplerKind::paddedsobol), sobol},
        {"sobol", int(SamplerKind::sobol), sobol},
        {"halton", int(SamplerKind::sobol),
         "integer pixelsamples = 16; string randomization = permutedigits in {none, permutedigits, owen}"},
        {"pmj02bn", int(SamplerKind::zsobol), "integer pixelsamples = 16"},
        {"stratified", int(SamplerKind::sobol), "integer xsamples = 4; integer ysamples = 4; bool jitter = true"},
        {"independent", int(SamplerKind::independent), "integer pixelsamples = 4"},
    });
    return table;
}

/// The row of an integrator that stands for others.
int rowOf(const IntegratorKind& kind) {
    return static_cast<int>(std::ranges::find(integratorKindList(), &kind) - integratorKindList().begin());
}

const KindTable& integratorKinds() {
    static const KindTable table = [] {
        std::vector<Row> rows;
        std::list<std::string> texts;   // of each row
        const auto add = [&](const char* name, int value, const char* parameters, bool hasDepth, const char* standIn) {
            const std::string& text = texts.emplace_back(std::string(parameters) + (hasDepth ? "; integer maxdepth = 5 in [0, inf)" : ""));
            rows.push_back({name, value, text.c_str(), standIn});
        };
        for (const IntegratorKind* kind : integratorKindList())
            add(kind->name, static_cast<int>(rows.size()), kind->parameters, kind->leastDepth < kind->mostDepth, nullptr);
        add(volpathAlias, rowOf(volpath_integrator), "", true, nullptr);
        add("lightpath", rowOf(bdpt_integrator), "", true, bdptInstead);
        add("mlt", rowOf(vcm_integrator),
            "integer bootstrapsamples = 100000; integer chains = 1000; integer mutationsperpixel = 100; float largestepprobability = "
            "0.3; float sigma = 0.01; bool regularize = false",
            true, vcmInstead);
        add("function", rowOf(volpath_integrator), "string function = step; string filename; bool skipbad = true; string imagefilename",
            true, volpathInstead);
        return KindTable("integrator", "", rows);
    }();
    return table;
}

const KindTable& acceleratorKinds() {
    static const KindTable table(
        "accelerator", "",
        {
            {"bvh", 0, "string splitmethod = sah in {sah, middle, equal, hlbvh}; integer maxnodeprims = 4 in [1, inf)"},
            {"kdtree", 0,
             "integer intersectcost = 5; integer traversalcost = 1; float emptybonus = 0.5; integer maxprims = 1 in [1, inf);"
             "integer maxdepth = -1"},
        });
    return table;
}

}  // namespace

std::vector<const KindTable*> settingKinds() {
    return {&cameraKinds(), &filmKinds(), &filterKinds(), &samplerKinds(), &integratorKinds(), &acceleratorKinds()};
}

const KindTable& optionKinds() {
    static const KindTable table("option", "", {
        {"seed", 0, "integer seed = 0"},
        {"displacementedgescale", 0, "float displacementedgescale = 1 in (0, inf)"},
        {"disablepixeljitter", 0, "bool disablepixeljitter = false"},
        {"disablewavelengthjitter", 0, "bool disablewavelengthjitter = false"},
        {"disabletexturefiltering", 0, "bool disabletexturefiltering = false"},
        {"forcediffuse", 0, "bool forcediffuse = false"},
        {"msereferenceimage", 0, "file msereferenceimage"},
        {"msereferenceout", 0, "string msereferenceout"},
        {"pixelstats", 0, "bool pixelstats = false"},
        {"rendercoordsys", 0, "string rendercoordsys = cameraworld in {camera, cameraworld, world}"},
        {"wavefront", 0, "bool wavefront = false"},
    });
    return table;
}

}  // namespace eikonal::pbrt
