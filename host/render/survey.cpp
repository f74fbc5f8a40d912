#include "render/survey.h"

#include "kinds/light_kind.h"
#include "pack/alias_table.h"
#include "pack/environment_guide.h"

#include <algorithm>

namespace eikonal {
namespace {

/// If surfaces receive more than this share of an environment's light, BSDF sampling finds it well enough. If they receive none, there is
/// nothing to guide.
constexpr double openShare = 0.35;

Bindings withCount(size_t count) {
    Bindings own;
    own.set("count", static_cast<cl_uint>(count));
    for (const char* name : {"capacity", "path_capacity"}) own.set(name, 0u);
    return own;
}

void run(const Context& context, const DeviceScene& scene, const Stage& stage, const StageShape& shape, size_t items, const Bindings& own) {
    const Owned<cl_event, clReleaseEvent> launched(stage.kernel.launch(context, {&scene.bindings(), &own}, items, shape.group()));
}

/// SURVEY_VERTICES points for each path, with normals; a normal of zero length: the path did not get so far.
SurfacePoints findVertices(const Context& context, const DeviceScene& scene, const Stages& stages, const StageShape& shape, size_t paths) {
    SurfacePoints found{std::vector<vec3>(paths * SURVEY_VERTICES), std::vector<vec3>(paths * SURVEY_VERTICES)};
    const size_t bytes = found.points.size() * sizeof(vec3);
    const Buffer points(context, bytes, "points of the survey"), normals(context, bytes, "normals of the survey");
    Bindings own = withCount(paths);
    own.set("survey_points", points);
    own.set("survey_normals", normals);
    run(context, scene, stages.find(StageName::survey_vertices), shape, paths, own);
    points.read(context, found.points.data(), bytes);
    normals.read(context, found.normals.data(), bytes);
    return found;
}

/// Every `step`-th of these, from the first on, if a path got there.
SurfacePoints keepFound(const SurfacePoints& all, size_t step) {
    SurfacePoints kept;
    for (size_t i = 0; i < all.points.size(); i += step) {
        const vec3& n = all.normals[i];
        if (n.x == 0 && n.y == 0 && n.z == 0) continue;
        kept.points.push_back(all.points[i]);
        kept.normals.push_back(n);
    }
    return kept;
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

    const auto [points, normals] = keepFound(findVertices(context, scene, stages, shape, budget.paths), 1);
    if (points.empty()) return;

    /* Find the openings that light enters by, and what is visible through them */
    const Buffer allPoints = Buffer::of<vec3>(context, points, "points of the survey"),
                 allNormals = Buffer::of<vec3>(context, normals, "normals of the survey");
    const auto exits = [&](const LightTables& tables, size_t rays) {
        scene.replace(context, "guide_box", tables.guide_box);
        std::vector<uint> texels(rays);
        const Buffer texelBuffer(context, rays * sizeof(uint), "exits of the survey");
        Bindings bound = withCount(rays);
        bound.set("survey_points", allPoints);
        bound.set("survey_normals", allNormals);
        bound.set("point_count", static_cast<cl_uint>(points.size()));
        bound.set("survey_texels", texelBuffer);
        run(context, scene, stages.find(StageName::survey_exits), shape, rays, bound);
        texelBuffer.read(context, texels.data(), rays * sizeof(uint));
        return texels;
    };
    const auto weigh = [&](const LightTables& tables, const GuideRepresentatives& from) {
        scene.replace(context, "guide_openings", tables.guide_openings);
        const size_t entries = from.maps * GUIDE_OPENINGS;
        std::vector<float> weights(2 * entries);
        const Buffer fromPoints = Buffer::of<vec3>(context, from.points, "points of the guide"),
                     fromNormals = Buffer::of<vec3>(context, from.normals, "normals of the guide"),
                     weightBuffer(context, weights.size() * sizeof(float), "weights of the guide");
        Bindings bound = withCount(entries);
        bound.set("survey_points", fromPoints);
        bound.set("survey_normals", fromNormals);
        bound.set("survey_weights", weightBuffer);
        bound.set("representatives", static_cast<cl_uint>(from.perMap));
        run(context, scene, stages.find(StageName::survey_environment), shape, entries, bound);
        weightBuffer.read(context, weights.data(), weights.size() * sizeof(float));
        return weights;
    };
    SceneTables guide;
    const bool hasAllDirections = packed.features.has(Feature::MEDIA) || packed.features.has(Feature::TRANSMISSION);
    const double share = learnGuide(guide, points, normals, {budget.rays, hasAllDirections, packed.isAlwaysGuided ? 1 : openShare},
                                    {exits, weigh});
    if (share == 0 || (share > openShare && !packed.isAlwaysGuided)) return;
    scene.replace(context, "guide_edges", guide.guide_edges);
    scene.replace(context, "guide_maps", guide.guide_maps);
    scene.replace(context, "guide_sums", guide.guide_sums);
    scene.replace(context, "guide_texels", guide.guide_texels);
    sampleEnvironments(context, scene, packed);
}

SurfacePoints surveyView(const Context& context, const DeviceScene& scene, const Stages& stages, const StageShape& shape, size_t paths) {
    return keepFound(findVertices(context, scene, stages, shape, paths), SURVEY_VERTICES);
}

}  // namespace eikonal
