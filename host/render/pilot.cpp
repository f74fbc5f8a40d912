#include "render/pilot.h"

#include <cmath>
#include <optional>
#include <utility>

namespace eikonal {

settings pilotFrame(settings frame, uint seed) {
    frame.seed = seed;
    frame.sequence_tile_bits = 0;
    frame.roulette_depth = NONE;
    return frame;
}

std::vector<Block> scatterPixels(const settings& frame, size_t pixels, size_t samples, size_t firstSample) {
    const auto at = [](size_t i, double step, uint extent) {
        return static_cast<int>(std::fmod(0.5 + static_cast<double>(i) * step, 1.) * extent);
    };
    std::vector<Block> blocks;
    for (size_t i = 0; i < pixels; ++i)
        blocks.push_back({at(i, 0.7548776662466927, frame.width), at(i, 0.5698402909980532, frame.height),
                          static_cast<unsigned>(firstSample), static_cast<unsigned>(samples)});
    return blocks;
}

void tracePilot(const settings& frame, std::vector<Block> blocks, Wave& wave, PilotRecorder& recorder) {
    Batches batches(BlockSize{}, std::move(blocks), wave.mostPaths());
    while (!batches.empty() && !wave.stopFlag().isRaised()) {
        std::optional<Batch> batch = batches.next();
        recorder.begin(batch->paths());
        wave.trace({[&] { return std::exchange(batch, std::nullopt); }, [](const Batch&) {}, static_cast<int>(frame.width),
                    static_cast<int>(frame.height),
                    [&](const Bounced& bounce) { return recorder.bounced(bounce); }});
    }
}

std::vector<float> readMeans(const Context& context, const QueueItems& items, const char* name) {
    const float channels = static_cast<float>(items.layout.field(name).words);
    return readSpectra(context, items, name, [=](float sum, float x) { return sum + x / channels; });
}

std::vector<vec3> readVectors(const Context& context, const QueueItems& items, const char* name) {
    std::vector<vec3> all(items.count);
    const std::vector<float> x = readField<float>(context, items, name, 0), y = readField<float>(context, items, name, 1),
                             z = readField<float>(context, items, name, 2);
    for (size_t i = 0; i < all.size(); ++i) all[i] = {x[i], y[i], z[i]};
    return all;
}

}  // namespace eikonal
