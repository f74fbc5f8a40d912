#include "kinds/integrator_kind.h"

#include "eikonal/portable.h"
#include "eikonal/scene.h"
#include "eikonal/stages.h"
#include "pack/cached_hits.h"
#include "pack/integrator.h"
#include "pack/light_paths.h"
#include "pack/light_vertices.h"
#include "read/pbrt/arguments.h"
#include "scene/integrator.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace eikonal {

using pbrt::Arguments;

bool samplesLights(const IntegratorDescription& d) { return !d.kind->samplesLights || d.kind->samplesLights(d); }
bool followsBsdfs(const IntegratorDescription& d) { return d.kind->followsBsdfs && d.kind->followsBsdfs(d); }

static bool always(const IntegratorDescription&) { return true; }
static bool never(const IntegratorDescription&) { return false; }

static void readRegularize(const Arguments& arguments, IntegratorDescription& d) { d.regularize = arguments.flag("regularize"); }

constexpr const char* pathParameters = "string lightsampler in {bvh, power, uniform, exhaustive}; bool regularize = false";
const IntegratorKind volpath_integrator{.name = "volpath",
                                        .parameters = pathParameters,
                                        .countsMedia = true,
                                        .followsBsdfs = always,
                                        .read = readRegularize};
const IntegratorKind path_integrator{
    .name = "path", .parameters = pathParameters, .followsBsdfs = always, .read = readRegularize};
const IntegratorKind direct_integrator{.name = "direct", .followsBsdfs = always, .mostDepth = 1};

/* ---- ray splitting --------------------------------------------------------------------------------------------------- */

static_assert(mostTreeRays == MOST_SPLIT_RAYS);

/// The most scattering events that fit in a ray's field `depth`, which also holds the branch number (kernels/math/dimension.clh).
constexpr int mostTreeDepth = 0xffff;

/// Throws SceneError unless the value is a power of two from 1 to mostTreeRays, or equal to `orElse`.
static int readTreeRays(const Arguments& arguments, const std::string& name, int orElse) {
    const int rays = arguments.integer(name);
    if (rays != orElse && (rays < 1 || rays > mostTreeRays || !std::has_single_bit(static_cast<unsigned>(rays))))
        throw SceneError(arguments.whereOf(name), fmt::format("\"integer {}\" is {}; it must be {}a power of two from 1 to {}", name, rays,
                                                              orElse == 0 ? "0 or " : "", mostTreeRays));
    return rays;
}
static void readWhitted(const Arguments& arguments, IntegratorDescription& d) {
    d.rays = readTreeRays(arguments, "rays", 1);
    d.bundle = readTreeRays(arguments, "bundle", 0);
    d.threshold = arguments.number("threshold");
}
static void packWhitted(const IntegratorPacking& in, const IntegratorDescription& d, const std::string& why) {
    in.context.require(Feature::RAY_SPLITTING, why);
    settings& frame = in.frame;
    frame.tree_splits = static_cast<uint>(std::countr_zero(static_cast<unsigned>(d.rays)));
    frame.rough_splits = d.bundle ? static_cast<uint>(std::countr_zero(static_cast<unsigned>(d.bundle))) : NONE;
    frame.tree_threshold = static_cast<float>(d.threshold);
}
const IntegratorKind whitted_integrator{.name = "whitted",
                                        .parameters = "integer rays = 16; integer bundle = 4; float threshold = 0.004 in [0, 1)",
                                        .splitsRays = true,
                                        .read = readWhitted,
                                        .pack = packWhitted,
                                        .mostDepth = mostTreeDepth};

/* ---- ambient occlusion ----------------------------------------------------------------------------------------------- */

static void readAmbientOcclusion(const Arguments& arguments, IntegratorDescription& d) {
    d.cosine = arguments.flag("cossample");
    if (arguments.has("maxdistance")) d.maxDistance = arguments.number("maxdistance");
    d.colorSpace = arguments.space();
}
static void packAmbientOcclusion(const IntegratorPacking& in, const IntegratorDescription& d, const std::string& why) {
    in.context.require(Feature::AMBIENT_OCCLUSION, why);
    settings& frame = in.frame;
    frame.ambient = in.colors.emission(Spectrum::rgb(glm::dvec3(1), d.colorSpace));
    frame.ambient_distance =
        d.maxDistance > 0 ? static_cast<float>(std::min(d.maxDistance * in.context.space.scale, double{FAR_AWAY})) : FAR_AWAY;
    frame.ambient_cosine = d.cosine;
}
const IntegratorKind ambientocclusion_integrator{.name = "ambientocclusion",
                                                 .parameters = "bool cossample = true; float maxdistance in (0, inf)",
                                                 .surfaceQueue = next_occlusion,
                                                 .read = readAmbientOcclusion,
                                                 .pack = packAmbientOcclusion,
                                                 .leastDepth = 1,
                                                 .mostDepth = 1};

