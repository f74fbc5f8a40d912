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

/// Of each pixel, one after the other in its sequence, each of low discrepancy. They complement one another, so they differ somewhat more
/// than renders with different seeds do.
constexpr size_t pilotSets = 4;
/// Paths are dropped after so many bounces, passed interfaces included, so that a pilot stays short: later light and later rays do not
/// count.
constexpr int mostBounces = 24;

/// Unlike any that people give an image, so that rule and image are independent.
constexpr uint pilotSeed = 0x70696c6f;

/// Whether any path is long enough to be ended by it.
bool playsRoulette(const PackedScene& packed) {
    const Features& f = packed.features;
    return packed.frame().max_depth > 1 && !f.has(Feature::RAY_SPLITTING) && !f.has(Feature::AMBIENT_OCCLUSION);
}

/// How many pixels are looked at, and how many samples are in each of its sets.
struct PilotSize {
    size_t pixels, samples;
    double renderedPaths;   ///< of the whole image
    static PilotSize of(const PackedScene& packed) {
        constexpr double share = 0.005;
        constexpr size_t mostSamples = 64, mostPaths = 1 << 16;
        const size_t samples = std::min<size_t>(static_cast<size_t>(packed.samples), mostSamples);
        const double renderedPaths = static_cast<double>(packed.frame().width) * packed.frame().height * packed.samples;
        return {std::min(static_cast<size_t>(renderedPaths * share), mostPaths) / (pilotSets * samples), samples, renderedPaths};
    }
    /// Whether pilot paths tell something, and take a few hundredths of the time of the render: their launches are short.
    bool isWorthwhile() const { return pixels >= 64 && renderedPaths >= 0x1p20; }
};

/// Pixels all over the image: Roberts' sequence (2018), of low discrepancy.
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

/// One number for each spectrum of a field, combined from its channels.
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

/// What roulette goes by (kernels/shade/scatter.clh).
std::vector<float> readThroughputs(const Context& context, const QueueItems& rays) {
    std::vector<float> t = readSpectra(context, rays, "beta", [](float most, float x) { return std::max(most, x); });
    if (hasField(rays, "eta_scale")) std::ranges::transform(t, readField<float>(context, rays, "eta_scale"), t.begin(), std::multiplies());
    if (hasField(rays, "r_u"))
        std::ranges::transform(t, readMeans(context, rays, "r_u"), t.begin(), [](float a, float b) { return a / std::max(b, 1e-30f); });
    return t;
}

/// Watches the paths of one batch after the other.
class Recorder {
public:
    /// mostLight: that a path may bring, as the film has it; 0: any.
    Recorder(const Context& context, float mostLight)
        : context_(context), mostLight_(mostLight > 0 ? mostLight : std::numeric_limits<float>::max()) {}

    void begin(unsigned paths) {
        recorded_.insert(recorded_.end(), paths, {PathSegment{}});
        light_.assign(paths, 0);
        depths_.assign(paths, 0);
        bounces_ = 0;
    }

    /// What the bounce brought, and which paths go on. False: enough has been seen.
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
            /* A ray that goes straight on through an interface has not been played for */
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

/// Traces blocks of single pixels, whatever room a wave has.
void record(const settings& frame, std::vector<Block> blocks, Wave& wave, Recorder& recorder) {
    Batches batches(BlockSize{}, std::move(blocks), wave.mostPaths());
    while (!batches.empty()) {
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
    Recorder recorder(context, frame.max_component_value);
    record(frame, scatterPixels(frame, size), wave, recorder);
    const Roulette chosen = chooseRoulette({pilotSets, size.samples, recorder.take()});
    frame = packed.frame();
    setRoulette(frame, chosen);
    scene.setFrame(context, frame);
    return chosen;
}

}  // namespace eikonal
