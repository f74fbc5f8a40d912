#include "pack/pack.h"

#include "bvh/build.h"
#include "kinds/integrator_kind.h"
#include "pack/cached_hits.h"
#include "pack/camera.h"
#include "pack/color_mode.h"
#include "pack/geometry.h"
#include "pack/integrator.h"
#include "pack/light_paths.h"
#include "pack/missed_light.h"
#include "pack/nested_bodies.h"
#include "pack/sampler.h"
#include "pack/scene_bounds.h"
#include "read/formats/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace eikonal {

/// Whether the camera or a shape names a medium.
static bool mediaAreUsed(const Scene& scene) {
    if (scene.camera.medium != none) return true;
    const auto names = [](const Shape& s) { return s.interface && (s.interface->inside != none || s.interface->outside != none); };
    if (std::any_of(scene.shapes.begin(), scene.shapes.end(), names)) return true;
    return std::any_of(scene.objects.begin(), scene.objects.end(),
                       [&](const Object& o) { return std::any_of(o.shapes.begin(), o.shapes.end(), names); });
}

PackedTextures packTextures(const Scene& scene, std::span<const int> textures, Diagnostics& diagnostics) {
    PackedTextures result;
    const PackContext context{.scene = scene, .diagnostics = diagnostics, .required = result.scene, .images = loadImages(scene.images)};
    result.scene.tables.frame.emplace_back();
    ColorPacker colors(context, result.scene.tables);
    TexturePacker packer(context, result.scene.tables, colors);
    for (const int texture : textures) result.programs.push_back(packer.texture(texture));
    return result;
}

/// Hands each part the tables that it writes and the parts that it uses, then runs them in order.
static Hierarchies packParts(const PackContext& context, PackedScene& packed) {
    SceneTables& tables = packed.tables;
    settings& frame = packed.frame();
    ColorPacker colors(context, tables);
    TexturePacker textures(context, tables, colors);
    MeasuredPacker measured(context, tables, packed.constants, colors);
    MicrofacetEnergyPacker energy(tables, packed.constants);
    MediumPacker media(context, tables, colors);
    MaterialPacker materials({context, tables, colors, textures, measured, energy}, media);
    LightPacker lights(context, tables, frame, colors, textures, packed.lightGroups);

    if (context.spectral) {
        colors.packSensor(frame);
        colors.packFilmSpectrum(frame);
    }
    packIntegrator({context, frame, colors}, !context.hasMedia && mediaAreUsed(context.scene));
    packSampler(context, frame);
    const CameraPacking camera{context, tables, packed.cameraUnit};
    packCamera(camera, frame.view);
    packFilter(camera, frame.pixel_filter);
    media.pack();
    Hierarchies hierarchies = packGeometry({context, tables, packed.counts, textures, materials, lights});
    packed.materialSources = materials.sources();
    if (context.has(Feature::SUBSURFACE)) warnOfNestedBodies(context);
    lights.pack();
    chooseLightPaths(context, packed);
    packPathGuide(context, packed);
    if (context.spectral && sharesWavelengths(context.required.features)) colors.packPassWavelengths(frame);
    lights.packEmission();
    media.packEquiangularLights(tables.lights);
    return hierarchies;
}

/// Says what an image lacks if another integrator renders the scene than the one that it names.
static void warnOfStandIn(const IntegratorDescription& integrator, const PackedScene& packed, Diagnostics& diagnostics) {
    if (integrator.standsFor.name.empty()) return;
    const std::vector<std::string> missed = missedLight(packed);
    diagnostics.unsupported("integrator", integrator.where,
                            fmt::format("integrator \"{}\" is not available; {}", integrator.standsFor.name,
                                        missed.empty() ? integrator.standsFor.instead
                                                       : fmt::format("\"{}\" is used instead. In this scene {}", integrator.kind->name,
                                                                     fmt::join(missed, "; "))));
}

Packing packTables(const Scene& scene, Diagnostics& diagnostics) {
    const auto start = std::chrono::steady_clock::now();
    Packing result;
    PackedScene& packed = result.scene;
    const SceneBounds bounds = boundsOf(scene);
    const std::vector<std::shared_ptr<const ImageData>> images = loadImages(scene.images);
    for (size_t i = 0; i < images.size(); ++i)
        if (images[i] && images[i]->replaced > 0)
            diagnostics.warn(scene.images[i].where,
                             fmt::format("image \"{}\" has {} values that are not finite: 0 is taken for what is no number, and 65504 "
                                         "for infinity",
                                         scene.images[i].path, images[i]->replaced));
    packed.color = chooseColor(scene, images, bounds.near);
    if (packed.color.spectral) packed.require(Feature::SPECTRAL, packed.color.why);
    const PackContext context{.scene = scene,
                              .diagnostics = diagnostics,
                              .required = packed,
                              .space = spaceOf(bounds),
                              .bounds = bounds.near,
                              .whole = bounds.all,
                              .hasMedia = scene.integrator.kind->countsMedia && mediaAreUsed(scene),
                              .spectral = packed.color.spectral,
                              .images = images};
    packed.worldScale = 1 / context.space.scale;
    packed.worldCenter = context.space.center;
    packed.pixels = renderedPixels(scene.film, diagnostics);
    packed.cameraFromScene = cameraFromScene(context);
    packed.cameraUnit = cameraUnit(context);
    packed.samples = scene.sampler.pixelSamples;
    packed.roulette = scene.integrator.roulette;
    packed.isAlwaysGuided = scene.integrator.environmentGuide == EnvironmentGuide::always;
    packed.tables.frame.emplace_back();
    packed.frame().width = static_cast<uint>(scene.film.width);
    packed.frame().height = static_cast<uint>(scene.film.height);
    result.hierarchies = packParts(context, packed);
    warnOfStandIn(scene.integrator, packed, diagnostics);

    settings& frame = packed.frame();
    frame.light_count = static_cast<uint>(packed.tables.light_aliases.size());
    frame.world_scale = static_cast<float>(packed.worldScale);
    packExposure(scene.film, frame);
    if (scene.film.reweightsFireflies) context.require(Feature::FIREFLIES, "--fireflies");
    packed.constants.environments = static_cast<int>(packed.tables.environments.size());
    packed.constants.interleavedRays = interleavedRays(packed.tables.element_shapes.size());

    SceneCounts& counts = packed.counts;
    counts.objects = scene.objects.size();
    counts.instances = scene.instances.size();
    counts.lights = packed.tables.lights.size();
    counts.materials = packed.tables.materials.size();
    counts.textures = scene.textures.size();
    counts.images = scene.images.size();
    counts.media = packed.tables.media.size();
    counts.loadSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

PackedScene packScene(const Scene& scene, Diagnostics& diagnostics) {
    Packing packing = packTables(scene, diagnostics);
    packing.hierarchies.build(packing.scene.tables, packing.scene.counts, diagnostics);
    return std::move(packing.scene);
}

}  // namespace eikonal
