#include "render/session.h"

#include "render/render.h"
#include "pack/light_media.h"
#include "pack/mattes.h"
#include "pack/pack.h"
#include "render/scene_loading.h"
#include "background.h"
#include "messages.h"
#include "wait_notice.h"
#include "read/formats/input_files.h"
#include "kinds/integrator_kind.h"
#include "kinds/light_kind.h"
#include "kinds/medium_kind.h"
#include "pack/cached_hits.h"
#include "pack/integrator.h"
#include "render/displacement.h"
#include "render/hit_cache.h"
#include "render/path_loop.h"
#include "render/table_hash.h"
#include "render/thread_limit.h"
#include "render/wave_queues.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <thread>

namespace eikonal {

void prepareOpenCl(const DeviceOptions& options) {
    preparePocl(ProgramCache::defaultFolder());
    if (options.threads > 0) setenv("POCL_MAX_PTHREAD_COUNT", std::to_string(options.threads).c_str(), 1);
}

/// Says if kernels are kept elsewhere than they ought to be.
static void reportCacheFolder(Diagnostics& diagnostics) {
    const CacheFolder cache = ProgramCache::chooseFolder();
    if (cache.refused.empty()) return;
    diagnostics.warnOnce("cache folder", {},
                         fmt::format("compiled kernels are {}: {} {}; EIKONAL_CACHE_DIR may name another folder",
                                     cache.path.empty() ? "not kept" : "kept in " + cache.path, cache.refused, cache.reason));
}

/// Warns of compiler flags that reorder sums or ignore what is not finite.
static void warnOfInexactFlags(const std::string& flags, Diagnostics& diagnostics) {
    for (const std::string& flag : inexactFlags(flags))
        diagnostics.warnOnce("inexact flags", {},
                             fmt::format("{} lets the compiler drop the compensation of sums, so images of many "
                                         "samples are off (by 0.3 % at 2^18), and samples that are not finite may not be found",
                                         flag));
}

/// Warns if the light of an environment would have to come through a medium without an end.
static void warnOfEndlessMedium(const Scene& scene, Diagnostics& diagnostics) {
    const auto isInfinite = [](const Light& light) { return light.kind->place == LightPlace::INFINITE; };
    const auto light = std::ranges::find_if(scene.lights, isInfinite);
    if (light == scene.lights.end()) return;
    const std::optional<int> outside = LightMedia(scene).outside();
    if (!outside || *outside == none) return;
    const Medium& medium = scene.media[static_cast<size_t>(*outside)];
    const bool isClear = glm::length(medium.sigmaA.albedo()) + glm::length(medium.sigmaS.albedo()) == 0;
    if (medium.kind->variation != MediumVariation::HOMOGENEOUS || isClear) return;
    diagnostics.warn(light->where,
                     fmt::format("no light comes from this environment into medium \"{}\", which has no end; a \"distant\" light "
                                 "would shine, and a shape of material \"interface\" around the scene and the camera can end the medium",
                                 medium.name));
}

void warnOfDarkness(const Scene& scene, const PackedScene& packed, Diagnostics& diagnostics) {
    const auto emits = [](const Medium& m) { return emissionOf(m) != MediumEmission::none; };
    if (!scene.integrator.kind->countsMaterials()) return;
    if (packed.features.has(Feature::MEDIA)) warnOfEndlessMedium(scene, diagnostics);
    if (packed.counts.lights > 0) return;
    if (packed.features.has(Feature::MEDIA) && std::ranges::any_of(scene.media, emits)) return;
    diagnostics.warn({}, "the scene has no light: the image will be black");
}

Session::Session(const SessionOptions& options, Diagnostics& diagnostics, bool profiling, OpenDevices open)
    : options_(options),
      diagnostics_(diagnostics),
      profiling_(profiling),
      begin_(open.empty() ? 0 : secondsSinceStart()) {
    for (std::shared_ptr<OpenDevice>& device : open) devices_.push_back(std::make_unique<SceneOnDevice>(std::move(device)));
    forgetInputFiles();
    times_.start = seconds();
    DeviceOptions device = options.device;
    const int cores = static_cast<int>(std::thread::hardware_concurrency()), wanted = device.threads > 0 ? device.threads : cores;
    if (const int threads = affordableThreads(wanted); threads < wanted) {
        diagnostics.warn({}, fmt::format("only {} of {} threads are used: the system has no more for this process (ulimit -u)",
                                         threads, wanted));
        device.threads = threads;
    }
    prepareOpenCl(device);
    if (device.threads > 0)
        hostThreads_.emplace(tbb::global_control::max_allowed_parallelism, static_cast<size_t>(device.threads));
}

Session::~Session() = default;

void Session::load(bool withDevice) {
    /* Opening a device reads a whole compiler from disk: time to read the scene meanwhile. The device is opened on the thread that uses it:
       Oclgrind 21.10 keeps its memory apart for each thread */
    auto loaded = inBackground([this] {
        const Stopwatch time;
        scene_ = loadScene(options_.scene, diagnostics_);
        times_.load = time.seconds();
    });
    if (withDevice) open();
    loaded.get();
}

OpenDevices Session::openDevices() const {
    OpenDevices all;
    for (const auto& device : devices_) all.push_back(device->open());
    return all;
}

std::string Session::deviceNames() const {
    std::vector<std::string> names;
    for (const auto& device : devices_)
        if (const std::string& name = device->context().device().name; std::ranges::find(names, name) == names.end()) names.push_back(name);
    return fmt::format("{}", fmt::join(names, " + "));
}

void Session::open() {
    const Stopwatch time;
    if (devices_.empty()) {
        for (std::shared_ptr<OpenDevice>& device : eikonal::openDevices(options_.device, profiling_))
            devices_.push_back(std::make_unique<SceneOnDevice>(std::move(device)));
        if (options_.device.cache) reportCacheFolder(diagnostics_);
        warnOfInexactFlags(options_.device.compilerFlags(), diagnostics_);
    }
    times_.device = time.seconds();
}

void Session::displace() {
    if (!hasDisplacedMeshes(scene_)) return;
    if (devices_.empty()) open();
    const WaitNotice notice("displacing meshes", !showsProgress(options_.log));
    const Stopwatch time;
    displaceMeshes(scene_, context(), first().open()->compiler, shape(), buildSettingsFor(options_.device), diagnostics_);
    times_.displace = time.seconds();
}

/// Has the film keep the light of each group.
static void keepLightGroups(PackedScene& packed) {
    if (packed.features.has(Feature::LIGHT_PATHS))
        throw UsageError("--aov lightgroups: paths from the lights do not keep groups apart; add --integrator volpath, or leave it out");
    packed.constants.lightGroups = static_cast<int>(packed.lightGroups.size());
    packed.require(Feature::LIGHT_GROUPS, "--aov");
}

void Session::pack(const Aovs& aovs, bool keepsSpectrum) {
    const Stopwatch time;
    if (scene_.film.spectrum && !keepsSpectrum) {
        /* It forces wavelengths all the same */
        scene_.film.spectrum.reset();
        if (scene_.colorMode == ColorMode::automatic) scene_.colorMode = ColorMode::spectral;
    }
    displace();
    Packing packing = packTables(scene_, diagnostics_);
    packed_ = std::move(packing.scene);
    wholePixels_ = packed_.pixels;
    warnOfDarkness(scene_, packed_, diagnostics_);
    if (aovs.has(AovSource::surfaces) || aovs.has(AovSource::names)) packed_.require(Feature::AOVS, "--aov, or a film \"gbuffer\"");
    if (aovs.cryptoObject) packed_.require(Feature::CRYPTO_OBJECT, "--aov");
    if (aovs.cryptoMaterial) packed_.require(Feature::CRYPTO_MATERIAL, "--aov");
    packMattes(scene_, packed_);
    const auto free = [](auto& list) { std::remove_reference_t<decltype(list)>().swap(list); };
    free(scene_.shapes);
    free(scene_.objects);
    free(scene_.instances);
    free(scene_.images);
    if (aovs.lightGroups) keepLightGroups(packed_);
    if (aovs.has(AovSource::passes)) packed_.require(Feature::RENDER_PASSES, "--aov");
    const bool inMovingSpace = scene_.film.gbuffer == GBuffer::cameraSpace && packed_.features.has(Feature::CAMERA_MOTION);
    if (inMovingSpace) packed_.require(Feature::CAMERA_SPACE, "a film \"gbuffer\" in the space of a camera that moves");
    if (aovs.motion && (inMovingSpace || packed_.features.has(Feature::MOTION)))
        packed_.require(Feature::MOTION_VECTORS, "--aov, or a film \"gbuffer\"");
    times_.pack = time.seconds();
    /* What the scene requires is known: kernels get ready while its hierarchies are built */
    auto built = inBackground([&] { packing.hierarchies.build(packed_.tables, packed_.counts, diagnostics_); });
    forEachDevice([this](SceneOnDevice& device) { buildKernels(device); });
    built.get();
    times_.build = packed_.counts.buildSeconds;
}

template <class Step> void Session::forEachDevice(const Step& step) {
    for (size_t i = 0; i < devices_.size();) {
        SceneOnDevice& device = *devices_[i];
        try {
            step(device);
            ++i;
        } catch (const DeviceError& error) {
            if (devices_.size() == 1) throw;
            drop(device.renderDevice(), error);
        }
    }
}

void Session::drop(const RenderDevice& gone, const DeviceError& error) {
    const auto found = std::ranges::find_if(devices_, [&](const auto& d) { return &d->context() == gone.context; });
    if (found == devices_.end() || devices_.size() == 1) return;
    diagnostics_.warn({}, fmt::format("\"{}\" has failed, and the other devices go on without it: {}", gone.context->device().name,
                                      error.what()));
    failed_.push_back(std::move(*found));
    devices_.erase(found);
}

std::vector<RenderDevice> Session::renderDevices() {
    std::vector<RenderDevice> all;
    for (const auto& device : devices_) all.push_back(device->renderDevice());
    return all;
}

void Session::joinProfiles() {
    std::vector<const SceneOnDevice*> all;
    for (const auto* list : {&devices_, &failed_})
        for (const auto& device : *list) all.push_back(device.get());
    double paths = 0;
    for (const SceneOnDevice* device : all) paths += static_cast<double>(device->profile().paths);
    std::vector<std::string> shares;
    for (const SceneOnDevice* device : all) {
        const double share = paths > 0 ? static_cast<double>(device->profile().paths) / paths : 0;
        shares.push_back(device->context().device().name + (all.size() > 1 ? fmt::format(" ({:.0f} % of the paths)", 100 * share) : ""));
    }
    shares_ = fmt::format("{}", fmt::join(shares, " + "));
    for (const SceneOnDevice* device : all)
        if (device != &first()) first().profile().join(device->profile());
}

void Session::buildKernels(SceneOnDevice& device) {
    const Stopwatch time;
    const int missing = device.missingKernels(packed_);
    missing_ += missing;
    compiled_ = compileSteps_ = 0;
    compiling_ = std::make_unique<WaitNotice>(
        fmt::format("compiling {} kernel{} for this device{}", missing, missing == 1 ? "" : "s",
                    device.open()->compiler.cache().folder().empty() ? "" : "; they are kept for the next time"),
        "compiling kernels", WaitNotice::Parts{&compiled_, missing}, missing == 0 || !showsProgress(options_.log));
    times_.workers += device.build(packed_, missing, [this] { compiled_ = ++compileSteps_ / 2; });
    if (compiled_ >= missing) compiling_.reset();
    times_.compile += time.seconds();
}

void Session::select(const Tile& tile) {
    if (tile.count > wholePixels_.height())
        throw UsageError(
            fmt::format("--tile: the image has {} rows, so it can have as many parts, not {}", wholePixels_.height(), tile.count));
    packed_.pixels = rowsOf(wholePixels_, tile);
}

void Session::selectByCost(const Tile& tile) {
    packed_.pixels = rowsOf(wholePixels_, tile, first().rowCosts(packed_, learned_, wholePixels_));
}

MemoryPlan Session::plan() const {
    const size_t pixels = static_cast<size_t>(packed_.pixels.width()) * static_cast<size_t>(packed_.pixels.height());
    MemoryPlan plan{.tables = packed_.tables.bytes()};
    size_t onDevices = 0;
    std::vector<StageShape> shapes;
    for (const auto& device : devices_) shapes.push_back(device->open()->shape);
    if (shapes.empty()) shapes.emplace_back();
    for (const StageShape& shape : shapes) {
        plan.queues += plannedWaveBytes(packed_, shape);
        plan.vertices += plannedVertexBytes(packed_) + plannedHitCacheBytes(packed_);
        onDevices += std::min<size_t>(pixels, shape.wavePaths);
    }
    plan.film = pixels * Film::bytes(packed_, static_cast<unsigned>(packed_.samples)) + onDevices * Film::bytes(packed_, 0);
    plan.image = pixels * Film::developedBytes(packed_);
    return plan;
}

void Session::prepare() {
    const auto timed = [this](double& seconds, auto step) {
        const Stopwatch time;
        forEachDevice(step);
        seconds = time.seconds();
    };
    timed(times_.upload, [this](SceneOnDevice& device) { device.upload(packed_); });
    timed(times_.launch, [this](SceneOnDevice& device) { device.launch(packed_, devices_.size() > 1); });
    compiling_.reset();
    if (packed_.features.has(Feature::MERGING) && scene_.integrator.mergeRadius <= 0) {
        learned_.mergeRadius = first().surveyMergeRadius(packed_);
        forEachDevice([this](SceneOnDevice& device) { device.setLearned(packed_, learned_); });
    }
    timed(times_.keep, [](SceneOnDevice& device) { device.keep(); });
    times_.firstRay = seconds();
}

ImplicitDoubts Session::implicitDoubts() const {
    ImplicitDoubts sums{};
    for (const auto& device : devices_) {
        const ImplicitDoubts counts = device->tables().implicitDoubts(device->context());
        std::ranges::transform(sums, counts, sums.begin(), std::plus());
    }
    return sums;
}

void Session::survey(const std::function<bool()>& abandon) {
    forEachDevice([&](SceneOnDevice& device) {
        if (&device == &first()) device.survey(packed_, learned_, abandon);
        else if (!learned_.dropsGuide) device.takeSurvey(packed_, learned_, abandon);
    });
    if (learned_.guide.gain) guideGain_ = learned_.guide.gain;
    if (!learned_.dropsGuide || (abandon && abandon())) return;
    dropPathGuide(packed_);
    forEachDevice([this](SceneOnDevice& device) { buildKernels(device); });
    prepare();
    survey(abandon);
}

void Session::setSeed(int seed) {
    packed_.frame().seed = static_cast<uint>(seed);
    if (sharesWavelengths(packed_.features))
        for (wavelength_range& range : packed_.tables.wavelengths) range.pass_seed = packed_.frame().seed;
    forEachDevice([this](SceneOnDevice& device) { device.setSeed(packed_, learned_); });
}

std::unique_ptr<Tracer> Session::makeLoop(Profile& profile) {
    return std::make_unique<PathLoop>(context(), first().open()->compiler, first().tables(), packed_, shape(),
                                      buildSettingsFor(options_.device), profile);
}

std::string sceneHash(const PackedScene& scene) {
    TableHash hash;
    hash.add(scene.frame());
    const auto add = [&](const auto& table) {
        using Element = typename std::decay_t<decltype(table)>::value_type;
        if constexpr (!std::is_same_v<Element, settings>) hash.add(table);
    };
#define HASH_TABLE(type, name) add(scene.tables.name);
    SCENE_TABLES(HASH_TABLE)
#undef HASH_TABLE
    return hash.text();
}

}  // namespace eikonal
