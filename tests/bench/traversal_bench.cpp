// How fast the walk down the hierarchy is, against Embree on the same rays and threads, in one run, by turns:
//   traversal_bench [--json] [--device NAME] [--scenes box,terrain-1,ball-1,terrain-5,ball-5] [--batches 1000,1000000] [--repeats 5]
//   [--robust]
// (terrain-5: 5 million triangles; a scene file: its triangles). Prints million rays a second, and two ratios, each the median over the
// repeats: of the time on the clock, and of the processor time of all threads, which others on the machine disturb less.

#include <CLI/CLI.hpp>

#include "tracers.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>

using namespace eikonal;

namespace {

struct Options {
    std::vector<std::string> scenes{"box", "terrain-1", "ball-1", "terrain-5", "ball-5"}, kinds{"primary", "bounced", "shadow"};
    std::vector<size_t> batches{1000, 10000, 100000, 1000000};
    int repeats = 5, width = 1024;
    bool json = false, robust = false, high = false;
    TracerShape shape;
    std::string device;
};

struct Figure { double ours, embree, ratio, low, high, cpuRatio, differ; };

/// On the clock, and of all threads together.
struct Time { double wall, cpu; };

Time measure(const auto& work) {
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t cpuStart = std::clock();
    work();
    return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
            static_cast<double>(std::clock() - cpuStart) / CLOCKS_PER_SEC};
}

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

BenchMesh makeMesh(const std::string& name) {
    if (name.find('.') != std::string::npos) return loadMesh(name);
    const size_t dash = name.find('-');
    const size_t millions = dash == std::string::npos ? 0 : static_cast<size_t>(std::atoi(name.c_str() + dash + 1));
    if (name == "box") return makeBox();
    if (name.starts_with("terrain")) return makeTerrain(millions * 1000000);
    if (name.starts_with("ball")) return makeBall(millions * 1000000);
    throw std::runtime_error("no scene is called " + name + "; try box, terrain-N or ball-N (N million triangles), or a scene file");
}

/* The share of rays on which both disagree: grazing hits, since only ours is watertight */
double shareThatDiffers(const std::vector<BenchHit>& a, const std::vector<BenchHit>& b) {
    size_t differ = 0;
    for (size_t i = 0; i < a.size(); ++i) differ += std::fabs(a[i].t - b[i].t) > 1e-3f * std::max(1e-2f, std::fabs(a[i].t));
    return static_cast<double>(differ) / static_cast<double>(a.size());
}

Figure compare(DeviceTracer& device, const EmbreeTracer& embree, std::vector<BenchRay> rays, bool shadows, size_t batch,
               const Options& options) {
    /* Fewer rays than a batch are no measurement of it; many small batches measure nothing new */
    rays.resize(std::min(rays.size(), std::max<size_t>(batch * 64, 1)));
    batch = std::min(batch, rays.size());
    device.uploadRays(rays, batch, shadows);
    std::vector<BenchHit> reference(rays.size());
    const auto runEmbree = [&] {
        for (size_t first = 0; first < rays.size(); first += batch) {
            const size_t count = std::min(batch, rays.size() - first);
            shadows ? embree.occlude(rays, reference, first, count) : embree.intersect(rays, reference, first, count);
        }
    };
    device.trace();
    runEmbree();
    Figure figure{};
    figure.differ = shareThatDiffers(device.download(), reference);
    /* Long enough to be timed */
    const double once = measure(runEmbree).wall;
    const int times = std::clamp(static_cast<int>(std::ceil(0.15 / once)), 1, 200);
    std::vector<double> ours, theirs, ratios, cpuRatios;
    for (int i = 0; i < options.repeats; ++i) {
        const Time we = measure([&] { for (int k = 0; k < times; ++k) device.trace(); });
        const Time they = measure([&] { for (int k = 0; k < times; ++k) runEmbree(); });
        ours.push_back(we.wall);
        theirs.push_back(they.wall);
        ratios.push_back(they.wall / we.wall);
        cpuRatios.push_back(they.cpu / we.cpu);
    }
    const double count = static_cast<double>(rays.size()) * times * 1e-6;
    figure.ours = count / median(ours);
    figure.embree = count / median(theirs);
    figure.ratio = median(ratios);
    figure.cpuRatio = median(cpuRatios);
    figure.low = *std::min_element(ratios.begin(), ratios.end());
    figure.high = *std::max_element(ratios.begin(), ratios.end());
    return figure;
}

