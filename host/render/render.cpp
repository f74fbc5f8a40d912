#include "render/render.h"

#include "render/adaptive.h"
#include "render/batch_dealer.h"
#include "render/film_blocks.h"
#include "render/light_pass.h"
#include "render/passes.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <numeric>
#include <utility>

namespace eikonal {
namespace {

/// A render in progress.
class Rendering {
public:
    Rendering(std::span<const RenderDevice> devices, Film& film, const RenderControl& control)
        : team_(devices, [this](const RenderDevice& device, const DeviceError& error) { drop(device, error); }),
          mostPaths_(team_.mostPaths()),
          storedPasses_(film.splats() ? team_.first().tracer->mostStoredPasses() : 0),
          film_(film),
          control_(control) {
        const std::span<const unsigned> taken = film.taken();
        pixels_ = static_cast<double>(taken.size());
        paths_ = pathsBefore_ = std::accumulate(taken.begin(), taken.end(), 0.0) - pixels_ * film.firstSample();
        samples_ = *std::ranges::min_element(taken);
        for (const RenderDevice& d : devices) blocks_.try_emplace(d.tracer, *d.context);
    }

    RenderResult run() {
        const unsigned end = control_.endSample, firstEnd = control_.targetError ? std::min(end, AdaptiveSampling::firstSamples) : end;
        allPaths_ = std::max(pixels_ * (end - film_.firstSample()), paths_);
        planned_ = control_.planned;
        if (!control_.targetError && !planned_.empty()) planned_ = {end};   // adaptive before, uniform from now on
        finishPass();
        if (planned_.empty()) traceUniformly(firstEnd);
        if (stopped_ || !control_.targetError) return {!stopped_, samples_, {}, planned_};
        return traceAdaptively(end);
    }

private:
    void drop(const RenderDevice& device, const DeviceError& error) {
        const std::lock_guard lock(mutex_);
        if (control_.dropped) control_.dropped(device, error);
    }

    /// Brings a film that was stored in the middle of a pass to the end of that pass.
    void finishPass() {
        const unsigned most = *std::ranges::max_element(film_.taken()), lights = planned_.empty() ? most : meanOf(planned_);
        traceLights(lights);
        const std::span<const unsigned> goal = planned_.empty() ? std::span(&most, 1) : std::span<const unsigned>(planned_);
        for (Pass& missing : missingPasses(film_, goal, AdaptiveSampling::blockSize, mostPaths_)) {
            tracePass(std::move(missing), lights);
        }
        if (!stopped_) samples_ = *std::ranges::min_element(goal);
    }

    /// Takes samples of all pixels, from those that they have up to `end`.
    void traceUniformly(unsigned end) {
        unsigned begun = samples_;
        const auto nextPass = [&]() -> std::optional<Pass> {
            if (begun >= end) return {};
            Pass pass = uniformPass(film_.pixels(), {film_.firstSample(), begun}, end, mostPaths_);
            begun += pass.samples;
            return pass;
        };
        if (!film_.splats()) { trace(nextPass); return; }
        /* Pass by pass: a wave has either light paths or paths from the camera */
        while (!stopped_) {
            std::optional<Pass> pass = nextPass();
            if (!pass) return;
            tracePass(std::move(*pass), begun);
        }
    }

    RenderResult traceAdaptively(unsigned end) {
        if (planned_.empty()) planned_.push_back(samples_);
        AdaptiveSampling adaptive(film_.pixels(), planned_, end, *control_.targetError, control_.errorMetric);
        for (;;) {
            const std::vector<Block> blocks = adaptive.nextPass(film_);
            planned_ = adaptive.samples();
            if (blocks.empty()) return {true, samples_, adaptive.error(), planned_};
            allPaths_ = adaptive.plannedSamples();
            isPlanned_ = true;
            tracePass(cutBlocks(blocks, AdaptiveSampling::blockSize, film_.pixels(), mostPaths_), meanOf(planned_));
            if (stopped_) return {false, samples_, {}, planned_};
        }
    }

    static unsigned meanOf(const std::vector<unsigned>& samples) {
        return static_cast<unsigned>(std::accumulate(samples.begin(), samples.end(), 0.0) / static_cast<double>(samples.size()));
    }