/* ---- paths without multiple importance sampling ---------------------------------------------------------------------- */

static bool mayAimAtLights(const IntegratorDescription& d) { return d.sampleLights; }
static bool samplesBsdfs(const IntegratorDescription& d) { return d.sampleBsdf; }
static void readSimplePath(const Arguments& arguments, IntegratorDescription& d) {
    d.sampleLights = arguments.flag("samplelights");
    d.sampleBsdf = arguments.flag("samplebsdf");
}
static void packUniformDirections(const IntegratorPacking& in, const IntegratorDescription&, const std::string& why) {
    in.context.require(Feature::UNIFORM_DIRECTIONS, why);
}
static void packSimplePath(const IntegratorPacking& in, const IntegratorDescription& d, const std::string& why) {
    if (!d.sampleBsdf) packUniformDirections(in, d, why);
}
const IntegratorKind simplepath_integrator{.name = "simplepath",
                                           .parameters = "bool samplelights = true; bool samplebsdf = true",
                                           .samplesLights = mayAimAtLights,
                                           .followsBsdfs = samplesBsdfs,
                                           .read = readSimplePath,
                                           .pack = packSimplePath};
const IntegratorKind randomwalk_integrator{.name = "randomwalk", .samplesLights = never, .pack = packUniformDirections};

/* ---- paths from both ends -------------------------------------------------------------------------------------------- */

static void packLightPaths(const IntegratorPacking& in, const IntegratorDescription& d, const std::string& why) {
    const std::string obstacle = lightPathObstacle(in.context);
    if (obstacle.empty()) requireLightPaths(in.context, why);
    else
        in.context.diagnostics.warn(
            d.where, fmt::format("integrator \"{}\" traces no paths from lights here, since {}: the image is that of \"volpath\"",
                                 d.kind->name, obstacle));
}
/// Where light paths are traced, their hits are connected with those of paths from the camera.
static void packConnections(const IntegratorPacking& in, const IntegratorDescription& d, const std::string& why) {
    packLightPaths(in, d, why);
    if (in.context.has(Feature::LIGHT_PATHS)) requireConnections(in.context, in.frame, why);
}
const IntegratorKind bdpt_integrator{
    .name = "bdpt",
    .parameters = "bool visualizestrategies = false; bool visualizeweights = false; string lightsampler in {bvh, power, uniform, "
                  "exhaustive}; bool regularize = false",
    .countsMedia = true,
    .followsBsdfs = always,
    .read = readRegularize,
    .pack = packConnections};

static void readMerging(const Arguments& arguments, IntegratorDescription& d) {
    if (arguments.has("radius")) d.mergeRadius = arguments.number("radius");
}
static void packMerging(const IntegratorPacking& in, const IntegratorDescription& d, const std::string& why) {
    packLightPaths(in, d, why);
    if (in.context.has(Feature::LIGHT_PATHS)) requireMerging(in.context, in.frame, why);
}
static void packConnectionsAndMerging(const IntegratorPacking& in, const IntegratorDescription& d, const std::string& why) {
    packMerging(in, d, why);
    if (in.context.has(Feature::LIGHT_PATHS)) requireConnections(in.context, in.frame, why);
}
const IntegratorKind sppm_integrator{
    .name = "sppm",
    .parameters =
        "integer photonsperiteration = -1; float radius in (0, inf); integer seed = 0; string lightsampler in {bvh, power, uniform, "
        "exhaustive}",
    .countsMedia = true,
    .followsBsdfs = always,
    .read = readMerging,
    .pack = packMerging};
const IntegratorKind vcm_integrator{
    .name = "vcm",
    .parameters = "float radius in (0, inf); string lightsampler in {bvh, power, uniform, exhaustive}",
    .countsMedia = true,
    .followsBsdfs = always,
    .read = readMerging,
    .pack = packConnectionsAndMerging};

const IntegratorKind auto_integrator{.name = "auto",
                                     .parameters = pathParameters,
                                     .countsMedia = true,
                                     .mayTraceLightPaths = true,
                                     .followsBsdfs = always,
                                     .read = readRegularize};

std::span<const IntegratorKind* const> integratorKindList() {
    static const IntegratorKind* const kinds[] = {
        &volpath_integrator,          &path_integrator,       &direct_integrator,    &whitted_integrator,
        &ambientocclusion_integrator, &simplepath_integrator, &randomwalk_integrator, &bdpt_integrator,
        &sppm_integrator, &vcm_integrator, &auto_integrator};
    return kinds;
}

}  // namespace eikonal
