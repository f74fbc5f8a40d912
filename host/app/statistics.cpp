#include "app/statistics.h"

#include "names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace eikonal {

std::string readableBytes(double bytes) {
    constexpr std::array<const char*, 5> units{"B", "KiB", "MiB", "GiB", "TiB"};
    size_t unit = 0;
    while (bytes >= 1024 && unit + 1 < units.size()) { bytes /= 1024; ++unit; }
    return fmt::format("{:.{}f} {}", bytes, unit == 0 ? 0 : 1, units[unit]);
}

static std::string readableBytes(size_t bytes) { return readableBytes(static_cast<double>(bytes)); }

std::string describe(const MemoryPlan& plan) {
    return fmt::format("scene tables {}, queues {},{} film {}", readableBytes(plan.tables), readableBytes(plan.queues),
                       plan.vertices ? fmt::format(" light vertices {},", readableBytes(plan.vertices)) : "", readableBytes(plan.film));
}

size_t mostMemory(const MemoryPlan& plan, const OccupiedMemory& occupied) {
    /* An OpenCL runtime with its compiled kernels, measured */
    constexpr size_t runtime = size_t(75) << 20;
    return runtime + std::max(occupied.most, occupied.now + plan.queues + plan.vertices + plan.film + plan.image);
}

std::string asOptions(const Roulette& roulette) {
    return fmt::format("--roulette {} --roulette-scale {} --roulette-depth {}", nameIn(rouletteRuleNames, roulette.rule), roulette.scale,
                       roulette.depth);
}

std::string describeRun(const Session& session, const Profile& profile, const FilmTotals::Samples& samples, const std::string& error,
                        double renderSeconds, double writeSeconds) {
    const SessionTimes& t = session.times();
    std::string text;
    const auto line = [&](const char* what, double seconds, const std::string& more = {}) {
        text += fmt::format("  {:<28}{:8.3f} s{}{}\n", what, seconds, more.empty() ? "" : "  ", more);
    };
    text += fmt::format("Device: {}\nTime:\n", session.sharesOfDevices());
    line("start the program", t.start);
    line("open the device", t.device, "while the scene is read");
    line("read the scene", t.load);
    line("fill the tables", t.pack, t.displace > 0 ? fmt::format("including {:.3f} s for displaced meshes", t.displace) : "");
    line("build the hierarchies", t.build, "while the kernels are compiled");
    line("compile the kernels", t.compile,
         fmt::format("{} compiled, {} from the cache", session.compiledStages(),
                     static_cast<int>(session.stages().all().size()) - session.compiledStages()));
    if (session.compiledStages() > 0) line("  in worker processes", t.workers);
    for (const Stage& s : session.stages().all()) {
        const Program& program = s.kernel.program();
        text += fmt::format("    {:<26}{:8.3f} s  build {:.3f}, first launch {:.3f}{}\n", s.name, s.compileSeconds + s.firstLaunchSeconds,
                            s.compileSeconds, s.firstLaunchSeconds,
                            program.fromCache ? fmt::format("; cached, compiled in {:.2f} s", program.compileSeconds) : "");
    }
    line("upload the tables", t.upload);
    line("launch each kernel once", t.launch);
    line("write the kernel cache", t.keep);
    line("until the first ray", t.firstRay);
    line("render", renderSeconds);
    line("write the image", writeSeconds);
    const double rays = static_cast<double>(profile.rays), shadowRays = static_cast<double>(profile.shadowRays),
                 paths = static_cast<double>(profile.paths);
    const double seconds = std::max(renderSeconds, 1e-9);
    text += fmt::format(
        "Work:\n  {:.3g} paths ({:.2f} M/s), {:.3g} rays ({:.2f} M/s), {:.3g} shadow rays ({:.2f} M/s), {:.2f} rays per path\n", paths,
        paths / seconds * 1e-6, rays, rays / seconds * 1e-6, shadowRays, shadowRays / seconds * 1e-6, rays / std::max(paths, 1.0));
    text += fmt::format("Russian roulette{}:\n  {}\n", session.isRouletteChosen() ? ", chosen for this scene" : "",
                        asOptions(session.roulette()));
    if (const auto guide = session.triedGuide())
        text += fmt::format("Path guide:\n  {}: by a pilot, the variance without it is {:.2g} times that with it\n",
                            guide->isUsed ? "used" : "not used", guide->gain);
    const ColorChoice& color = session.packed().color;
    text += fmt::format("Colour:\n  {}: {}\n", nameOf(color), color.why);
    const auto [fewest, most, mean] = samples;
    text += fmt::format("Samples per pixel:\n  {} fewest, {:.1f} mean, {} most\n", fewest, mean, most);
    text += fmt::format("Error, estimated:\n  {}\n", error);
    const std::string biased = describe(session.biasedChoices());
    text += fmt::format("Biased choices:\n  {}\n", biased.empty() ? "none" : biased + "; `eikonal trade` measures their bias");
    text += fmt::format("Memory: {}\n", describe(session.plan()));
    return text;
}

}  // namespace eikonal
