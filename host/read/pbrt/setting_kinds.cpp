#include "read/pbrt/setting_kinds.h"

#include "kinds/camera_kind.h"
#include "scene/scene.h"

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
    static const KindTable table(
        "pixel filter", "",
        {
            {"box", int(FilterKind::box), "float xradius = 0.5 in (0, inf); float yradius = 0.5 in (0, inf)"},
            {"triangle", int(FilterKind::triangle), "float xradius = 2 in (0, inf); float yradius = 2 in (0, inf)"},
            {"gaussian", int(FilterKind::gaussian),
             "float xradius = 1.5 in (0, inf); float yradius = 1.5 in (0, inf); float sigma = 0.5 in (0, inf)"},
            {"mitchell", int(FilterKind::mitchell), "float xradius = 2 in (0, inf); float yradius = 2 in (0, inf); float B; float C"},
            {"sinc", int(FilterKind::sinc), "float xradius = 4 in (0, inf); float yradius = 4 in (0, inf); float tau = 3 in (0, inf)"},
        });
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

const KindTable& integratorKinds() {
    static const KindTable table(
        "integrator", "integer maxdepth = 5",
        {
            {"path", int(IntegratorKind::path), "string lightsampler; bool regularize = false"},
            {"volpath", int(IntegratorKind::volpath), "string lightsampler; bool regularize = false"},
            {"simplepath", int(IntegratorKind::simplePath), "bool samplelights = true; bool samplebsdf = true"},
            {"simplevolpath", int(IntegratorKind::volpath), ""},
            {"randomwalk", int(IntegratorKind::randomWalk), ""},
            {"ambientocclusion", int(IntegratorKind::ambientOcclusion), "bool cossample = true; float maxdistance in (0, inf)"},
            {"direct", int(IntegratorKind::direct), ""},
            {"whitted", int(IntegratorKind::whitted), "integer rays = 16; integer bundle = 4; float threshold = 0.004 in [0, 1)"},
            {"lightpath", int(IntegratorKind::volpath), "", instead},
            {"bdpt", int(IntegratorKind::volpath),
             "bool visualizestrategies = false; bool visualizeweights = false; bool regularize = false", instead},
            {"mlt", int(IntegratorKind::volpath),
             "integer bootstrapsamples = 100000; integer chains = 1000; integer mutationsperpixel = 100; float largestepprobability = 0.3;"
             "float sigma = 0.01; bool regularize = false",
             instead},
            {"sppm", int(IntegratorKind::volpath), "integer photonsperiteration = -1; float radius = 1; integer seed = 0", instead},
            {"function", int(IntegratorKind::volpath), "string function = step; string filename; bool skipbad = true; string imagefilename",
             instead},
        });
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
