#include "commands/clock.h"
#include "commands/commands.h"
#include "commands/interrupt.h"
#include "commands/output.h"
#include "commands/progress_bar.h"
#include "commands/session.h"
#include "commands/statistics.h"

#include <fmt/format.h>

#include <cstdio>

namespace eikonal {
namespace {

/// Everything that can go wrong with the files later, found before any work.
void checkFiles(const std::vector<std::string>& files, const Scene& scene) {
    constexpr std::uint64_t bytesPerPixel = 16;
    for (const std::string& file : files)
        checkWritable(file, static_cast<std::uint64_t>(scene.film.width) * static_cast<std::uint64_t>(scene.film.height) * bytesPerPixel);
}

Metadata metadataOf(const Options& o, const Session& session, unsigned samples, double seconds) {
    Metadata m;
    m.samples = static_cast<int>(samples);
    m.renderSeconds = seconds;
    m.seed = session.scene().sampler.seed;
    m.version = "Eikonal " EIKONAL_VERSION;
    m.scene = o.scene.path;
    m.sceneHash = sceneHash(session.packed());
    m.device = session.context().device().name;
    m.commandLine = o.commandLine;
    return m;
}

/// Says what the image lacks, if it lacks anything.
void reportShortfall(const Film& film, const Session& session, Diagnostics& diagnostics, bool interrupted) {
    const auto [fewest, most] = film.samples();
    const auto wanted = static_cast<unsigned>(session.packed().samples);
    if (fewest < wanted && !interrupted)
        diagnostics.warn({}, fmt::format("--time-limit ended the render: {} samples a pixel of {}", fewest == most ? fmt::format("{}", fewest) : fmt::format("{} to {}", fewest, most), wanted));
    if (interrupted) diagnostics.warn({}, fmt::format("interrupted: the image has {} to {} samples a pixel of {}", fewest, most, wanted));
    const Film::Invalid invalid = film.invalid();
    if (invalid.count)
        diagnostics.warn({}, fmt::format("{} sample{} not finite and count as black; the first is in pixel ({}, {})", invalid.count, invalid.count == 1 ? " was" : "s were", invalid.x, invalid.y));
}

}  // namespace

int renderCommand(const Options& o) {
    Diagnostics diagnostics(o.log, o.scene.strict);
    prepareOpenCl(o.device);
    for (const std::string& file : o.output.files) checkWritable(file);

    Session session(o, diagnostics);
    session.load();
    const std::vector<std::string> files = outputFiles(o.output, session.scene());
    checkFiles(files, session.scene());
    session.pack(o.output.aovs.albedo || o.output.aovs.normal || o.output.aovs.depth);
    diagnostics.info("memory: " + describe(session.plan()));
    session.prepare();

    const PackedScene& packed = session.packed();
    Film film(static_cast<int>(packed.frame().width), static_cast<int>(packed.frame().height), packed.pixels, packed.features);
    const Stopwatch renderTime;
    Interrupt interrupt;
    {
        ProgressBar bar(static_cast<unsigned>(packed.samples), o.log < LogLevel::warning);
        unsigned samples = 0;
        RenderControl control;
        control.endSample = static_cast<unsigned>(packed.samples);
        control.progress = [&](const Progress& p) { samples = p.samples; bar.show(p); };
        control.stop = [&] { return Interrupt::signal() || (o.output.timeLimit && samples > 0 && renderTime.seconds() > *o.output.timeLimit); };
        render(session.context(), session.wave(), film, session.shape(), session.profile(), control);
    }
    const double renderSeconds = renderTime.seconds();
    const int signal = Interrupt::signal();
    reportShortfall(film, session, diagnostics, signal != 0);

    const Stopwatch writeTime;
    FilmImage image = film.develop(packed.worldScale);
    selectAovs(image, o.output.aovs);
    const Metadata metadata = metadataOf(o, session, film.samples().fewest, renderSeconds);
    for (const std::string& file : files) writeImage(file, image, metadata, o.output.toneMapping);
    if (o.log >= LogLevel::warning) std::fputs(fmt::format("wrote {} in {:.1f} s\n", fmt::join(files, " and "), session.times().firstRay + renderSeconds + writeTime.seconds()).c_str(), stderr);
    if (o.output.stats) std::fputs(describeRun(session, session.profile(), renderSeconds, writeTime.seconds()).c_str(), stdout);
    return signal ? 128 + signal : static_cast<int>(ExitCode::success);
}

}  // namespace eikonal
