#include "render/row_costs.h"

#include "pack/material_slots.h"
#include "render/pilot.h"

#include <algorithm>
#include <cmath>

namespace eikonal {
namespace {

/// Not a seed that a user is likely to choose.
constexpr uint pilotSeed = 0x726f7773;
/// Paths of all rows together, about; of one row at most; and bounces, after which they are dropped.
constexpr int mostPaths = 1 << 17, mostPathsOfRow = 512, mostBounces = 64;

/// What a ray costs besides the steps of its traversal and the parameters of the BSDF that it meets, in such steps (docs/farm.md).
constexpr std::uint64_t costOfRay = 10;

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

/// Adds up the costs of the paths of one batch after another.
class CostCounter : public PilotRecorder {
public:
    /// pixels: those of the paths, in their order; rows: of which they are. Both must outlive this object.
    CostCounter(const Context& context, const TraversalSteps& steps, const std::vector<Block>& pixels, const PixelRect& rows, bool spectral)
        : context_(context),
          steps_(steps),
          pixels_(pixels),
          rows_(rows),
          spectral_(spectral),
          costs_(static_cast<size_t>(rows.height()), 1) {}

    void begin(unsigned paths) override {
        first_ += paths_;
        paths_ = paths;
        bounces_ = 0;
    }

    bool bounced(const Bounced& bounce) override {
        /* Where rays split, a path has several states */
        firstState_ = bounce.paths.first;
        states_ = std::max<size_t>(bounce.paths.count / paths_, 1);
        const std::vector<float> t = readField<float>(context_, bounce.intersections, "t");
        const std::vector<uint> path = addSteps(bounce.traced, t, false),
                                next = readField<uint>(context_, bounce.intersections, "next_queue");
        for (size_t i = 0; i < path.size(); ++i)
            if (t[i] >= 0) costOf(path[i]) += costOfRay + bsdfParameterWords(next[i], spectral_);   // the more parameters, the more work
        addSteps(bounce.shadows, readField<float>(context_, bounce.shadows, "t_max"), true);
        return ++bounces_ < mostBounces;
    }

    std::vector<std::uint64_t> take() { return std::move(costs_); }

private:
    std::uint64_t& costOf(uint state) {
        const size_t path = std::min<size_t>((state - firstState_) / states_, paths_ - 1);
        return costs_[static_cast<size_t>(pixels_[first_ + path].y - rows_.y0)];
    }

    /// Adds the steps of rays that are alive: those of which `end` is not below 0. Returns the state of each slot's path.
    std::vector<uint> addSteps(const QueueItems& rays, const std::vector<float>& end, bool areShadowRays) {
        std::vector<uint> state = readField<uint>(context_, rays, "path");
        const std::vector<vec3> o = readVectors(context_, rays, "o"), d = readVectors(context_, rays, "d");
        const std::vector<float> farthest = readField<float>(context_, rays, "t_max");
        std::vector<size_t> alive;
        TracedRays traced;
        for (size_t i = 0; i < rays.count; ++i) {
            if (!(end[i] >= 0)) continue;
            alive.push_back(i);
            traced.origins.push_back(o[i]);
            traced.directions.push_back(d[i]);
            traced.ends.push_back(farthest[i]);
        }
        const std::vector<uint> steps = steps_.count(traced, areShadowRays);
        for (size_t i = 0; i < alive.size(); ++i) costOf(state[alive[i]]) += steps[i];
        return state;
    }

    const Context& context_;
    const TraversalSteps& steps_;
    const std::vector<Block>& pixels_;
    const PixelRect& rows_;
    const bool spectral_;
    std::vector<std::uint64_t> costs_;
    size_t first_ = 0, paths_ = 0;   ///< of the batch, among all
    size_t states_ = 1;              ///< of a path
    uint firstState_ = 0;
    int bounces_ = 0;
};

}  // namespace

std::vector<std::uint64_t> estimateRowCosts(const Context& context, DeviceScene& tables, const PackedScene& scene, const settings& frame,
                                            const PixelRect& rows, const TraversalSteps& steps, Wave& wave) {
    settings pilot = frame;
    pilot.seed = pilotSeed;
    pilot.sequence_tile_bits = pilot.sequence_sample_bits = 0;
    tables.setFrame(context, pilot);
    const std::vector<Block> pixels = pilotPixels(rows);
    CostCounter counter(context, steps, pixels, rows, scene.features.has(Feature::SPECTRAL));
    tracePilot(pilot, pixels, wave, counter);
    tables.setFrame(context, frame);
    return counter.take();
}

}  // namespace eikonal
