#include "render/session.h"

#include "render/render.h"
#include "render/survey.h"
#include "pack/pack.h"
#include "render/kernel_workers.h"
#include "render/scene_loading.h"
#include "background.h"
#include "messages.h"
#include "wait_notice.h"
#include "image/formats/image_formats.h"
#include "read/formats/input_files.h"
#include "kinds/integrator_kind.h"
#include "kinds/medium_kind.h"
#include "render/displacement.h"
#include "render/path_loop.h"
#include "render/roulette_pilot.h"
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

void warnOfDarkness(const Scene& scene, const PackedScene& packed, Diagnostics& diagnostics) {
    const auto emits = [](const Medium& m) { return emissionOf(m) != MediumEmission::none; };
    if (!scene.integrator.kind->countsMaterials() || packed.counts.lights > 0) return;
    if (packed.features.has(Feature::MEDIA) && std::ranges::any_of(scene.media, emits)) return;
    diagnostics.warn({}, "the scene has no light: the image will be black");
}

Session::Session(const SessionOptions& options, Diagnostics& diagnostics, bool profiling, std::shared_ptr<OpenDevice> open)
    : options_(options),
      diagnostics_(diagnostics),
      profiling_(profiling),
      begin_(open ? secondsSinceStart() : 0),
      device_(std::move(open)) {
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
    /* Opening a device reads a whole compiler from disk: time to read the scene meanwhile, and to load what decodes its images. The device
       is opened on the thread that uses it: Oclgrind 21.10 keeps its memory apart for each thread */
    auto loaded = inBackground([this] {
        const Stopwatch time;
        scene_ = loadScene(options_.scene, diagnostics_);
        if (std::ranges::any_of(scene_.images, [](const ImageFile& image) { return !image.pixels; })) imageFormats();
        times_.load = time.seconds();
    });
    if (withDevice) openDevice();
    loaded.get();
}

void Session::openDevice() {
    const Stopwatch time;
    if (!device_) {
        device_ = std::make_shared<OpenDevice>(options_.device, profiling_);
        if (options_.device.cache) reportCacheFolder(diagnostics_);
        warnOfInexactFlags(options_.device.compilerFlags(), diagnostics_);
    }
    times_.device = time.seconds();
}

void Session::displace() {
    if (!hasDisplacedMeshes(scene_)) return;
    if (!device_) openDevice();
    const WaitNotice notice("displacing meshes", !showsProgress(options_.log));
    const Stopwatch time;
    displaceMeshes(scene_, device_->context, device_->compiler, device_->shape, buildSettingsFor(options_.device), diagnostics_);
    times_.displace = time.seconds();
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
    scene_.shapes.clear();
    scene_.objects.clear();
    scene_.images.clear();
    if (aovs.has(AovSource::surfaces)) packed_.require(Feature::AOVS, "--aov, or a film \"gbuffer\"");
    if (aovs.has(AovSource::passes)) packed_.require(Feature::RENDER_PASSES, "--aov");
    if (aovs.motion && packed_.features.has(Feature::MOTION)) packed_.require(Feature::MOTION_VECTORS, "--aov, or a film \"gbuffer\"");
    times_.pack = time.seconds();
    /* What the scene requires is known: kernels get ready while its hierarchies are built */
    auto built = inBackground([&] { packing.hierarchies.build(packed_.tables, packed_.counts, diagnostics_); });
    if (device_) buildKernels();
    built.get();
    times_.build = packed_.counts.buildSeconds;
}

void Session::buildKernels() {
    const Stopwatch time;
    const BuildSettings settings = buildSettingsFor(options_.device);
    missing_ = Stages::missing(device_->compiler, packed_, device_->shape, settings);
    compiling_ = std::make_unique<WaitNotice>(
        fmt::format("compiling {} kernel{} for this device{}", missing_, missing_ == 1 ? "" : "s",
                    device_->compiler.cache().folder().empty() ? "" : "; they are kept for the next time"),
        "compiling kernels", WaitNotice::Parts{&compiled_, missing_}, missing_ == 0 || !showsProgress(options_.log));
    const auto stepDone = [this] { compiled_ = ++compileSteps_ / 2; };
    if (options_.device.cache && device_->context.device().isCpu) compileInWorkers(options_.device, packed_, missing_, stepDone);
    times_.workers = time.seconds();
    stages_ = std::make_unique<Stages>(device_->compiler, packed_, device_->shape, settings, StagePart{}, stepDone);
    if (compiled_ >= missing_) compiling_.reset();
    times_.compile = time.seconds();
}

void Session::select(const Tile& tile) {
    if (tile.count > wholePixels_.height())
        throw UsageError(
            fmt::format("--tile: the image has {} rows, so it can have as many parts, not {}", wholePixels_.height(), tile.count));
    packed_.pixels = rowsOf(wholePixels_, tile);
}

MemoryPlan Session::plan() const {
    const size_t pixels = static_cast<size_t>(packed_.pixels.width()) * static_cast<size_t>(packed_.pixels.height());
    const StageShape shape = device_ ? device_->shape : StageShape();
    const size_t onDevice = std::min<size_t>(pixels, shape.wavePaths);
    return {packed_.tables.bytes(), plannedWaveBytes(packed_, shape), plannedVertexBytes(packed_),
            pixels * Film::bytes(packed_, static_cast<unsigned>(packed_.samples)) + onDevice * Film::bytes(packed_, 0),
            pixels * Film::developedBytes(packed_)};
}

void Session::prepare() {
    const Stopwatch uploadTime;
    deviceScene_ = std::make_unique<DeviceScene>(device_->context, packed_);
    times_.upload = uploadTime.seconds();
    const Stopwatch launchTime;
    const size_t paths =
        static_cast<size_t>(packed_.pixels.width()) * static_cast<size_t>(packed_.pixels.height()) * static_cast<size_t>(packed_.samples);
    wave_ = std::make_unique<Wave>(device_->context, *deviceScene_, packed_, *stages_, device_->shape, profile_,
                                   paths < device_->shape.wavePaths ? PageSize::small : PageSize::large);
    wave_->warmUp();
    compiling_.reset();
    times_.launch = launchTime.seconds();
    const Stopwatch keepTime;
    stages_->keep(device_->compiler);
    times_.keep = keepTime.seconds();
    times_.firstRay = seconds();
}

uint Session::unresolvedRays() const { return deviceScene_->unresolvedRays(device_->context); }

void Session::survey(const std::function<bool()>& abandon) {
    const StopWatcher watcher(deviceScene_->stopFlag(), abandon);
    surveyEnvironment(device_->context, *deviceScene_, packed_, *stages_, device_->shape);
    chosenRoulette_ = pilotRoulette(device_->context, *deviceScene_, packed_, *wave_);
    profile_.collect();
    profile_.reset();
}

void Session::setSeed(int seed) {
    packed_.frame().seed = static_cast<uint>(seed);
    deviceScene_->setFrame(device_->context, packed_.frame());
    if (!packed_.features.has(Feature::MERGING)) return;
    for (wavelength_range& range : packed_.tables.wavelengths) range.pass_seed = packed_.frame().seed;
    deviceScene_->replace(device_->context, "wavelengths", packed_.tables.wavelengths);
}

std::unique_ptr<Tracer> Session::makeLoop(Profile& profile) {
    return std::make_unique<PathLoop>(device_->context, device_->compiler, *deviceScene_, packed_, device_->shape,
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
