#include "app/render_scene.h"

#include "render/render.h"
#include "image/atomic_file.h"
#include "image/image_file.h"
#include "available_memory.h"
#include "app/checkpoint.h"
#include "app/deadline.h"
#include "clock.h"
#include "app/error_log.h"
#include "app/interrupt.h"
#include "app/progress_display.h"
#include "app/output.h"
#include "app/render_jobs.h"
#include "app/render_output.h"
#include "app/run_summary.h"
#include "messages.h"
#include "printable.h"
#include "render/render_identity.h"
#include "render/session.h"
#include "app/statistics.h"
#include "standard_stream.h"
#include "app/watching.h"
#include "eikonal/film.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <optional>

namespace eikonal {
namespace {

/// Renders until each pixel has the samples `samples`, the error is small enough, the time is over, or a signal arrives.
RenderResult renderFilm(const Options& o, Session& session, Film& film, SampleRange samples, Deadline& deadline, Checkpoints& checkpoints,
                        RenderOutput& output, ErrorLog& errors, Watching& watching) {
    const auto error = [&] { return std::optional(film.totals().error(o.output.errorMetric)); };
    ProgressDisplay display({samples.length(), o.output.errorMetric, error, o.place}, showsProgress(o.log));
    RenderControl control;
    control.endSample = samples.end;
    control.targetError = o.output.targetError;
    control.errorMetric = o.output.errorMetric;
    control.planned = checkpoints.planned();
    const Stopwatch time;
    control.progress = [&](Progress p) {
        p = watching.withoutPauses(p);
        deadline.isWhole = p.samples > 0;
        if (const auto limit = deadline.secondsLeft()) p.secondsLeft = std::min(p.secondsLeft.value_or(*limit), *limit);
        display.show(p);
        if (p.samples > 0) errors.note(p.samples, film, output);
        watching.show(p, session, film, output);
    };
    control.pause = [&](std::span<const unsigned> planned) {
        const double seconds = time.seconds() - watching.pausedSeconds();
        checkpoints.pause(film, planned, seconds, output);
        watching.obey(session, film, planned, seconds, checkpoints, output, [&] { return deadline.isOver(); });
    };
    control.stop = [&] {
        watching.passOnStop();
        return deadline.isOver();
    };
    control.abandon = [&] {
        watching.passOnStop();
        return deadline.isFinal();
    };
    control.dropped = [&](const RenderDevice& device, const DeviceError& error) { session.drop(device, error); };
    const std::vector<RenderDevice> devices = session.renderDevices();
    RenderResult result = render(devices, film, control);
    session.joinProfiles();
    display.end(result.isFinished);
    return result;
}

/// Why a render has ended before all samples were taken, and which are there.
std::string describeShortfall(const FilmTotals::Samples& samples, unsigned wanted, const std::string& ending) {
    return fmt::format(
        "{}: {} of {} samples per pixel", ending,
        samples.fewest == samples.most ? fmt::format("{}", samples.fewest) : fmt::format("{} to {}", samples.fewest, samples.most), wanted);
}

/// Reports why the image has fewer samples (`partial`) or more error than asked for, and which samples were not finite.
void reportShortfall(const Options& o, const std::string& partial, const FilmTotals::Invalid& invalid, const RenderResult& result,
                     unsigned wanted, Diagnostics& diagnostics) {
    if (!partial.empty()) tellResult(partial, o.log);
    else if (result.error && *result.error > *o.output.targetError)
        tell(LogLevel::warning,
             fmt::format("the error is more than {:g} %: a pixel gets at most {} samples; increase --spp", 100 * *o.output.targetError,
                         wanted),
             o.log);
    if (invalid.count)
        diagnostics.warn(
            {}, fmt::format("{} sample{} not finite or brighter than {:.0e}, and count{} as black; the first is in pixel ({}, {})",
                            invalid.count, invalid.count == 1 ? " was" : "s were", MOST_RADIANCE, invalid.count == 1 ? "s" : "", invalid.x,
                            invalid.y));
}

/// Warns if a deadline cannot be met any more, just before rendering.
void warnOfDeadline(const Deadline& deadline, const Session& session, Diagnostics& diagnostics) {
    if (deadline.missedBy() <= 0) return;
    const std::string kernels = session.compiledStages()
                                    ? fmt::format(", {:.1f} s of it for compiling kernels, which are kept for the next time",
                                                  session.times().compile)
                                    : "";
    diagnostics.warn({}, fmt::format("the deadline will be missed by {:.1f} s or more: rendering begins {:.1f} s after the program{}",
                                     deadline.missedBy(), secondsSinceStart(), kernels));
}

/// Warns, once, if the frames of a scene are all the same.
void warnOfStillness(const Options& o, const PackedScene& packed, Diagnostics& diagnostics) {
    const bool moves = packed.features.has(Feature::MOTION) || packed.features.has(Feature::CAMERA_MOTION);
    if (o.scene.fps && !moves && o.place.number == 1) diagnostics.warn({}, "--fps: nothing moves in this scene, so its frames are equal");
}

/// Throws an error if the film and the output image would not fit into memory, because a process killed for memory loses the whole render.
void checkMemory(const FilmDescription& film, const PackedScene& packed, const MemoryPlan& plan) {
    const size_t needed = plan.tables + plan.queues + plan.vertices + plan.film + plan.image, available = availableMemory();
    if (needed <= available) return;
    const std::string buckets = film.spectrum ? fmt::format(" with spectra of {} buckets", film.spectrum->buckets) : "";
    throw SceneError(
        film.spectrum ? film.where : SourceLocation{},
        fmt::format("{} x {} pixels{} need {} of memory, and {} are available; render parts with --pixelbounds, which join exactly",
                    packed.pixels.width(), packed.pixels.height(), buckets, readableBytes(static_cast<double>(needed)),
                    readableBytes(static_cast<double>(available))));
}

}  // namespace

static MemoryPlan planOf(const Options& o, const Session& session) {
    MemoryPlan plan = session.plan();
    const PixelRect& pixels = session.packed().pixels;
    if (o.output.denoise) plan.image += Denoiser::bytes(static_cast<size_t>(pixels.width()) * static_cast<size_t>(pixels.height()));
    return plan;
}

/// The samples of each pixel that are rendered, of a render of `wanted`.
static SampleRange samplesToTake(const OutputOptions& out, unsigned wanted) {
    if (!out.samples) return {0, wanted};
    if (const auto* share = std::get_if<SampleShare>(&*out.samples)) {
        if (share->count > leavesOf(wanted))
            throw UsageError(fmt::format("--samples: a pixel has {} samples, {} in a part at least, so they make at most {} part{}, not {}",
                                         wanted, leafSamples, leavesOf(wanted), leavesOf(wanted) == 1 ? "" : "s", share->count));
        return rangeOf(wanted, *share);
    }
    const SampleRange samples = std::get<SampleRange>(*out.samples);
    if (samples.end > wanted)
        throw UsageError(fmt::format("--samples: a pixel has {} samples, so ranges end at {}; give more with --spp", wanted, wanted));
    if (samples.end % leafSamples != 0 && samples.end != wanted)
        throw UsageError(fmt::format("--samples: ranges end at a multiple of {}, like {}, or at the last sample, {}", leafSamples,
                                     leafEnd(samples.end) <= wanted ? leafEnd(samples.end) : leafBegin(samples.end), wanted));
    return samples;
}

/// One scene may not overwrite the image of another.
static void checkIsNew(const std::string& file, const WrittenImages& written) {
    if (const auto before = written.find(file); before != written.end())
        throw Error(ExitCode::scene, fmt::format("cannot write \"{}\": it is the image of {}; -o FOLDER/ names images like their scenes",
                                                 file, before->second));
}

int renderScene(const Options& o, OpenDevices& devices, WrittenImages& written) {
    Diagnostics diagnostics(o.log, o.scene.strict);
    for (const std::string& file : o.output.files) checkWritable(file, 0, o.output.encoding);
    Checkpoints checkpoints(o, diagnostics);
    Watching watching(o, diagnostics);

    Session session(o, diagnostics, o.watch.page, devices);
    session.load();
    devices = session.openDevices();
    const auto wanted = static_cast<unsigned>(session.scene().sampler.pixelSamples);
    if (const auto before = checkpoints.samplesLaidOutFor()) session.layOutFor(*before);
    const std::vector<std::string> files = outputFiles(o.output, session.scene());
    const Aovs aovs = aovsOf(o.output, session.scene().film, files, diagnostics);
    session.pack(aovs, keepsSpectrum(o.output, session.scene().film, files, diagnostics));
    const PackedScene& packed = session.packed();
    warnOfStillness(o, packed, diagnostics);
    if (o.output.tile) session.select(*o.output.tile);
    const SampleRange samples = samplesToTake(o.output, wanted);
    MemoryPlan plan = planOf(o, session);
    checkMemory(session.scene().film, packed, plan);
    for (const std::string& file : files) {
        checkIsNew(file, written);
        checkIsNoInput(file, o.scenes);
        checkIsApart(file, o);
        checkHolds(file, packed.pixels.width(), packed.pixels.height(), o.output.encoding);
        checkWritable(file, plan.film / 2, o.output.encoding);
    }
    if (!o.output.checkpoint.empty()) checkFileWritable(o.output.checkpoint, plan.film / 2);
    const bool isByCost = o.output.tile && o.output.tilesBy == TilesBy::cost;
    if (isByCost) {
        session.prepare();
        session.survey();
        session.selectByCost(*o.output.tile);
        diagnostics.info(fmt::format("by cost, the part has the rows {} to {}", packed.pixels.y0, packed.pixels.y1 - 1));
        plan = planOf(o, session);
        checkMemory(session.scene().film, packed, plan);
    }
    diagnostics.info("planned memory: " + describe(plan));
    RenderOutput output(o, session, files, aovs);
    ErrorLog errors(session.scene().film);
    std::optional<Film> film(std::in_place, packed, packed.features, samples.first);
    checkpoints.resume(session, *film, output);
    if (!isByCost) session.prepare();

    const Interrupt interrupt;
    diagnostics.info(
        fmt::format("rendering {} x {} pixels, {} samples each", packed.pixels.width(), packed.pixels.height(), samples.length()));
    const Stopwatch renderTime;
    Deadline deadline(o.output, plan);
    warnOfDeadline(deadline, session, diagnostics);
    if (!isByCost && std::ranges::min(film->taken()) < samples.end) session.survey([&] { return deadline.isFinal(); });
    watching.begin(session, samples.end);
    const RenderResult result =
        renderFilm(o, session, *film, samples, deadline, checkpoints, output, errors, watching);
    const double renderSeconds = renderTime.seconds() - watching.pausedSeconds();
    /* Also where a limit ended the render just after its last samples */
    const bool isComplete = result.isFinished || (!o.output.targetError && std::ranges::min(film->taken()) >= samples.end);
    /* A signal that arrives while the finished image is written does not count */
    const int endedBy = isComplete ? 0 : Interrupt::signal();
    const std::string ending = endedBy ? "interrupted" : deadline.option() ? fmt::format("ended by {}", deadline.option()) : "";
    const Stopwatch writeTime;
    if (session.profile().paths == 0 && isComplete) tellResult(o.output.checkpoint + " has all samples: nothing is left to render", o.log);
    std::exception_ptr unsaved;  // the image is worth writing all the same
    const bool isFilmNew = !o.output.checkpoint.empty() && session.profile().paths > 0;
    try {
        if (isFilmNew) checkpoints.save(*film, result.planned, renderSeconds);
    } catch (const Error&) { unsaved = std::current_exception(); }
    std::optional<FilmTotals> totals = film->totals();
    ImageReport report = output.report(*totals, checkpoints.secondsBefore() + renderSeconds);
    if (!isComplete) report.metadata.partial = describeShortfall(report.samples, samples.length(), ending);
    reportShortfall(o, report.metadata.partial, totals->invalid(), result, samples.length(), diagnostics);
    const std::string described = describe(report.error, o.output.errorMetric);
    tellResult(described, o.log);
    for (const std::string& doubt : describe(session.implicitDoubts(), session.profile().paths)) diagnostics.warn({}, doubt);

    FilmImage image = output.develop(*totals);
    tellFireflies(report.metadata, image, o.log);
    watching.showLast(image, report.error, checkpoints.secondsBefore() + renderSeconds);
    warnOfClamping(image, o.output.encoding, session.scene().film.where, diagnostics);
    RunSummary summary;
    if (o.json) summary.identity = identityOf(session, o, *film);
    totals.reset();  // frees what may be most of the memory in use
    film.reset();
    output.write(std::move(image), report.metadata);
    const double writeSeconds = writeTime.seconds();
    std::vector<std::string> names;
    for (const std::string& file : files) names.push_back(isStandardStream(file) ? "standard output" : file);
    if (isFilmNew && !unsaved) names.push_back(checkpoints.path());
    if (!names.empty()) tellResult(fmt::format("wrote {} in {:.1f} s", fmt::join(names, " and "), session.seconds()), o.log);
    for (const std::string& file : files) written.emplace(file, jobName(o.scene));
    if (o.output.stats)
        std::fputs(printable(describeRun(session, session.profile(), report.samples, described, renderSeconds, writeSeconds)).c_str(),
                   stdout);
    const int status = endedBy ? signalStatus + endedBy : static_cast<int>(isComplete ? ExitCode::success : ExitCode::partialImage);
    if (o.json) {
        summary.files = files;
        summary.frame = o.scene.frame;
        const bool hasFilm = isFilmNew || (!o.output.checkpoint.empty() && report.samples.fewest > 0);
        if (hasFilm && !unsaved) summary.checkpoint = checkpoints.path();
        summary.isComplete = isComplete;
        summary.endedBy = endedBy;
        summary.status = unsaved || output.undenoised() ? static_cast<int>(ExitCode::scene) : status;
        summary.metadata = report.metadata;
        summary.samples = report.samples;
        summary.writeSeconds = writeSeconds;
        summary.warnings = diagnostics.warnings();
        std::fputs(describeAsJson(session, summary).c_str(), stdout);
    }
    std::fflush(stdout);   // the page may stay for long
    watching.end(result.isFinished ? "finished" : ending, names);
    if (unsaved) std::rethrow_exception(unsaved);
    if (output.undenoised()) std::rethrow_exception(output.undenoised());
    return status;
}

}  // namespace eikonal