    /// Traces the light paths of all samples up to `end` that the film lacks.
    void traceLights(unsigned end) {
        if (!film_.splats()) return;
        /* So few at a time that not much is lost if the render ends meanwhile, and that their vertices have room */
        const double pixels = static_cast<double>(film_.width()) * film_.height();
        auto atATime = static_cast<unsigned>(std::clamp(8.0 * mostPaths_ / pixels, 1.0, 1e6));
        if (storedPasses_) atATime = std::min(atATime, storedPasses_);
        for (unsigned begun = missingLights(); begun < end && !stopped_; begun = missingLights())
            traceLights(SampleRange{begun, std::min(end, begun + atATime)}, true);
    }

    /// The first sample whose light paths the film lacks.
    unsigned missingLights() const { return std::max(film_.splats()->end(), film_.firstSample()); }

    /// Traces the light paths of these samples of all pixels of the whole image, whatever part of it is rendered. Their splats are added to
    /// the film if `add`, once all of them have been traced.
    void traceLights(SampleRange samples, bool add) {
        const auto isToStopNow = [this] {
            const std::lock_guard lock(mutex_);
            return isToStop();
        };
        if (stopped_) return;
        if (!lights_) lights_.emplace(PixelRect{0, 0, film_.width(), film_.height()}, film_.pixels(), *film_.splats());
        const auto words = lights_->trace(team_, {samples, mostPaths_, storedPasses_ > 0}, isToStopNow, control_.abandon);
        stopped_ |= !words;
        if (!stopped_ && add) film_.splats()->add(samples, *words);
    }

    /// Traces passes until `nextPass` returns nothing. `vertices`: if light paths are stored, the samples of those that they meet.
    void trace(const std::function<std::optional<Pass>()>& nextPass, SampleRange vertices = {}) {
        BatchDealer dealer(film_, nextPass, mostPaths_);
        const auto work = [&](const RenderDevice& device) { traceOn(device, dealer); };
        while (!stopped_) {
            const size_t devices = team_.size();
            stopped_ |= storedPasses_ ? team_.runFirst(control_.abandon, work) : team_.run(control_.abandon, work);
            if (!dealer.hasLost()) return;
            /* The next device has no vertices yet */
            if (storedPasses_ && team_.size() < devices) traceLights(vertices, false);
        }
    }

    /// What one device does of that.
    void traceOn(const RenderDevice& device, BatchDealer& dealer) {
        FilmBlocks& blocks = blocks_.at(device.tracer);   // of the last batch, until they are in the film
        const auto next = [&]() -> std::optional<Batch> {
            const std::lock_guard lock(mutex_);
            if (isToStop()) return {};
            return dealer.deal(device.tracer);
        };
        const auto traced = [&](const Batch& batch) {
            endBatch(device, dealer, blocks);
            std::unique_lock lock(mutex_);
            while (dealer.stateOf(device.tracer) == BatchDealer::State::waiting) changed_.wait(lock);
            if (dealer.stateOf(device.tracer) == BatchDealer::State::ready) resolve(device, batch, blocks);
            else {
                dealer.lose(device.tracer);
                changed_.notify_all();
            }
        };
        const auto meanwhile = [&] { endBatch(device, dealer, blocks); };
        /* However this ends, no other device may wait for what this one still holds */
        struct AtEnd {
            std::function<void()> run;
            ~AtEnd() { run(); }
        } const atEnd{[&] {
            const std::lock_guard lock(mutex_);
            dealer.loseAll(device.tracer);
            changed_.notify_all();
        }};
        device.tracer->trace({next, traced, film_.pixels().x1, film_.pixels().y1, {}, meanwhile});
        meanwhile();
    }

    /// Traces the light paths of all samples up to `lights` that the film lacks, and a pass of paths from the camera.
    void tracePass(Pass pass, unsigned lights) {
        if (storedPasses_) traceBothEnds(pass, lights);
        traceLights(lights);
        std::optional<Pass> left = std::move(pass);
        if (!storedPasses_) trace([&] { return std::exchange(left, std::nullopt); });
    }

