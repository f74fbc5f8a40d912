#include "render/row_costs.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace eikonal {
namespace {

constexpr uint pilotSeed = 0x726f7773;
/// Paths of all rows together, about; of one row at most; and bounces, after which they are dropped.
constexpr int mostPaths = 1 << 16, mostPathsOfRow = 64, mostBounces = 64;

/// One sample of some pixels of each row, spread by Roberts' low-discrepancy sequence (2018).
std::vector<Block> pilotPixels(const PixelRect& rows) {
    const int perRow = std::clamp(mostPaths / rows.height(), 1, std::min(mostPathsOfRow, rows.width()));
    std::vector<Block> pixels;
    for (int y = rows.y0; y < rows.y1; ++y)
        for (int i = 0; i < perRow; ++i) {
            const double at = std::fmod(0.5 + static_cast<double>(pixels.size()) * 0.6180339887498949, 1.0);
            pixels.push_back({rows.x0 + static_cast<int>(at * rows.width()), y, 0, 1});
        }
    return pixels;
}

std::vector<uint> readWords(const Context& context, const QueueItems& items, const char* name) {
    std::vector<uint> values(items.count);
    const size_t first = static_cast<size_t>(items.layout.field(name).slot) * items.capacity + items.first;
    if (items.count) items.words.read(context, values.data(), values.size() * sizeof(uint), first * sizeof(uint));
    return values;
}

}  // namespace

std::vector<std::uint64_t> estimateRowCosts(const Context& context, DeviceScene& tables, const PackedScene& scene, const PixelRect& rows,
                                            Wave& wave) {
    settings frame = scene.frame();
    frame.seed = pilotSeed;
    frame.sequence_tile_bits = frame.sequence_sample_bits = 0;
    tables.setFrame(context, frame);
    std::vector<std::uint64_t> costs(static_cast<size_t>(rows.height()), 1);
    Batches batches(BlockSize{}, pilotPixels(rows), wave.mostPaths());
    while (!batches.empty() && !wave.stopFlag().isRaised()) {
        std::optional<Batch> batch = batches.next();
        std::vector<size_t> rowOfPath;
        for (const Block& block : batch->blocks) rowOfPath.insert(rowOfPath.end(), block.samples, static_cast<size_t>(block.y - rows.y0));
        for (const size_t row : rowOfPath) ++costs[row];
        int bounces = 0;
        const auto count = [&](const QueueItems& rays, const QueueItems& paths) {
            /* With ray splitting a path has several states */
            const size_t states = std::max<size_t>(paths.count / rowOfPath.size(), 1);
            const std::vector<uint> path = readWords(context, rays, "path"), end = readWords(context, rays, "t_max");
            for (size_t i = 0; i < path.size(); ++i)
                if (!(end[i] >> 31)) ++costs[rowOfPath[std::min((path[i] - paths.first) / states, rowOfPath.size() - 1)]];
            return ++bounces < mostBounces;
        };
        wave.trace({[&] { return std::exchange(batch, std::nullopt); }, [](const Batch&) {}, static_cast<int>(frame.width),
                    static_cast<int>(frame.height), count});
    }
    tables.setFrame(context, scene.frame());
    return costs;
}

}  // namespace eikonal
