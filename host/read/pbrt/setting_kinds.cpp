#include "read/pbrt/setting_kinds.h"

#include "scene/film.h"
#include "kinds/camera_kind.h"
#include "kinds/filter_kind.h"
#include "kinds/integrator_kind.h"

#include <algorithm>
#include <initializer_list>

namespace eikonal::pbrt {
namespace {

constexpr const char* screenParameters =
    "float frameaspectratio in (0, inf); floats screenwindow; float lensradius = 0 clamped to [0, inf); float focaldistance = 1e6; float "
    "shutteropen = 0; float shutterclose = 1";
constexpr const char* filmParameters =
    "integer xresolution = 1280; integer yresolution = 720; floats cropwindow; integers pixelbounds; string filename; float diagonal = 35 "
    "in (0, inf);"
    "string sensor = cie1931; float iso = 100 in (0, inf); float whitebalance = 0 in [0, inf); float maxcomponentvalue = 0 in (0, inf); "
    "bool savefp16 = true";
constexpr const char* samplerParameters = "integer seed; string randomization";
constexpr const char* instead = "\"volpath\" renders it";

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
            {"gbuffer", int(FilmKind::gbuffer), "string coordinatesystem = camera"},
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
    static const KindTable table("sampler", samplerParameters, {
        {"zsobol", int(SamplerKind::zsobol), "integer pixelsamples = 16"},
        {"paddedsobol", int(SamplerKind::paddedsobol), "integer pixelsamples = 16"},
        {"sobol", int(SamplerKind::sobol), "integer pixelsamples = 16"},
        {"halton", int(SamplerKind::sobol), "integer pixelsamples = 16"},
        {"pmj02bn", int(SamplerKind::zsobol), "integer pixelsamples = 16"},
        {"stratified", int(SamplerKind::sobol), "integer xsamples = 4; integer ysamples = 4; bool jitter = true"},
        {"independent", int(SamplerKind::independent), "integer pixelsamples = 4"},
    });
    return table;
}

/// The row of "volpath", for integrators that it stands for.
int volpathRow() {
    return static_cast<int>(std::ranges::find(integratorKindList(), &volpath_integrator) - integratorKindList().begin());
}

const KindTable& integratorKinds() {
    static const KindTable table = [] {
        std::vector<Row> rows;
        for (const IntegratorKind* kind : integratorKindList())
            rows.push_back({kind->name, static_cast<int>(rows.size()), kind->parameters});
        const int volpath = volpathRow();
        for (const Row& row : std::initializer_list<Row>{
                 {volpathAlias, volpath, ""},
                 {"lightpath", volpath, "", instead},
                 {"bdpt", volpath, "bool visualizestrategies = false; bool visualizeweights = false; bool regularize = false", instead},
                 {"mlt", volpath,
                  "integer bootstrapsamples = 100000; integer chains = 1000; integer mutationsperpixel = 100; float largestepprobability = "
                  "0.3; float sigma = 0.01; bool regularize = false",
                  instead},
                 {"sppm", volpath, "integer photonsperiteration = -1; float radius = 1; integer seed = 0", instead},
                 {"function", volpath, "string function = step; string filename; bool skipbad = true; string imagefilename", instead}})
            rows.push_back(row);
        return KindTable("integrator", "integer maxdepth = 5", rows);
    }();
    return table;
}

const KindTable& acceleratorKinds() {
    static const KindTable table(
        "accelerator", "",
        {
            {"bvh", 0, "string splitmethod = sah; integer maxnodeprims = 4"},
            {"kdtree", 0,
             "integer intersectcost = 5; integer traversalcost = 1; float emptybonus = 0.5; integer maxprims = 1; integer maxdepth = -1"},
        });
    return table;
}

}  // namespace

std::vector<const KindTable*> settingKinds() {
    return {&cameraKinds(), &filmKinds(), &filterKinds(), &samplerKinds(), &integratorKinds(), &acceleratorKinds()};
}

}  // namespace eikonal::pbrt
