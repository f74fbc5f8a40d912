#pragma once
// Pilot paths: a small sample of the render's paths, traced before it, to learn how the others are best traced.

#include "render/wave.h"

#include <algorithm>
#include <functional>
#include <vector>

namespace eikonal {

/// Pilot paths are truncated after this many bounces, null interfaces included, to keep the pilot short. Later light and rays are ignored.
constexpr int mostPilotBounces = 24;

/// Settings of pilot paths, which have no Russian roulette. `seed`: one that a user is unlikely to choose, so that what is learned and the
/// image are independent.
settings pilotFrame(settings frame, uint seed);

/// Pixels spread over the image by Roberts' low-discrepancy sequence (2018), each with `samples` samples from `firstSample` on.
std::vector<Block> scatterPixels(const settings& frame, size_t pixels, size_t samples, size_t firstSample = 0);

/// Records paths as they are traced.
class PilotRecorder {
public:
    virtual ~PilotRecorder() = default;
    /// The next batch has so many paths.
    virtual void begin(unsigned paths) = 0;
    /// After each bounce, as BatchStream::watch.
    virtual bool bounced(const Bounced& bounce) = 0;
};

/// Traces blocks of single pixels, in batches that fit the wave.
void tracePilot(const settings& frame, std::vector<Block> blocks, Wave& wave, PilotRecorder& recorder);

/// A word of a field of all items. Blocks.
template <class T> std::vector<T> readField(const Context& context, const QueueItems& items, const char* name, int word = 0) {
    std::vector<T> values(items.count);
    if (!items.count) return values;
    const size_t first = static_cast<size_t>(items.layout.field(name).slot + word) * items.capacity + items.first;
    items.words.read(context, values.data(), values.size() * sizeof(T), first * sizeof(T));
    return values;
}
inline bool hasField(const QueueItems& items, const char* name) { return items.layout.field(name).words > 0; }

/// Reduces each spectrum of a field to one number.
template <class Combine>
std::vector<float> readSpectra(const Context& context, const QueueItems& items, const char* name, Combine&& combine) {
    std::vector<float> all(items.count);
    for (int c = 0; c < items.layout.field(name).words; ++c)
        std::ranges::transform(all, readField<float>(context, items, name, c), all.begin(), combine);
    return all;
}
std::vector<float> readMeans(const Context& context, const QueueItems& items, const char* name);

/// The field d, say, of all items.
std::vector<vec3> readVectors(const Context& context, const QueueItems& items, const char* name);

}  // namespace eikonal
