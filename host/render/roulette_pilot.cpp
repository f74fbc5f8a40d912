#include "render/roulette_pilot.h"

#include "pack/pack.h"
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
/// Pilot paths are truncated after this many bounces, null interfaces included, to keep the pilot short. Later light and rays are ignored.
constexpr int mostBounces = 24;

/// Not a seed that a user is likely to choose, so that the rule and the image are independent.
constexpr uint pilotSeed = 0x70696c6f;

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
        const double renderedPaths = static_cast<double>(packed.frame().width) * packed.frame().height * packed.samples;
        return {std::min(static_cast<size_t>(renderedPaths * share), mostPaths) / (pilotSets * samples), samples, renderedPaths};
    }
    /// Whether the pilot has enough pixels to be meaningful and takes only a few percent of the render time (its launches are small).
    bool isWorthwhile() const { return pixels >= 64 && renderedPaths >= 0x1p20; }
};

/// Pixels spread over the image by Roberts' low-discrepancy sequence (2018).
std::vector<Block> scatterPixels(const settings& frame, const PilotSize& size) {
    const auto at = [](size_t i, double step, uint extent) {
        return static_cast<int>(std::fmod(0.5 + static_cast<double>(i) * step, 1.) * extent);
    };
    std::vector<Block> blocks;
    for (size_t i = 0; i < size.pixels; ++i)
        blocks.push_back({at(i, 0.7548776662466927, frame.width), at(i, 0.5698402909980532, frame.height), 0,
                          static_cast<unsigned>(pilotSets * size.samples)});
    return blocks;
}

template <class T> std::vector<T> readField(const Context& context, const QueueItems& items, const char* name, int word = 0) {
    std::vector<T> values(items.count);
    if (!items.count) return values;
    const size_t first = static_cast<size_t>(items.layout.field(name).slot + word) * items.capacity + items.first;
    items.words.read(context, values.data(), values.size() * sizeof(T), first * sizeof(T));
    return values;
}

bool hasField(const QueueItems& items, const char* name) { return items.layout.field(name).words > 0; }

/// Reduces each spectrum of a field to one number.
template <class Combine>
std::vector<float> readSpectra(const Context& context, const QueueItems& items, const char* name, Combine&& combine) {
    std::vector<float> all(items.count);
    for (int c = 0; c < items.layout.field(name).words; ++c)
        std::ranges::transform(all, readField<float>(context, items, name, c), all.begin(), combine);
    return all;
}
std::vector<float> readMeans(const Context& context, const QueueItems& items, const char* name) {
    const float channels = static_cast<float>(items.layout.field(name).words);
    return readSpectra(context, items, name, [=](float sum, float x) { return sum + x / channels; });
}

/// The throughputs on which roulette is based (kernels/shade/scatter.clh).
std::vector<float> readThroughputs(const Context& context, const QueueItems& rays) {
    std::vector<float> t = readSpectra(context, rays, "beta", [](float most, float x) { return std::max(most, x); });
    if (hasField(rays, "eta_scale")) std::ranges::transform(t, readField<float>(context, rays, "eta_scale"), t.begin(), std::multiplies());
    if (hasField(rays, "r_u"))
        std::ranges::transform(t, readMeans(context, rays, "r_u"), t.begin(), [](float a, float b) { return a / std::max(b, 1e-30f); });
    return t;
}

/// White light that is as bright in the image as the film's limit of a sample; 0: there is no limit.
float mostLight(const settings& frame) {
    const affine& m = frame.image_from_light;
    return frame.max_component_value / std::max({m.xx + m.xy + m.xz, m.yx + m.yy + m.yz, m.zx + m.zy + m.zz});
}

/// Records the paths of one batch after another.
class Recorder {
public:
    /// mostLight: paths are clamped to this, as by the film's maxcomponentvalue; 0: no clamping.
    Recorder(const Context& context, float mostLight)
        : context_(context), mostLight_(mostLight > 0 ? mostLight : std::numeric_limits<float>::max()) {}

    void begin(unsigned paths) {
        recorded_.insert(recorded_.end(), paths, {PathSegment{}});
        light_.assign(paths, 0);
        depths_.assign(paths, 0);
        bounces_ = 0;
    }

    /// Records the light of a bounce and the rays that continue. Returns false after the last bounce to record.
    bool bounced(const QueueItems& rays, const QueueItems& paths) {
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
        return ++bounces_ < mostBounces;
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

/// Traces blocks of single pixels, in batches that fit the wave.
void record(const settings& frame, std::vector<Block> blocks, Wave& wave, Recorder& recorder) {
    Batches batches(BlockSize{}, std::move(blocks), wave.mostPaths());
    while (!batches.empty() && !wave.stopFlag().isRaised()) {
        std::optional<Batch> batch = batches.next();
        recorder.begin(batch->paths());
        wave.trace({[&] { return std::exchange(batch, std::nullopt); }, [](const Batch&) {}, static_cast<int>(frame.width),
                    static_cast<int>(frame.height),
                    [&](const QueueItems& rays, const QueueItems& paths) { return recorder.bounced(rays, paths); }});
    }
}

}  // namespace

std::optional<Roulette> pilotRoulette(const Context& context, DeviceScene& scene, const PackedScene& packed, Wave& wave) {
    const PilotSize size = PilotSize::of(packed);
    if (packed.roulette || !size.isWorthwhile() || !playsRoulette(packed)) return {};
    settings frame = packed.frame();
    frame.seed = pilotSeed;
    frame.sequence_tile_bits = 0;
    frame.roulette_depth = NONE;
    scene.setFrame(context, frame);
    Recorder recorder(context, mostLight(frame));
    record(frame, scatterPixels(frame, size), wave, recorder);
    if (wave.stopFlag().isRaised()) {
        scene.setFrame(context, packed.frame());
        return {};
    }
    const Roulette chosen = chooseRoulette({pilotSets, size.samples, recorder.take()});
    frame = packed.frame();
    setRoulette(frame, chosen);
    scene.setFrame(context, frame);
    return chosen;
}

}  // namespace eikonal
