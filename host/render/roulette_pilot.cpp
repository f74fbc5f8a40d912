#include "render/roulette_pilot.h"

#include "pack/pack.h"
#include "render/pilot.h"
#include "render/roulette.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace eikonal {
namespace {

/// Sets per pixel: consecutive parts of the pixel's sample sequence, each of low discrepancy. Because they complement one another, they
/// differ slightly more than renders with different seeds.
constexpr size_t pilotSets = 4;
/// Whether paths can be long enough for roulette.
bool playsRoulette(const PackedScene& packed) {
    const Features& f = packed.features;
    return packed.frame().max_depth > 1 && !f.has(Feature::RAY_SPLITTING) && !f.has(Feature::AMBIENT_OCCLUSION);
}

/// Number of pilot pixels, and of samples in each of their sets.
struct PilotSize {
    size_t pixels, samples;
    double renderedPaths;   ///< paths of the whole render
    static PilotSize of(const PackedScene& packed) {
        constexpr double share = 0.005;
        constexpr size_t mostSamples = 64, mostPaths = 1 << 16;
        const size_t samples = std::min<size_t>(static_cast<size_t>(packed.samples), mostSamples);
        const double renderedPaths = packed.paths();
        return {std::min(static_cast<size_t>(renderedPaths * share), mostPaths) / (pilotSets * samples), samples, renderedPaths};
    }
    /// Whether the pilot has enough pixels to be meaningful and takes only a few percent of the render time (its launches are small).
    bool isWorthwhile() const { return pixels >= 64 && renderedPaths >= 0x1p20; }
};

/// White light that is as bright in the image as the film's limit of a sample; 0: there is no limit.
float mostLight(const settings& frame) {
    const affine& m = frame.image_from_light;
    return frame.max_component_value / std::max({m.xx + m.xy + m.xz, m.yx + m.yy + m.yz, m.zx + m.zy + m.zz});
}

/// Not a seed that a user is likely to choose.
constexpr uint pilotSeed = 0x70696c6f;

/// The throughputs on which roulette is based (kernels/shade/scatter.clh).
std::vector<float> readThroughputs(const Context& context, const QueueItems& rays) {
    std::vector<float> t = readSpectra(context, rays, "beta", [](float most, float x) { return std::max(most, x); });
    if (hasField(rays, "eta_scale")) std::ranges::transform(t, readField<float>(context, rays, "eta_scale"), t.begin(), std::multiplies());
    if (hasField(rays, "r_u"))
        std::ranges::transform(t, readMeans(context, rays, "r_u"), t.begin(), [](float a, float b) { return a / std::max(b, 1e-30f); });
    return t;
}

/// Records the paths of one batch after another.
class Recorder : public PilotRecorder {
public:
    /// mostLight: paths are clamped to this, as by the film's maxcomponentvalue; 0: no clamping.
    Recorder(const Context& context, float mostLight)
        : context_(context), mostLight_(mostLight > 0 ? mostLight : std::numeric_limits<float>::max()) {}

    void begin(unsigned paths) override {
        recorded_.insert(recorded_.end(), paths, {PathSegment{}});
        light_.assign(paths, 0);
        depths_.assign(paths, 0);
        bounces_ = 0;
    }

    /// Records the light of a bounce and the rays that continue. Returns false after the last bounce to record.
    bool bounced(const Bounced& bounce) override {
        const QueueItems &rays = bounce.rays, &paths = bounce.paths;
        std::vector<PathSegment>* recorded = &recorded_[recorded_.size() - paths.count];
        const std::vector<float> light = readMeans(context_, paths, "L");
        for (size_t p = 0; p < paths.count; ++p) {
            if (!std::isfinite(light[p])) continue;
            const float sum = std::min(light[p], mostLight_);
            recorded[p].back().light += sum - light_[p];
            light_[p] = sum;
        }
        const std::vector<uint> path = readField<uint>(context_, rays, "path"), depth = readField<uint>(context_, rays, "depth");
        const std::vector<float> end = readField<float>(context_, rays, "t_max"), throughput = readThroughputs(context_, rays);
        for (size_t i = 0; i < rays.count; ++i) {
            if (end[i] < 0) continue;
            const size_t p = path[i] - paths.first;
            /* There is no roulette decision at a null interface, where depth stays the same */
            if (depth[i] > depths_[p]) {
                recorded[p].back().throughput = throughput[i];
                recorded[p].push_back({});
                depths_[p] = depth[i];
            }
            recorded[p].back().rays += 1;
        }
        return ++bounces_ < mostPilotBounces;
    }

    std::vector<std::vector<PathSegment>> take() { return std::move(recorded_); }

private:
    const Context& context_;
    float mostLight_;
    std::vector<std::vector<PathSegment>> recorded_;
    std::vector<float> light_;
    std::vector<uint> depths_;
    int bounces_ = 0;
};

}  // namespace

std::optional<Roulette> pilotRoulette(const Context& context, DeviceScene& scene, const PackedScene& packed, Wave& wave) {
    const PilotSize size = PilotSize::of(packed);
    if (packed.roulette || !size.isWorthwhile() || !playsRoulette(packed)) return {};
    const settings frame = pilotFrame(packed.frame(), pilotSeed);
    scene.setFrame(context, frame);
    Recorder recorder(context, mostLight(frame));
    tracePilot(frame, scatterPixels(frame, size.pixels, pilotSets * size.samples), wave, recorder);
    if (wave.stopFlag().isRaised()) {
        scene.setFrame(context, packed.frame());
        return {};
    }
    const Roulette chosen = chooseRoulette({pilotSets, size.samples, recorder.take()});
    settings chosenFrame = packed.frame();
    setRoulette(chosenFrame, chosen);
    scene.setFrame(context, chosenFrame);
    return chosen;
}

}  // namespace eikonal
