#include "clock.h"
#include "app/commands.h"
#include "app/efficiency.h"
#include "json_text.h"
#include "render/session.h"
#include "app/statistics.h"
#include "app/bandwidth.h"
#include "image/atomic_file.h"
#include "image/image_file.h"
#include "image/seed_variance.h"
#include "render/render.h"
#include "median.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace eikonal {
namespace {

struct Repeat { double seconds; std::map<std::string, StageProfile> stages; std::uint64_t rays, shadowRays, paths; };

/// Also adds the image to `images`, unless that is null.
Repeat renderOnce(Session& session, Tracer& tracer, Profile& profile, SeedVariance* images = nullptr) {
    const PackedScene& packed = session.packed();
    Film film(packed);
    RenderControl control;
    control.endSample = static_cast<unsigned>(packed.samples);
    profile.reset();
    const Stopwatch time;
    session.survey();
    render(std::vector{RenderDevice{&session.context(), &tracer, &profile}}, film, control);
    const double seconds = time.seconds();
    profile.collect();
    if (images) images->add(film.totals().develop(packed));
    return {seconds, profile.stages(), profile.rays, profile.shadowRays, profile.paths};
}

template <class F> double medianOf(const std::vector<Repeat>& repeats, F&& f) {
    std::vector<double> values;
    for (const Repeat& r : repeats) values.push_back(f(r));
    return median(values);
}

/// Occupancy of a stage: the share of the slots that it ran over that held a real ray, path or pixel. 1 for the dense queues of shading.
double occupancyOf(const StageProgram& stage, const Repeat& r, std::uint64_t slots) {
    const auto share = [](std::uint64_t real, std::uint64_t all) { return all ? static_cast<double>(real) / static_cast<double>(all) : 1; };
    /* Rays and shadow rays of light paths are counted with the others, so these shares are means over both */
    const auto slotsOf = [&](StageName name) {
        const auto found = r.stages.find(rowOf(name).name);
        return found == r.stages.end() ? std::uint64_t{0} : found->second.slots;
    };
    switch (stage.over) {
        case each_sample: return share(r.paths, slots);
        case each_ray:
        case each_intersection: return share(r.rays, slotsOf(StageName::intersect_rays));
        case each_shadow: return share(r.shadowRays, slotsOf(StageName::test_shadows) + slotsOf(StageName::splat_shadows));
        case each_pixel: return share(r.paths, r.stages.at(rowOf(StageName::generate_rays).name).slots);  // of the same blocks
        default: return 1;
    }
}

double medianSeconds(const std::vector<Repeat>& repeats) {
    return medianOf(repeats, [](const Repeat& r) { return r.seconds; });
}

nlohmann::ordered_json measure(const Options& o, const Session& session, const std::vector<Repeat>& repeats,
                               const std::vector<Repeat>& loops, double copyRate) {
    const Repeat& first = repeats.front();
    const double seconds = medianSeconds(repeats);
    nlohmann::ordered_json json{{"scene", o.scene.path},
                                {"sceneHash", sceneHash(session.packed())},
                                {"device", session.context().device().name},
                                {"version", EIKONAL_VERSION},
                                {"samples", session.packed().samples},
                                {"repeats", repeats.size()},
                                {"wavePaths", session.shape().wavePaths},
                                {"localSize", session.shape().localSize},
                                {"itemsPerWorkItem", session.shape().itemsPerWorkItem}};
    const SessionTimes& t = session.times();
    json["loadSeconds"] = t.load;
    json["packSeconds"] = t.pack;
    json["buildSeconds"] = t.build;
    json["uploadSeconds"] = t.upload;
    json["compileSeconds"] = t.compile;
    json["compiledKernels"] = session.compiledStages();
    json["roulette"] = asOptions(session.roulette());
    json["renderSeconds"] = seconds;
    json["paths"] = first.paths;
    json["rays"] = first.rays;
    json["shadowRays"] = first.shadowRays;
    if (!loops.empty()) json["loopSeconds"] = medianSeconds(loops);
    const auto rate = [&](std::uint64_t n) { return static_cast<double>(n) / seconds; };
    json["pathsPerSecond"] = rate(first.paths);
    json["raysPerSecond"] = rate(first.rays);
    json["shadowRaysPerSecond"] = rate(first.shadowRays);
    json["queueCopyBytesPerSecond"] = copyRate;
    for (const auto& [name, stage] : first.stages) {
        const double stageSeconds = medianOf(repeats, [&, &key = name](const Repeat& r) {
            const auto found = r.stages.find(key);   /* with another seed, nothing may reach a stage */
            return found == r.stages.end() ? 0 : found->second.seconds;
        });
        const double slots = static_cast<double>(stage.slots);
        const StageProgram& program = stageProgram(name);
        const double occupancy = occupancyOf(program, first, stage.slots), bytes = queueBytesPerSlot(program, session.packed().features);
        json["stages"].push_back({{"stage", name},
                                  {"launches", stage.launches},
                                  {"slots", stage.slots},
                                  {"seconds", stageSeconds},
                                  {"nanosecondsPerSlot", slots > 0 ? stageSeconds / slots * 1e9 : 0},
                                  {"occupancy", occupancy},
                                  {"waveFill", slots / (static_cast<double>(stage.launches) * session.shape().wavePaths)},
                                  {"queueBytesPerSlot", bytes},
                                  {"shareOfCopyRate", stageSeconds > 0 ? bytes * slots / stageSeconds / copyRate : 0}});
    }
    for (const Stage& s : session.stages().all())
        json["kernels"].push_back({{"stage", s.name},
                                   {"buildSeconds", s.compileSeconds},
                                   {"firstLaunchSeconds", s.firstLaunchSeconds},
                                   {"cached", s.kernel.program().fromCache}});
    return json;
}

void addEfficiency(nlohmann::ordered_json& json, const std::vector<Repeat>& repeats, const SeedVariance& images,
                   const FilmImage* reference) {
    std::vector<double> seconds;
    for (const Repeat& r : repeats) seconds.push_back(r.seconds);
    constexpr double outliers = 0.001;
    const Estimate variance = images.relativeVariance(reference);
    const Efficiency efficiency = efficiencyOf(variance, seconds);
    json["relativeVariance"] = variance.value;
    json["relativeVarianceStandardError"] = variance.standardError;
    json["relativeVarianceWithoutOutliers"] = images.relativeVariance(reference, outliers).value;
    json["efficiency"] = efficiency.value;
    json["efficiencyInterval"] = {efficiency.low, efficiency.high};
}

std::string asTable(const nlohmann::ordered_json& j) {
    std::string text = fmt::format("{} on {}\nmedian of {} renders of {} samples: {:.3f} s; {:.2f} M paths/s\n",
                                   j["scene"].get<std::string>(), j["device"].get<std::string>(), j["repeats"].get<int>(),
                                   j["samples"].get<int>(), j["renderSeconds"].get<double>(), j["pathsPerSecond"].get<double>() * 1e-6);
    text += fmt::format("rays {} ({:.2f} M/s), shadow rays {} ({:.2f} M/s); {} kernels compiled in {:.2f} s (not included)\n",
                        j["rays"].get<std::uint64_t>(), j["raysPerSecond"].get<double>() * 1e-6, j["shadowRays"].get<std::uint64_t>(),
                        j["shadowRaysPerSecond"].get<double>() * 1e-6, j["compiledKernels"].get<int>(), j["compileSeconds"].get<double>());
    if (j.contains("efficiency"))
        text += fmt::format(
            "relative variance between seeds {:.4g} +- {:.2g} ({:.4g} without the worst thousandth of the pixels); efficiency 1 / "
            "(variance x seconds) {:.4g}, 95 % within {:.4g} to {:.4g}\n",
            j["relativeVariance"].get<double>(), j["relativeVarianceStandardError"].get<double>(),
            j["relativeVarianceWithoutOutliers"].get<double>(), j["efficiency"].get<double>(), j["efficiencyInterval"][0].get<double>(),
            j["efficiencyInterval"][1].get<double>());
    text += fmt::format("{:<28}{:>9}{:>13}{:>10}{:>9}{:>11}{:>11}{:>8}{:>14}{:>12}\n", "stage", "launches", "slots", "seconds", "share",
                        "ns/slot", "occupancy", "fill", "bytes/slot", "of copying");
    double all = 0;
    for (const auto& s : j["stages"]) all += s["seconds"].get<double>();
    for (const auto& s : j["stages"])
        text += fmt::format("{:<28}{:>9}{:>13}{:>10.3f}{:>8.1f}%{:>11.1f}{:>10.1f}%{:>7.1f}%{:>14.0f}{:>11.0f}%\n",
                            s["stage"].get<std::string>(), s["launches"].get<std::uint64_t>(), s["slots"].get<std::uint64_t>(),
                            s["seconds"].get<double>(), s["seconds"].get<double>() / std::max(all, 1e-12) * 100,
                            s["nanosecondsPerSlot"].get<double>(), s["occupancy"].get<double>() * 100, s["waveFill"].get<double>() * 100,
                            s["queueBytesPerSlot"].get<double>(), s["shareOfCopyRate"].get<double>() * 100);
    text += fmt::format("{:<28}{:>32.3f}, of {:.3f} s of wall clock; a queue is copied at {:.1f} GB/s\n", "all stages", all,
                        j["renderSeconds"].get<double>(), j["queueCopyBytesPerSecond"].get<double>() * 1e-9);
    if (j.contains("loopSeconds"))
        text += fmt::format("one kernel with a loop: {:.3f} s, {:.2f} times the time of the stages\n", j["loopSeconds"].get<double>(),
                            j["loopSeconds"].get<double>() / j["renderSeconds"].get<double>());
    return text;
}

/// Reads a converged image of the pixels that are rendered. Throws an Error (ExitCode::scene) if its pixels do not match or it is black or
/// not finite.
FilmImage readReference(const std::string& file, const PackedScene& packed) {
    FilmImage image = readImage(file).image;
    const PixelRect& p = packed.pixels;
    const PixelBounds& b = image.bounds;
    if (static_cast<uint>(image.width) != packed.frame().width || static_cast<uint>(image.height) != packed.frame().height ||
        b.x0 != p.x0 || b.x1 != p.x1 || b.y0 != p.y0 || b.y1 != p.y1)
        throw Error(ExitCode::scene,
                    fmt::format("--reference: \"{}\" has the pixels {},{} to {},{} of {} x {}; the render has {},{} to {},{} of {} x {}",
                                file, b.x0, b.y0, b.x1, b.y1, image.width, image.height, p.x0, p.y0, p.x1, p.y1, packed.frame().width,
                                packed.frame().height));
    glm::dvec3 sum(0);
    for (const glm::vec3& c : image.color) sum += glm::dvec3(c);
    if (!std::isfinite(sum.x + sum.y + sum.z) || !(sum.x + sum.y + sum.z > 0))
        throw Error(ExitCode::scene,
                    fmt::format("--reference: \"{}\" is black or has pixels that are not finite, so relative errors are undefined", file));
    return image;
}

}  // namespace

