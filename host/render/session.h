#pragma once
// What it takes to render a scene, made ready step by step, with the time that each step took.

#include "film/tile.h"
#include "render/biased_choices.h"
#include "render/options.h"
#include "pack/tables.h"
#include "clock.h"
#include "render/scene_on_device.h"
#include "scene/scene.h"

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

/// Warns of a scene whose image will be black, because nothing in it shines and its integrator needs light; and of an environment whose
/// light is absorbed by a medium around the scene.
void warnOfDarkness(const Scene& scene, const PackedScene& packed, Diagnostics& diagnostics);

/// A scene on one or several devices, with kernels that are compiled.
class Session {
public:
    /// profiling: kernels are timed.
    /// devices: of a session before; none: they are opened when they are needed.
    Session(const SessionOptions& options, Diagnostics& diagnostics, bool profiling = false, OpenDevices devices = {});
    ~Session();

    /// Reads the scene, while the devices open. Without a device, plan() supposes a processor.
    void load(bool withDevice = true);
    /// What follows is laid out for so many samples per pixel: the points of samplers, and what survey() learns. Default: the scene's.
    /// Before pack().
    void layOutFor(int samples) { scene_.sampler.pixelSamples = samples; }
    /// Fills its tables, forgets the scene's meshes and images, and builds its hierarchies while the kernels are built, if there is a
    /// device; the film keeps what `aovs` take, and a spectrum if the scene asks for it and keepsSpectrum.
    void pack(const Aovs& aovs, bool keepsSpectrum = true);
    /// Renders only a part of the pixels. After pack(), before prepare(). Throws a UsageError if there are more parts than rows.
    void select(const Tile& tile);
    /// The same by cost (render/row_costs.h). After prepare().
    void selectByCost(const Tile& tile);
    /// The pixels to render, without select().
    const PixelRect& wholePixels() const { return wholePixels_; }
    /// What prepare() is going to allocate.
    MemoryPlan plan() const;
    /// Uploads the tables, launches every kernel once, and learns how far vertices should merge, if they do.
    /// Of several devices those that fail are dropped, with a warning.
    void prepare();
    /// Learns what a first look at the scene can tell (render/survey.h, render/roulette_pilot.h). Part of rendering; its work is not part
    /// of the profile. `abandon`: as in RenderControl; what is not learned by then stays unknown.
    void survey(const std::function<bool()>& abandon = {});
    /// By which paths end, once survey() has been called, and whether it has chosen that for the scene.
    Roulette roulette() const { return learned_.roulette.value_or(packed_.roulette.value_or(Roulette())); }
    bool isRouletteChosen() const { return learned_.roulette.has_value(); }
    /// What an optional path guide was found to gain (LearnedPathGuide::gain), and whether the scene is rendered with it. Nothing if none
    /// was tried.
    struct TriedGuide { double gain; bool isUsed; };
    std::optional<TriedGuide> triedGuide() const {
        if (!guideGain_) return {};
        return TriedGuide{*guideGain_, packed_.features.has(Feature::PATH_GUIDE)};
    }

    /// What single precision could not decide at implicit surfaces so far. After prepare(). Blocks.
    ImplicitDoubts implicitDoubts() const;

    /// What is rendered from now on has this seed: other noise. After prepare().
    void setSeed(int seed);

    /// What makes the image converge to something other than the scene's light transport. After pack().
    std::vector<BiasedChoice> biasedChoices() const {
        return eikonal::biasedChoices(scene_, packed_, mergeRadius(), options_.device.compilerFlags());
    }
    /// Within which vertices merge in the first pass, world units. After prepare(), if the scene does not say it.
    double mergeRadius() const { return learned_.mergeRadius.value_or(double{packed_.frame().merge_radius}) * packed_.worldScale; }

    const Scene& scene() const { return scene_; }
    const PackedScene& packed() const { return packed_; }
    /// What a later session may share; empty: no device has been opened yet.
    OpenDevices openDevices() const;
    /// The names of the devices that render, each once, joined by " + ".
    std::string deviceNames() const;
    /// Of those that have rendered, with what share of the paths each has traced, if there are several. After joinProfiles().
    const std::string& sharesOfDevices() const { return shares_; }
    /// Those that render together. After prepare().
    std::vector<RenderDevice> renderDevices();
    /// Renders without this device from now on, which has failed.
    void drop(const RenderDevice& device, const DeviceError& error);
    /// Adds the profiles of all devices up, in profile(). At the end of a render.
    void joinProfiles();

    /// Of the first device.
    const Context& context() const { return first().context(); }
    const Compiler& compiler() const { return first().open()->compiler; }
    const StageShape& shape() const { return first().open()->shape; }
    const Stages& stages() const { return first().stages(); }
    Wave& wave() { return first().wave(); }
    Profile& profile() { return first().profile(); }
    /// The same paths by one kernel that loops, compiled but for its first launch. Adds what it does to `profile`; lives no longer than
    /// this.
    std::unique_ptr<Tracer> makeLoop(Profile& profile);
    const SessionTimes& times() const { return times_; }
    /// Since the session began; that of the first session of a device is the start of the program.
    double seconds() const { return secondsSinceStart() - begin_; }
    int compiledStages() const { return missing_; }   ///< how many were not in the cache before

private:
    void open();
    const SceneOnDevice& first() const { return *devices_.front(); }
    SceneOnDevice& first() { return *devices_.front(); }
    /// Calls step(device) for each device; those for which it throws a DeviceError are dropped, while others are left.
    template <class Step> void forEachDevice(const Step& step);
    /// Loads or compiles what the packed scene requires.
    void buildKernels(SceneOnDevice& device);
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
    Learned learned_;
    std::optional<double> guideGain_;
    int missing_ = 0;
    int compileSteps_ = 0;              ///< two steps compile a kernel
    std::atomic<int> compiled_ = 0;     ///< read by the notice
    std::unique_ptr<WaitNotice> compiling_;
    std::vector<std::unique_ptr<SceneOnDevice>> devices_;   ///< that render, the first first
    std::string shares_;
    std::vector<std::unique_ptr<SceneOnDevice>> failed_;    ///< launches of theirs may still be under way
};

/// A number that changes with anything in the scene but the seed and the number of samples.
std::string sceneHash(const PackedScene& scene);

}  // namespace eikonal
