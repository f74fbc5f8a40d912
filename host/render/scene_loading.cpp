#include "render/scene_loading.h"

#include "kinds/integrator_kind.h"
#include "kinds/material_kind.h"
#include "read/obj/obj.h"
#include "read/pbrt/read_pbrt.h"
#include "standard_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace eikonal {

/// The file's extension in lower case, ignoring .gz.
static std::string kindOf(const std::string& path) {
    std::filesystem::path name = std::filesystem::path(path).filename();
    if (name.extension() == ".gz") name = name.stem();
    std::string kind = name.extension().string();
    for (char& c : kind) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return kind;
}

/// Moves the shutter to the time of a frame: frame 0 is seen as the scene says.
static void openShutterFor(const SceneOptions& o, Scene& scene) {
    if (!o.fps || !o.frame) return;
    CameraDescription& camera = scene.camera;
    const double passed = *o.frame / *o.fps, length = camera.shutterClose - camera.shutterOpen;
    const bool isInstant = length == 0;   // option "disablepixeljitter"
    camera.shutterOpen += passed;
    camera.shutterClose = o.shutter && !isInstant ? camera.shutterOpen + *o.shutter / *o.fps : camera.shutterClose + passed;
    if (o.shutter) scene.film.exposureTime = *o.shutter / *o.fps;
}

static Scene loadObj(const SceneOptions& o, Diagnostics& diagnostics) {
    ObjOptions obj;
    obj.camera = o.camera;
    obj.lookAt = o.lookAt;
    if (o.up) obj.up = *o.up;
    obj.fov = o.fov;
    if (o.resolution) { obj.width = (*o.resolution)[0]; obj.height = (*o.resolution)[1]; }
    if (o.turntable) obj.turns = static_cast<double>(o.frame.value_or(0) % *o.turntable) / *o.turntable;
    obj.missingFiles = o.missingFiles;
    return readObj(o.path, obj, diagnostics);
}

static Scene loadPbrt(const SceneOptions& o, Diagnostics& diagnostics) {
    const char* name = o.camera ? "--camera" : o.lookAt ? "--look-at" : o.up ? "--up" : o.fov ? "--fov" : nullptr;
    if (name) throw UsageError(fmt::format("{} is for OBJ files; change the camera of a pbrt scene in \"{}\" itself", name, o.path));
    Scene scene = isStandardStream(o.path) ? readPbrtInput(diagnostics, o.missingFiles) : readPbrt(o.path, diagnostics, o.missingFiles);
    if (o.resolution) {
        /* The file's pixel bounds are meaningless at another resolution */
        scene.film.width = (*o.resolution)[0];
        scene.film.height = (*o.resolution)[1];
        if (scene.film.pixelBounds)
            diagnostics.warn(scene.film.where, "\"pixelbounds\" is ignored because of --resolution; use --cropwindow to render a part");
        scene.film.pixelBounds.reset();
    }
    openShutterFor(o, scene);
    return scene;
}

/// Warns of options that change nothing in this scene, with its integrator.
static void warnOfOptionsWithoutEffect(const SceneOptions& o, const Scene& scene, Diagnostics& diagnostics) {
    const IntegratorKind& kind = *scene.integrator.kind;
    const auto warn = [&](const char* option, const std::string& why) {
        diagnostics.warn({}, fmt::format("{} has no effect here: {}", option, why));
    };
    const bool choosesLights = samplesLights(scene.integrator) && kind.countsMaterials();
    const std::string noTree = fmt::format("it is for integrator \"whitted\", not for \"{}\"", kind.name),
                      noLights = fmt::format("integrator \"{}\" does not sample lights", kind.name);
    if (o.treeThreshold && !kind.splitsRays) warn("--threshold", noTree);
    if (o.treeBundle && !kind.splitsRays) warn("--bundle", noTree);
    if (o.lightSampler && !choosesLights) warn("--light-sampler", noLights);
    if (o.environmentGuide && !choosesLights) warn("--environment-guide", noLights);
    const bool hasBodies = std::ranges::any_of(scene.materials, [](const Material& m) { return m.kind->hasMethods; });
    if (o.subsurface && !o.isSubsurfaceOfPreset && !hasBodies)
        warn("--subsurface", "the scene has no material \"subsurface\"");
}

bool isObj(const std::string& path) { return kindOf(path) == ".obj"; }

Scene loadScene(const SceneOptions& o, Diagnostics& diagnostics) {
    const std::string kind = isStandardStream(o.path) ? ".pbrt" : kindOf(o.path);
    if (kind != ".pbrt" && kind != ".obj")
        throw UsageError(
            fmt::format("\"{}\" is not a readable scene: its name must end in .pbrt or .obj, optionally followed by .gz", o.path));
    Scene scene = kind == ".obj" ? loadObj(o, diagnostics) : loadPbrt(o, diagnostics);
    if (o.spp) scene.sampler.pixelSamples = *o.spp;
    if (o.seed) scene.sampler.seed = *o.seed;
    if (o.sampler) scene.sampler.kind = *o.sampler;
    if (o.integrator) {
        scene.integrator.kind = o.integrator;
        scene.integrator.standsFor = {};
    }
    if (o.subsurface)
        for (Material& m : scene.materials) m.method = *o.subsurface;
    if (o.maxDepth) scene.integrator.maxDepth = *o.maxDepth;
    if (o.roulette || o.rouletteScale || o.rouletteDepth) {
        const Roulette usual;
        scene.integrator.roulette =
            Roulette{o.roulette.value_or(usual.rule), o.rouletteScale.value_or(usual.scale), o.rouletteDepth.value_or(usual.depth)};
    }
    if (o.colorMode) scene.colorMode = *o.colorMode;
    if (o.lightSampler) scene.integrator.lightSampler = *o.lightSampler;
    if (o.environmentGuide) scene.integrator.environmentGuide = *o.environmentGuide;
    if (o.guiding) scene.integrator.guiding = *o.guiding;
    if (o.regularize) scene.integrator.regularize = *o.regularize;
    if (o.maxComponentValue) scene.film.maxComponentValue = *o.maxComponentValue;
    if (o.reweightsFireflies) scene.film.reweightsFireflies = *o.reweightsFireflies;
    warnOfOptionsWithoutEffect(o, scene, diagnostics);
    if (o.treeThreshold) scene.integrator.threshold = *o.treeThreshold;
    if (o.treeBundle) scene.integrator.bundle = *o.treeBundle;
    if (o.cropWindow) { scene.film.cropWindow = o.cropWindow; scene.film.pixelBounds.reset(); }
    if (o.pixelBounds) { scene.film.pixelBounds = o.pixelBounds; scene.film.cropWindow.reset(); }
    if (o.cropWindow || o.pixelBounds)
        scene.film.cropPlace.file = std::make_shared<std::string>(o.cropWindow ? "--cropwindow" : "--pixelbounds");
    return scene;
}

}  // namespace eikonal
