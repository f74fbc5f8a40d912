#include "render/survey.h"

#include "kinds/light_kind.h"
#include "pack/alias_table.h"
#include "pack/environment_guide.h"

#include <algorithm>

namespace eikonal {
namespace {

/// If surfaces receive more than this share of an environment's light, BSDF sampling finds it well enough. If they receive none, there is
/// nothing to guide.
constexpr double openShare = 0.1;

Bindings withCount(size_t count) {
    Bindings own;
    own.set("count", static_cast<cl_uint>(count));
    for (const char* name : {"capacity", "path_capacity"}) own.set(name, 0u);
    return own;
}

void run(const Context& context, const DeviceScene& scene, const Stage& stage, const StageShape& shape, size_t items, const Bindings& own) {
    const Owned<cl_event, clReleaseEvent> launched(stage.kernel.launch(context, {&scene.bindings(), &own}, items, shape.group()));
}

}  // namespace

/// Makes the light sampler choose each constant environment as often as all other lights together.
static void sampleEnvironments(const Context& context, DeviceScene& scene, const PackedScene& packed) {
    Table<light> lights = packed.tables.lights;
    double lamps = 0;
    for (const light& l : lights) lamps += l.pmf;
    std::vector<double> weights;
    for (const light& l : lights) weights.push_back(kindOf(l).traits.isLeftToBsdfs ? (lamps > 0 ? lamps : 1) : l.pmf);
    const auto aliases = makeAliasTable(weights);
    for (size_t i = 0; i < lights.size(); ++i) lights[i].pmf = aliases[i].pmf;
    scene.replace(context, "lights", lights);
    scene.replace(context, "light_aliases", aliases);
}

void surveyEnvironment(const Context& context, DeviceScene& scene, const PackedScene& packed, const Stages& stages,
                       const StageShape& shape) {
    if (!packed.features.has(Feature::ENVIRONMENT_GUIDE)) return;
    const GuideBudget budget = GuideBudget::of(packed.frame().width, packed.frame().height, packed.samples);
    if (!budget.isEnough()) return;

    /* Find points that paths reach */
    std::vector<vec3> points(budget.paths * SURVEY_VERTICES), normals(budget.paths * SURVEY_VERTICES);
    const size_t bytes = points.size() * sizeof(vec3);
    const Buffer pointBuffer(context, bytes, "points of the survey"), normalBuffer(context, bytes, "normals of the survey");
    Bindings own = withCount(budget.paths);
    own.set("survey_points", pointBuffer);
    own.set("survey_normals", normalBuffer);
    run(context, scene, stages.find(StageName::survey_vertices), shape, budget.paths, own);
    pointBuffer.read(context, points.data(), bytes);
    normalBuffer.read(context, normals.data(), bytes);

    /* Find the parts of the environment that are visible from them */
    const auto weigh = [&](const GuideRepresentatives& from) {
        std::vector<float> weights(from.maps * GUIDE_SIDE * GUIDE_SIDE);
        const Buffer fromPoints = Buffer::of<vec3>(context, from.points, "points of the guide"),
                     fromNormals = Buffer::of<vec3>(context, from.normals, "normals of the guide"),
                     weightBuffer(context, weights.size() * sizeof(float), "weights of the guide");
        Bindings bound = withCount(weights.size());
        bound.set("survey_points", fromPoints);
        bound.set("survey_normals", fromNormals);
        bound.set("survey_weights", weightBuffer);
        bound.set("representatives", static_cast<cl_uint>(from.perMap));
        run(context, scene, stages.find(StageName::survey_environment), shape, weights.size(), bound);
        weightBuffer.read(context, weights.data(), weights.size() * sizeof(float));
        return weights;
    };
    SceneTables guide;
    const bool hasAllDirections = packed.features.has(Feature::MEDIA) || packed.features.has(Feature::TRANSMISSION);
    const double share = learnGuide(guide, points, normals, {budget.rays, hasAllDirections, packed.isAlwaysGuided ? 1 : openShare}, weigh);
    if (share == 0 || (share > openShare && !packed.isAlwaysGuided)) return;
    scene.replace(context, "guide_edges", guide.guide_edges);
    scene.replace(context, "guide_maps", guide.guide_maps);
    scene.replace(context, "guide_aliases", guide.guide_aliases);
    sampleEnvironments(context, scene, packed);
}

}  // namespace eikonal