    /// Traces a pass some samples at a time, each time after the light paths of the same samples, whose vertices its paths meet.
    void traceBothEnds(const Pass& pass, unsigned lights) {
        const auto endOf = [](const Block& b) { return b.firstSample + b.samples; };
        for (unsigned begun = 0; !stopped_;) {
            /* The next samples of any block. Light paths whose splats the film has are traced again for their vertices alone */
            SampleRange now{~0u, 0};
            for (const Block& b : pass.blocks)
                if (endOf(b) > begun) now = {std::min(now.first, std::max(b.firstSample, begun)), std::max(now.end, endOf(b))};
            if (!now.end) return;
            now.end = std::min(now.end, now.first + storedPasses_);
            const unsigned missing = missingLights();
            for (const unsigned border : {missing, lights})
                if (now.first < border) now.end = std::min(now.end, border);
            traceLights(now, now.first == missing && now.end <= lights);

            Pass part{pass.size, {}, pass.samples ? now.length() : 0};
            for (const Block& b : pass.blocks) {
                const unsigned first = std::max(b.firstSample, now.first), end = std::min(endOf(b), now.end);
                if (first < end) part.blocks.push_back({b.x, b.y, first, end - first});
            }
            trace([left = std::optional(std::move(part))]() mutable { return std::exchange(left, std::nullopt); }, now);
            begun = now.end;
        }
    }

    bool isToStop() {
        if (control_.stop && control_.stop()) stopped_ = true;
        return stopped_;
    }

    /// Enqueues: adds the paths of a batch to its pixels.
    void resolve(const RenderDevice& device, const Batch& batch, FilmBlocks& blocks) {
        const Buffer& film = blocks.upload(film_, batch);
        device.tracer->resolve(batch, film);
        blocks.startDownload();
    }

    /// Waits for the batch that is being resolved, if any: it is in the film then, or lost if the device was interrupted.
    void endBatch(const RenderDevice& device, BatchDealer& dealer, FilmBlocks& blocks) {
        if (!blocks.batch()) return;
        const std::span<uint> pixels = blocks.wait();
        const std::lock_guard lock(mutex_);
        if (device.tracer->stopFlag().isRaised()) dealer.lose(device.tracer);   // resolve_film may have left pixels as they were
        else {
            film_.keep(pixels, *blocks.batch());
            finishBatch(device, dealer, *blocks.batch());
        }
        blocks.end();
        changed_.notify_all();
    }

    /// Counts a batch that is in the film.
    void finishBatch(const RenderDevice& device, BatchDealer& dealer, const Batch& batch) {
        std::uint64_t paths = 0;
        for (const Block& b : batch.blocks) {
            const PixelRect part = b.within(film_.pixels(), batch.size);
            paths += static_cast<std::uint64_t>(part.width()) * static_cast<std::uint64_t>(part.height()) * b.samples;
        }
        device.profile->paths += paths;
        paths_ += static_cast<double>(paths);
        samples_ += dealer.keep(device.tracer);
        if (control_.progress) control_.progress(progress());
        if (control_.pause) control_.pause(planned_);
    }

    Progress progress() const {
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
        std::optional<double> left;
        if (isPlanned_ || !control_.targetError) left = std::max(allPaths_ - paths_, 0.0) * seconds / (paths_ - pathsBefore_);
        return {std::min(paths_ / allPaths_, 1.0), seconds, left, samples_ - film_.firstSample(), paths_ / pixels_};
    }

    DeviceTeam team_;
    const unsigned mostPaths_;              ///< of a batch
    const unsigned storedPasses_;           ///< passes whose light paths are stored at a time; 0: none are
    Film& film_;
    const RenderControl& control_;
    std::mutex mutex_;                      ///< of all that several devices change, the film above all
    std::condition_variable changed_;       ///< a batch is in the film, or lost
    const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::map<const Tracer*, FilmBlocks> blocks_;
    std::optional<LightPass> lights_;
    bool stopped_ = false;
    bool isPlanned_ = false;                ///< adaptive sampling has planned the samples
    std::vector<unsigned> planned_;         ///< as for RenderControl::pause
    unsigned samples_ = 0;                  ///< samples that every pixel has
    double pixels_ = 0;
    double pathsBefore_ = 0, paths_ = 0, allPaths_ = 0;   ///< traced before, so far, and expected in total
};

}  // namespace

RenderResult render(std::span<const RenderDevice> devices, Film& film, const RenderControl& control) {
    return Rendering(devices, film, control).run();
}

}  // namespace eikonal
