#include "render/render.h"

#include "render/adaptive.h"
#include "render/passes.h"

#include <algorithm>
#include <chrono>
#include <deque>
#include <numeric>
#include <utility>

namespace eikonal {
namespace {

/// A render in progress.
class Rendering {
public:
    Rendering(const Context& context, Tracer& tracer, Film& film, Profile& profile, const RenderControl& control)
        : context_(context), tracer_(tracer), film_(film), profile_(profile), control_(control) {
        const std::span<const unsigned> taken = film.taken();
        pixels_ = static_cast<double>(taken.size());
        paths_ = pathsBefore_ = std::accumulate(taken.begin(), taken.end(), 0.0) - pixels_ * film.firstSample();
        samples_ = *std::ranges::min_element(taken);
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
    /// Brings a film that was stored in the middle of a pass to the end of that pass.
    void finishPass() {
        const unsigned most = *std::ranges::max_element(film_.taken()), lights = planned_.empty() ? most : meanOf(planned_);
        traceLights(lights);
        const std::span<const unsigned> goal = planned_.empty() ? std::span(&most, 1) : std::span<const unsigned>(planned_);
        for (Pass& missing : missingPasses(film_, goal, AdaptiveSampling::blockSize, tracer_.mostPaths())) {
            tracePass(std::move(missing), lights);
        }
        if (!stopped_) samples_ = *std::ranges::min_element(goal);
    }

    /// Takes samples of all pixels, from those that they have up to `end`.
    void traceUniformly(unsigned end) {
        unsigned begun = samples_;
        const auto nextPass = [&]() -> std::optional<Pass> {
            if (begun >= end) return {};
            Pass pass = uniformPass(film_.pixels(), {film_.firstSample(), begun}, end, tracer_.mostPaths());
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
            tracePass(cutBlocks(blocks, AdaptiveSampling::blockSize, film_.pixels(), tracer_.mostPaths()), meanOf(planned_));
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
        auto atATime = static_cast<unsigned>(std::clamp(8.0 * tracer_.mostPaths() / pixels, 1.0, 1e6));
        if (const unsigned most = tracer_.mostMergedPasses()) atATime = std::min(atATime, most);
        for (unsigned begun = missingLights(); begun < end && !stopped_; begun = missingLights())
            traceLights(SampleRange{begun, std::min(end, begun + atATime)}, true);
    }

    /// The first sample whose light paths the film lacks.
    unsigned missingLights() const { return std::max(film_.splats()->end(), film_.firstSample()); }

    /// Traces the light paths of these samples of all pixels of the whole image, whatever part of it is rendered. Their splats are added to
    /// the film if `add`, once all of them have been traced.
    void traceLights(SampleRange samples, bool add) {
        if (stopped_) return;
        SplatSums& splats = *film_.splats();
        const PixelRect whole{0, 0, film_.width(), film_.height()};
        std::vector<uint> words(splats.halves());
        if (!splats_.size()) splats_ = Buffer(context_, words.size() * sizeof(uint), "splats");
        std::optional<Batches> batches;
        unsigned begun = samples.first;
        const auto next = [&]() -> std::optional<Batch> {
            if (isToStop()) return {};
            if (!batches || batches->empty()) {
                if (begun == samples.end) return {};
                const Pass pass = uniformPass(whole, {0, begun}, samples.end, tracer_.mostPaths());
                batches.emplace(pass.size, pass.blocks, tracer_.mostPaths());
                begun += pass.samples;
            }
            return batches->next();
        };
        splats_.clear(context_, 0, words.size() * sizeof(uint));
        untilDone([&] { tracer_.traceLights({next, [](const Batch&) {}, whole.x1, whole.y1}, splats_, film_.pixels()); });
        if (stopped_ || !add) return;
        splats_.read(context_, words.data(), words.size() * sizeof(uint));
        splats.add(samples, words);
    }

    /// Traces passes until `nextPass` returns nothing.
    void trace(const std::function<std::optional<Pass>()>& nextPass) {
        std::optional<Batches> batches;
        const auto next = [&]() -> std::optional<Batch> {
            if (isToStop()) return {};
            if (!batches || batches->empty()) {
                const std::optional<Pass> pass = nextPass();
                if (!pass) return {};
                batches.emplace(pass->size, pass->blocks, tracer_.mostPaths());
                traced_.push_back({pass->samples, layersOf(*pass)});
            }
            return batches->next();
        };
        if (stopped_) return;
        untilDone([&] { tracer_.trace({next, [this](const Batch& batch) { resolve(batch); }, film_.pixels().x1, film_.pixels().y1}); });
    }

    /// Traces the light paths of all samples up to `lights` that the film lacks, and a pass of paths from the camera.
    void tracePass(Pass pass, unsigned lights) {
        const bool merges = tracer_.mostMergedPasses() && film_.splats();
        if (merges) traceMerging(pass, lights);
        traceLights(lights);
        std::optional<Pass> left = std::move(pass);
        if (!merges) trace([&] { return std::exchange(left, std::nullopt); });
    }

    /// Traces a pass some samples at a time, each time after the light paths of the same samples, whose vertices its paths merge with.
    void traceMerging(const Pass& pass, unsigned lights) {
        const auto endOf = [](const Block& b) { return b.firstSample + b.samples; };
        for (unsigned begun = 0; !stopped_;) {
            /* The next samples of any block. Light paths whose splats the film has are traced again for their vertices alone */
            SampleRange now{~0u, 0};
            for (const Block& b : pass.blocks)
                if (endOf(b) > begun) now = {std::min(now.first, std::max(b.firstSample, begun)), std::max(now.end, endOf(b))};
            if (!now.end) return;
            now.end = std::min(now.end, now.first + tracer_.mostMergedPasses());
            const unsigned missing = missingLights();
            for (const unsigned border : {missing, lights})
                if (now.first < border) now.end = std::min(now.end, border);
            traceLights(now, now.first == missing && now.end <= lights);

            Pass part{pass.size, {}, pass.samples ? now.length() : 0};
            for (const Block& b : pass.blocks) {
                const unsigned first = std::max(b.firstSample, now.first), end = std::min(endOf(b), now.end);
                if (first < end) part.blocks.push_back({b.x, b.y, first, end - first});
            }
            trace([left = std::optional(std::move(part))]() mutable { return std::exchange(left, std::nullopt); });
            begun = now.end;
        }
    }

    bool isToStop() {
        if (control_.stop && control_.stop()) stopped_ = true;
        return stopped_;
    }

    /// Runs something that traces paths, and waits for it. It may be interrupted.
    void untilDone(const std::function<void()>& trace) {
        const StopWatcher watcher(tracer_.stopFlag(), control_.abandon);
        trace();
        context_.finish();
        stopped_ |= tracer_.stopFlag().isRaised();
    }

    void resolve(const Batch& batch) {
        const PixelRect& rect = film_.pixels();
        const size_t bytes = static_cast<size_t>(batch.pixels()) * static_cast<size_t>(film_.words()) * sizeof(uint);
        if (blocks_.size() < bytes) blocks_ = Buffer(context_, bytes, "blocks of the film");
        film_.upload(context_, blocks_, batch);
        tracer_.resolve(batch, blocks_);
        film_.download(context_, blocks_, batch);
        if (tracer_.stopFlag().isRaised()) return;   // resolve_film may have left pixels as they were
        film_.keep(batch);
        std::uint64_t paths = 0;
        for (const Block& b : batch.blocks) {
            const PixelRect part = b.within(rect, batch.size);
            paths += static_cast<std::uint64_t>(part.width()) * static_cast<std::uint64_t>(part.height()) * b.samples;
        }
        profile_.paths += paths;
        paths_ += static_cast<double>(paths);
        traced_.front().layers -= batch.layers();
        if (!traced_.front().layers) { samples_ += traced_.front().samples; traced_.pop_front(); }
        if (control_.progress) control_.progress(progress());
        if (control_.pause) control_.pause(planned_);
    }

    Progress progress() const {
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
        std::optional<double> left;
        if (isPlanned_ || !control_.targetError) left = std::max(allPaths_ - paths_, 0.0) * seconds / (paths_ - pathsBefore_);
        return {std::min(paths_ / allPaths_, 1.0), seconds, left, samples_ - film_.firstSample(), paths_ / pixels_};
    }

    static unsigned long layersOf(const Pass& pass) {
        unsigned long sum = 0;
        for (const Block& b : pass.blocks) sum += b.samples;
        return sum;
    }

    const Context& context_;
    Tracer& tracer_;
    Film& film_;
    Profile& profile_;
    const RenderControl& control_;
    const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    Buffer blocks_;
    Buffer splats_;                         ///< what the light paths of a pass add
    struct Traced { unsigned samples; unsigned long layers; };
    std::deque<Traced> traced_;             ///< passes in progress: the samples that they add to every pixel, and the layers still to trace
    bool stopped_ = false;
    bool isPlanned_ = false;                ///< adaptive sampling has planned the samples
    std::vector<unsigned> planned_;         ///< as for RenderControl::pause
    unsigned samples_ = 0;                  ///< samples that every pixel has
    double pixels_ = 0;
    double pathsBefore_ = 0, paths_ = 0, allPaths_ = 0;   ///< traced before, so far, and expected in total
};

}  // namespace

RenderResult render(const Context& context, Tracer& tracer, Film& film, Profile& profile, const RenderControl& control) {
    return Rendering(context, tracer, film, profile, control).run();
}

}  // namespace eikonal
