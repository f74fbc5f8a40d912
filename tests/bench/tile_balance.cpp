// How well --tiles-by balances the parts of an image: the processor time of rendering the dearest of N parts over the mean of all, with
// parts of equal rows and of equal cost. Starting is not counted, nor is the pilot that estimates costs, whose time is a column of its own.
//
//     tile_balance --resolution 320x192 --spp 64 scenes/hero.pbrt ../shared/scenes/coffee/scene-v4.pbrt
//
// On one thread of PoCL's processor device; each part is rendered some times, in turns, and the fastest time counts, since other work on
// the machine only ever adds to it.

#include "film/film.h"
#include "render/render.h"
#include "render/session.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <numeric>

namespace eikonal {
namespace {

struct BenchOptions {
    std::vector<std::string> scenes;
    std::array<int, 2> resolution{320, 192};
    int spp = 64, parts = 8, repeats = 3;
    std::string json;
};

double processorSeconds() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Balance { double dearestByRows, dearestByCost, meanByRows, meanByCost, pilot; };

/// The dearest over the mean, and the mean.
std::pair<double, double> balanceOf(const std::vector<double>& times) {
    const double mean = std::accumulate(times.begin(), times.end(), 0.) / static_cast<double>(times.size());
    return {std::ranges::max(times) / mean, mean};
}

Balance measure(const BenchOptions& o, const std::string& scene) {
    SessionOptions options;
    options.scene.path = scene;
    options.scene.spp = o.spp;
    options.scene.resolution = o.resolution;
    options.device.threads = 1;
    Diagnostics diagnostics(LogLevel::error);
    Session session(options, diagnostics);
    session.load();
    session.pack({});
    session.prepare();
    session.survey();
    std::vector<double> times[2];
    for (auto& t : times) t.assign(static_cast<size_t>(o.parts), 1e9);
    double pilot = 1e9;
    RenderControl control;
    control.endSample = static_cast<unsigned>(o.spp);
    for (int repeat = 0; repeat < o.repeats; ++repeat)
        for (int part = 1; part <= o.parts; ++part)
            for (const bool byCost : {false, true}) {
                double before = processorSeconds();
                if (byCost) session.selectByCost({part, o.parts});
                else session.select({part, o.parts});
                if (byCost) pilot = std::min(pilot, processorSeconds() - before);
                Film film(session.packed());
                before = processorSeconds();
                render(session.renderDevices(), film, control);
                double& least = times[byCost][static_cast<size_t>(part - 1)];
                least = std::min(least, processorSeconds() - before);
            }
    const auto [rows, meanRows] = balanceOf(times[false]);
    const auto [cost, meanCost] = balanceOf(times[true]);
    return {rows, cost, meanRows, meanCost, pilot};
}

int run(int count, char** words) {
    BenchOptions o;
    CLI::App app("How well parts of an image are balanced");
    std::string resolution = "320x192";
    app.add_option("scenes", o.scenes, "Scenes")->required();
    app.add_option("--resolution", resolution, "Width and height");
    app.add_option("--spp", o.spp, "Samples per pixel");
    app.add_option("--parts", o.parts, "Parts of the image");
    app.add_option("--repeats", o.repeats, "Renders of each part, of which the fastest counts");
    app.add_option("--json", o.json, "Keep the figures in this file, too");
    CLI11_PARSE(app, count, words);
    if (std::sscanf(resolution.c_str(), "%dx%d", &o.resolution[0], &o.resolution[1]) != 2) return 2;
    fmt::print("| scene | by rows | by cost | mean by rows, s | mean by cost, s | pilot, s |\n|---|--:|--:|--:|--:|--:|\n");
    nlohmann::ordered_json kept;
    for (const std::string& scene : o.scenes) {
        const Balance b = measure(o, scene);
        fmt::print("| {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} |\n", scene, b.dearestByRows, b.dearestByCost, b.meanByRows,
                   b.meanByCost, b.pilot);
        std::fflush(stdout);
        kept["scenes"].push_back({{"scene", scene},           {"by rows", b.dearestByRows},     {"by cost", b.dearestByCost},
                                  {"mean by rows, s", b.meanByRows}, {"mean by cost, s", b.meanByCost}, {"pilot, s", b.pilot}});
        if (!o.json.empty()) std::ofstream(o.json) << kept.dump(1) << '\n';
    }
    return 0;
}

}  // namespace
}  // namespace eikonal

int main(int count, char** words) {
    return eikonal::run(count, words);
}