void runScene(const Context& context, const std::string& name, const Options& options, nlohmann::json& report) {
    const BenchMesh mesh = makeMesh(name);
    DeviceTracer device(context, mesh, options.shape);
    const EmbreeTracer embree(mesh, static_cast<int>(context.device().computeUnits), options.robust, options.high);
    const BvhRoot& root = device.root();
    const double triangles = static_cast<double>(mesh.triangles());
    const double bytes =
        (static_cast<double>(root.nodes) * sizeof(bvh_node) + static_cast<double>(root.lines) * sizeof(triangle_line)) / triangles;
    if (!options.json)
        fmt::print(
            "{}: {} triangles, built at {:.2f} M/s (Embree {:.2f}), depth {}, {:.2f} triangles a leaf, {:.2f} children a node, cost "
            "{:.2f}, {:.1f} bytes a triangle\n",
            name, mesh.triangles(), triangles / device.buildSeconds() * 1e-6, triangles / embree.buildSeconds() * 1e-6, root.depth,
            triangles / static_cast<double>(root.leaves),
            static_cast<double>(root.leaves + root.nodes - 1) / static_cast<double>(root.nodes), root.cost, bytes);
    report["scenes"].push_back({{"scene", name},
                                {"triangles", mesh.triangles()},
                                {"build_seconds", device.buildSeconds()},
                                {"embree_build_seconds", embree.buildSeconds()},
                                {"depth", root.depth},
                                {"nodes", root.nodes},
                                {"leaves", root.leaves},
                                {"cost", root.cost},
                                {"bytes_per_triangle", bytes}});
    const std::vector<BenchRay> primary = primaryRays(mesh, options.width, options.width);
    std::vector<BenchHit> hits(primary.size());
    embree.intersect(primary, hits, 0, primary.size());
    for (const std::string& kind : options.kinds) {
        const std::vector<BenchRay> rays = kind == "primary"   ? primary
                                           : kind == "bounced" ? bouncedRays(mesh, primary, hits)
                                                               : shadowRays(mesh, primary, hits);
        for (const size_t batch : options.batches) {
            Figure f = compare(device, embree, rays, kind == "shadow", batch, options);
            report["figures"].push_back({{"scene", name},
                                         {"kind", kind},
                                         {"batch", batch},
                                         {"mrays", f.ours},
                                         {"embree_mrays", f.embree},
                                         {"ratio", f.ratio},
                                         {"ratio_low", f.low},
                                         {"ratio_high", f.high},
                                         {"cpu_ratio", f.cpuRatio},
                                         {"differ", f.differ}});
            if (!options.json)
                fmt::print(
                    "  {:8} {:>8} in flight: {:6.2f} Mray/s, Embree {:6.2f}, ratio {:.2f} ({:.2f} to {:.2f}), of processor time {:.2f}; "
                    "{:.4f} % differ\n",
                    kind, batch, f.ours, f.embree, f.ratio, f.low, f.high, f.cpuRatio, 100 * f.differ);
            std::fflush(stdout);
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app{"Traversal against Embree"};
    app.add_option("--scenes", options.scenes)->delimiter(',');
    app.add_option("--kinds", options.kinds)->delimiter(',');
    app.add_option("--batches", options.batches, "rays in flight")->delimiter(',');
    app.add_option("--repeats", options.repeats);
    app.add_option("--width", options.width, "of the square image of primary rays");
    app.add_option("--local-size", options.shape.localSize);
    app.add_option("--items-per-work-item", options.shape.itemsPerWorkItem, "slots that a work-item handles");
    app.add_option("--interleaved-rays", options.shape.interleavedRays, "rays that a work-item traverses in turns");
    app.add_option("--device", options.device, "as eikonal takes it");
    app.add_flag("--robust", options.robust, "Embree's robust mode, as watertight as ours");
    app.add_flag("--high", options.high, "Embree's spatial splits");
    app.add_flag("--json", options.json);
    CLI11_PARSE(app, argc, argv);

    const Context context(chooseDevice(options.device));
    nlohmann::json report{{"device", context.device().name},
                          {"robust", options.robust},
                          {"local_size", options.shape.localSize},
                          {"items_per_work_item", options.shape.itemsPerWorkItem},
                          {"interleaved_rays", options.shape.interleavedRays}};
    for (const std::string& name : options.scenes) runScene(context, name, options, report);
    if (options.json) fmt::print("{}\n", report.dump(2));
}
