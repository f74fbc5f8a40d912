#include "render/scene_on_device.h"

#include "clock.h"
#include "pack/cached_hits.h"
#include "pack/light_vertices.h"
#include "pack/pack.h"
#include "render/kernel_workers.h"
#include "render/merge_radius_pilot.h"
#include "render/roulette_pilot.h"
#include "render/row_costs.h"
#include "render/survey.h"

namespace eikonal {

int SceneOnDevice::missingKernels(const PackedScene& scene) const {
    return Stages::missing(device_->compiler, scene, device_->shape, buildSettingsFor(device_->options));
}

double SceneOnDevice::build(const PackedScene& scene, int missing, const std::function<void()>& stepDone) {
    const Stopwatch time;
    if (device_->options.cache && context().device().isCpu) compileInWorkers(device_->options, scene, missing, stepDone);
    const double workers = time.seconds();
    stages_ = std::make_unique<Stages>(device_->compiler, scene, device_->shape, buildSettingsFor(device_->options), StagePart{}, stepDone);
    return workers;
}

void SceneOnDevice::launch(const PackedScene& scene, bool isShared) {
    const size_t paths =
        static_cast<size_t>(scene.pixels.width()) * static_cast<size_t>(scene.pixels.height()) * static_cast<size_t>(scene.samples);
    wave_ = std::make_unique<Wave>(context(), *tables_, scene, *stages_, device_->shape, profile_,
                                   paths < device_->shape.wavePaths ? PageSize::small : PageSize::large);
    wave_->warmUp(isShared);
}

/// The settings of a render that knows what was learned.
static settings settingsWith(const PackedScene& scene, const Learned& learned) {
    settings frame = scene.frame();
    if (learned.mergeRadius) setMergeRadius(frame, *learned.mergeRadius);
    if (learned.roulette) setRoulette(frame, *learned.roulette);
    return frame;
}

/// A guided path takes up to 1.6 times as long: it is longer, and each vertex looks up a place.
constexpr double leastGuideGain = 1.8;

std::optional<double> SceneOnDevice::surveyMergeRadius(const PackedScene& scene) {
    const std::optional<double> radius = pilotMergeRadius(context(), *tables_, scene, *stages_, device_->shape, *wave_);
    profile_.collect();
    profile_.reset();
    return radius;
}

void SceneOnDevice::survey(const PackedScene& scene, Learned& learned, const std::function<bool()>& abandon) {
    const StopWatcher watcher(tables_->stopFlag(), abandon);
    surveyEnvironment(context(), *tables_, scene, *stages_, device_->shape);
    learned.guide = pilotPathGuide(context(), *tables_, scene, *wave_);
    learned.dropsGuide = learned.guide.gain && *learned.guide.gain < leastGuideGain;
    learned.roulette.reset();
    if (!learned.guide.isEmpty() && !scene.roulette) learned.roulette = guidedRoulette;
    else if (!learned.dropsGuide) learned.roulette = pilotRoulette(context(), *tables_, scene, *wave_);
    setLearned(scene, learned);
    profile_.collect();
    profile_.reset();
}

std::vector<std::uint64_t> SceneOnDevice::rowCosts(const PackedScene& scene, const Learned& learned, const PixelRect& rows) {
    const TraversalSteps steps(context(), device_->compiler, *tables_, scene, device_->shape, buildSettingsFor(device_->options));
    std::vector<std::uint64_t> costs =
        estimateRowCosts(context(), *tables_, scene, settingsWith(scene, learned), rows, steps, *wave_);
    steps.keep();
    profile_.collect();
    profile_.reset();
    return costs;
}

void SceneOnDevice::takeSurvey(const PackedScene& scene, const Learned& learned, const std::function<bool()>& abandon) {
    const StopWatcher watcher(tables_->stopFlag(), abandon);
    surveyEnvironment(context(), *tables_, scene, *stages_, device_->shape);
    usePathGuide(context(), *tables_, learned.guide);
    setLearned(scene, learned);
}

void SceneOnDevice::setLearned(const PackedScene& scene, const Learned& learned) {
    tables_->setFrame(context(), settingsWith(scene, learned));
}

void SceneOnDevice::setSeed(const PackedScene& scene, const Learned& learned) {
    setLearned(scene, learned);
    if (sharesWavelengths(scene.features)) tables_->replace(context(), "wavelengths", scene.tables.wavelengths);
}

}  // namespace eikonal
