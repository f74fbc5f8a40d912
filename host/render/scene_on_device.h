#pragma once
// A packed scene on a device: its kernels, its tables, and a wave of paths.

#include "render/device_scene.h"
#include "render/device_team.h"
#include "render/open_device.h"
#include "render/path_guide_pilot.h"
#include "render/wave.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace eikonal {

/// What a first look at a scene has told, on one device for all.
struct Learned {
    std::optional<double> mergeRadius;  ///< of the first pass, if that was chosen for the scene; scene units
    std::optional<Roulette> roulette;   ///< how paths are to end, if that was chosen for the scene
    LearnedPathGuide guide;
    bool dropsGuide = false;            ///< the scene is better rendered without it, by other kernels; the rest was not learned
};

/// Made ready step by step: build, upload, launch, keep.
class SceneOnDevice {
public:
    explicit SceneOnDevice(std::shared_ptr<OpenDevice> device) : device_(std::move(device)) {}

    /// How many of its kernels are not in the cache.
    int missingKernels(const PackedScene& scene) const;
    /// Loads or compiles them, on a processor in processes of their own, if `missing` are worth it: as many as missingKernels() says, or 0.
    /// stepDone: called twice for each that is missing. Returns the seconds that the processes took.
    double build(const PackedScene& scene, int missing, const std::function<void()>& stepDone);
    /// Copies the scene's tables, which it may share from then on.
    void upload(const PackedScene& scene) { wave_.reset(); tables_ = std::make_unique<DeviceScene>(device_->context, scene); }
    /// Makes the queues, and launches every kernel once. isShared: as for Wave::warmUp.
    void launch(const PackedScene& scene, bool isShared);
    /// The radius within which vertices of a scene that merges them should merge (render/merge_radius_pilot.h). After launch().
    std::optional<double> surveyMergeRadius(const PackedScene& scene);
    /// Stores the kernels in the cache.
    void keep() { stages_->keep(device_->compiler); }
    /// Learns what a first look at the scene can tell (Session::survey), but for what is known before: the radius.
    void survey(const PackedScene& scene, Learned& learned, const std::function<bool()>& abandon);
    /// The same beside another device, which has learned that.
    void takeSurvey(const PackedScene& scene, const Learned& learned, const std::function<bool()>& abandon);
    /// What each of these rows of the image costs (estimateRowCosts). After survey().
    std::vector<std::uint64_t> rowCosts(const PackedScene& scene, const Learned& learned, const PixelRect& rows);
    /// Rendering from now on knows this.
    void setLearned(const PackedScene& scene, const Learned& learned);
    /// The same, with the scene's present seed.
    void setSeed(const PackedScene& scene, const Learned& learned);

    const std::shared_ptr<OpenDevice>& open() const { return device_; }
    const Context& context() const { return device_->context; }
    const DeviceScene& tables() const { return *tables_; }
    const Stages& stages() const { return *stages_; }
    Wave& wave() { return *wave_; }
    Profile& profile() { return profile_; }
    const Profile& profile() const { return profile_; }
    RenderDevice renderDevice() { return {&device_->context, wave_.get(), &profile_}; }

private:
    std::shared_ptr<OpenDevice> device_;
    Profile profile_;
    std::unique_ptr<DeviceScene> tables_;
    std::unique_ptr<Stages> stages_;
    std::unique_ptr<Wave> wave_;
};

}  // namespace eikonal