int benchCommand(const Options& o) {
    Diagnostics diagnostics(o.log, o.scene.strict);
    if (!o.jsonFile.empty()) checkFileWritable(o.jsonFile, 0);
    Session session(o, diagnostics, true);
    session.load();
    if (session.openDevices().size() > 1) throw UsageError("--device: bench measures one device at a time; name one");
    session.pack({});
    const std::optional<FilmImage> reference =
        o.reference.empty() ? std::nullopt : std::optional(readReference(o.reference, session.packed()));
    if (o.loop && session.packed().features.has(Feature::LIGHT_PATHS))
        throw UsageError("--loop: the loop follows no paths from lights; use another --integrator, like volpath");
    session.prepare();
    session.survey();   // a path guide that does not pay is dropped here, and with it the kernels and the wave
    std::vector<Repeat> repeats, loops;
    Profile loopProfile;
    const std::unique_ptr<Tracer> loop = o.loop ? session.makeLoop(loopProfile) : nullptr;
    if (loop) renderOnce(session, *loop, loopProfile);   // some implementations compile at the first launch
    SeedVariance images;
    for (int i = 0; i < o.repeats; ++i) {
        if (o.efficiency) session.setSeed(session.scene().sampler.seed + i);
        repeats.push_back(renderOnce(session, session.wave(), session.profile(), o.efficiency ? &images : nullptr));
        if (loop) loops.push_back(renderOnce(session, *loop, loopProfile));
    }
    Compiler compiler(session.context(), findKernelFolders(), cacheFolderFor(o.device));
    nlohmann::ordered_json json = measure(o, session, repeats, loops, queueCopyRate(session.context(), compiler, session.shape()));
    if (o.efficiency) addEfficiency(json, repeats, images, reference ? &*reference : nullptr);
    std::fputs(asTable(json).c_str(), stdout);
    if (!o.jsonFile.empty()) writeTextAtomically(o.jsonFile, jsonText(json, 2) + "\n");
    return static_cast<int>(ExitCode::success);
}

}  // namespace eikonal
