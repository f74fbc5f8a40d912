#pragma once
// What it takes to render a scene, made ready step by step, with the time that each step took.

#include "film/tile.h"
#include "render/biased_choices.h"
#include "render/options.h"
#include "pack/tables.h"
#include "clock.h"
#include "render/device_scene.h"
#include "render/profile.h"
#include "render/open_device.h"
#include "render/stages.h"
#include "scene/scene.h"
#include "render/wave.h"

#include <tbb/global_control.h>

#include <atomic>
#include <memory>
#include <optional>

namespace eikonal {

class WaitNotice;

/// Sets what OpenCL implementations read from the environment. To be called before the first call of OpenCL.
void prepareOpenCl(const DeviceOptions& options);

/// Seconds of each step. Steps that run at the same time count each in full.
struct SessionTimes {
    double start = 0;       ///< to load the program and its libraries, up to the first line of the session
    double device = 0;      ///< to find and open the device
    double load = 0;        ///< to read the scene's files
    double pack = 0;        ///< to load its images and fill its tables
    double displace = 0;    ///< of that: meshes that a texture displaces
    double build = 0;       ///< the acceleration structure
    double compile = 0;     ///< to build the kernels
    double workers = 0;     ///< of that: in processes of their own, on all cores
    double upload = 0;      ///< tables to the device
    double launch = 0;      ///< to make the queues, and launch each kernel once
    double keep = 0;        ///< to store them in the cache
    double firstRay = 0;    ///< from the session's begin (Session::seconds) until the first ray could start
};

/// Bytes that a render takes, known before any of it is allocated.
struct MemoryPlan {
    size_t tables = 0;      ///< the scene, on the host and on the device
    size_t queues = 0;      ///< a wave of paths, on the device
    size_t vertices = 0;    ///< stored vertices of light paths, on the device
    size_t film = 0;        ///< on the host, and the part of it that is on the device at a time
    size_t image = 0;       ///< beside it, once it is developed
};

/// Warns of a scene whose image will be black, because nothing in it shines and its integrator needs light.
void warnOfDarkness(const Scene& scene, const PackedScene& packed, Diagnostics& diagnostics);

/// A scene on a device, with kernels that are compiled.
class Session {
public:
    /// profiling: kernels are timed.
    /// device: of a session before; null: one is opened when it is needed.
    Session(const SessionOptions& options, Diagnostics& diagnostics, bool profiling = false, std::shared_ptr<OpenDevice> device = {});
    ~Session();

    /// Reads the scene, while the device opens. Without a device, plan() supposes a processor.
    void load(bool withDevice = true);
    /// What follows is laid out for so many samples per pixel: the points of samplers, and what survey() learns. Default: the scene's.
    /// Before pack().
    void layOutFor(int samples) { scene_.sampler.pixelSamples = samples; }
    /// Fills its tables, forgets the scene's meshes and images, and builds its hierarchies while the kernels are built, if there is a
    /// device; the film keeps what `aovs` take, and a spectrum if the scene asks for it and keepsSpectrum.
    void pack(const Aovs& aovs, bool keepsSpectrum = true);
    /// Renders only a part of the pixels. After pack(), before prepare(). Throws a UsageError if there are more parts than rows.
    void select(const Tile& tile);
    /// The pixels to render, without select().
    const PixelRect& wholePixels() const { return wholePixels_; }
    /// What prepare() is going to allocate.
    MemoryPlan plan() const;
    /// Uploads the tables and launches every kernel once.
    void prepare();
    /// Learns what a first look at the scene can tell (render/survey.h, render/roulette_pilot.h). Part of rendering; its work is not part
    /// of the profile. `abandon`: as in RenderControl; what is not learned by then stays unknown.
    void survey(const std::function<bool()>& abandon = {});
    /// By which paths end, once survey() has been called, and whether it has chosen that for the scene.
    Roulette roulette() const { return chosenRoulette_.value_or(packed_.roulette.value_or(Roulette())); }
    bool isRouletteChosen() const { return chosenRoulette_.has_value(); }

    /// How many rays at implicit surfaces have run out of splits so far. After prepare(). Blocks.
    uint unresolvedRays() const;

    /// What is rendered from now on has this seed: other noise. After prepare().
    void setSeed(int seed);

    /// What makes the image converge to something other than the scene's light transport. After pack().
    std::vector<BiasedChoice> biasedChoices() const { return eikonal::biasedChoices(scene_, packed_, options_.device.compilerFlags()); }

    const Scene& scene() const { return scene_; }
    const PackedScene& packed() const { return packed_; }
    /// What a later session may share; null: no device has been opened yet.
    const std::shared_ptr<OpenDevice>& device() const { return device_; }
    const Context& context() const { return device_->context; }
    const Compiler& compiler() const { return device_->compiler; }
    const StageShape& shape() const { return device_->shape; }
    const Stages& stages() const { return *stages_; }
    Wave& wave() { return *wave_; }
    /// The same paths by one kernel that loops, compiled but for its first launch. Adds what it does to `profile`; lives no longer than
    /// this.
    std::unique_ptr<Tracer> makeLoop(Profile& profile);
    Profile& profile() { return profile_; }
    const SessionTimes& times() const { return times_; }
    /// Since the session began; that of the first session of a device is the start of the program.
    double seconds() const { return secondsSinceStart() - begin_; }
    int compiledStages() const { return missing_; }   ///< how many were not in the cache before

private:
    void openDevice();
    /// Loads or compiles what the packed scene requires.
    void buildKernels();
    /// Moves the vertices of meshes that a texture displaces: a device looks it up.
    void displace();

    const SessionOptions& options_;
    Diagnostics& diagnostics_;
    const bool profiling_;
    const double begin_;
    std::optional<tbb::global_control> hostThreads_;
    Scene scene_;
    PackedScene packed_;
    PixelRect wholePixels_;
    SessionTimes times_;
    Profile profile_;
    std::optional<Roulette> chosenRoulette_;
    int missing_ = 0;
    int compileSteps_ = 0;              ///< two steps compile a kernel
    std::atomic<int> compiled_ = 0;     ///< read by the notice
    std::unique_ptr<WaitNotice> compiling_;
    std::shared_ptr<OpenDevice> device_;
    std::unique_ptr<DeviceScene> deviceScene_;
    std::unique_ptr<Stages> stages_;
    std::unique_ptr<Wave> wave_;
};

/// A number that changes with anything in the scene but the seed and the number of samples.
std::string sceneHash(const PackedScene& scene);

}  // namespace eikonal
