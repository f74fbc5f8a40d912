#include "app/watching.h"

#include "app/interrupt.h"
#include "app/render_jobs.h"
#include "clock.h"
#include "messages.h"
#include "names.h"

#include <fmt/format.h>

#include <algorithm>

#include <unistd.h>

namespace eikonal {
namespace {

/// Making images for those who watch takes at most this share of the render's time, and they come no closer than this, in seconds.
constexpr double shareForImages = 0.005, secondsBetweenImages = 0.25;

NamedSeconds stepsOf(const SessionTimes& t) {
    return {{"open the device", t.device},        {"read the scene", t.load},         {"fill the tables", t.pack},
            {"build the hierarchies", t.build},   {"compile the kernels", t.compile}, {"upload the tables", t.upload},
            {"launch each kernel once", t.launch}};
}

}  // namespace

Watching::Watching(const Options& options, Diagnostics& diagnostics) : options_(options) {
    const WatchOptions& watch = options.watch;
    if (watch.display)
        display_.emplace(*watch.display, fmt::format("{} ({})", jobName(options.scene), ::getpid()),
                         [&diagnostics](const std::string& problem) { diagnostics.warn({}, problem); });
    if (!watch.page) return;
    page_.emplace(watch, options.output.encoding.toneMapping());
    page_->render().update([&](LiveState& state) {
        state.scene = options.scene.path;
        state.metric = nameIn(errorMetricNames, options.output.errorMetric);
        state.targetError = options.output.targetError;
    });
    tell(LogLevel::error, "view: " + page_->url());  // also with --quiet, because nothing else tells the token
}

void Watching::begin(const Session& session, unsigned samples) {
    if (!page_) return;
    page_->render().update([&](LiveState& state) {
        state.phase = "rendering";
        state.samplesInAll = samples;
        state.steps = stepsOf(session.times());
    });
}

void Watching::showFilm(Session& session, const Film& film, double seconds, const RenderOutput& output) {
    const FilmTotals totals = film.totals();
    const auto image = std::make_shared<const FilmImage>(output.develop(totals, page_.has_value()));
    if (display_) display_->show(image);
    if (!page_) return;
    session.profile().collectFinished();
    page_->render().update([&](LiveState& state) {
        state.stages.clear();
        for (const auto& [name, stage] : session.profile().stages()) state.stages.emplace_back(name, stage.seconds);
    });
    page_->render().showImage(image, totals.error(options_.output.errorMetric), seconds);
}

void Watching::show(const Progress& progress, Session& session, const Film& film, const RenderOutput& output) {
    if (!isOn()) return;
    if (page_)
        page_->render().note([&](LiveState& state) {
            state.fraction = progress.fraction;
            state.seconds = progress.seconds;
            state.secondsLeft = progress.secondsLeft;
            state.samples = progress.meanSamples;
        });
    if (progress.seconds < due_) return;
    const Stopwatch time;
    showFilm(session, film, progress.seconds, output);
    due_ = progress.seconds + std::max(secondsBetweenImages, time.seconds() / shareForImages);
}

void Watching::obey(Session& session, const Film& film, std::span<const unsigned> planned, double seconds, Checkpoints& checkpoints,
                    RenderOutput& output, const std::function<bool()>& isOver) {
    if (!page_) return;
    LiveRender& render = page_->render();
    const auto save = [&] {
        if (!render.takeSave()) return;
        const std::string problem = checkpoints.writeAll(film, planned, seconds, output);
        render.update([&](LiveState& state) {
            state.problem = problem;
            state.saves += problem.empty();
        });
    };
    save();
    if (render.isPaused()) showFilm(session, film, seconds, output);
    pausedSeconds_ += render.waitWhilePaused(save, isOver);
}

void Watching::passOnStop() const {
    if (page_ && page_->render().isStopAsked()) Interrupt::request();
}

Progress Watching::withoutPauses(Progress progress) const {
    if (pausedSeconds_ == 0) return progress;
    const double seconds = std::max(progress.seconds - pausedSeconds_, 0.0);
    if (progress.secondsLeft && progress.seconds > 0) *progress.secondsLeft *= seconds / progress.seconds;
    progress.seconds = seconds;
    return progress;
}

void Watching::showLast(const FilmImage& image, const ErrorEstimate& error, double seconds) {
    if (!isOn()) return;
    const auto last = std::make_shared<const FilmImage>(image);
    if (display_) display_->show(last);
    if (page_) page_->render().showImage(last, error, seconds);
}

void Watching::end(const std::string& how, const std::vector<std::string>& files) {
    if (!page_) return;
    LiveRender& render = page_->render();
    const bool isSignalled = Interrupt::signal() && !render.isStopAsked();
    render.update([&](LiveState& state) {
        state.phase = how;
        state.hasEnded = true;
        state.files = files;
    });
    if (options_.watch.waits && !isSignalled) render.waitForEnd([&] { return Interrupt::signal() && !render.isStopAsked(); });
    else render.waitForLastLook();
}

}  // namespace eikonal
