#include "render/light_pass.h"

#include "render/passes.h"

#include <atomic>
#include <mutex>

namespace eikonal {
namespace {

/// The batches of some samples of all pixels, for any thread.
class LightBatches {
public:
    LightBatches(const PixelRect& whole, SampleRange samples, unsigned mostPaths)
        : whole_(whole), left_(samples), mostPaths_(mostPaths) {}

    std::optional<Batch> next() {
        const std::lock_guard lock(mutex_);
        if (!batches_ || batches_->empty()) {
            if (left_.first == left_.end) return {};
            const Pass pass = uniformPass(whole_, {0, left_.first}, left_.end, mostPaths_);
            batches_.emplace(pass.size, pass.blocks, mostPaths_);
            left_.first += pass.samples;
        }
        return batches_->next();
    }

private:
    const PixelRect& whole_;
    SampleRange left_;
    unsigned mostPaths_;
    std::optional<Batches> batches_;
    std::mutex mutex_;
};

}  // namespace

std::optional<std::vector<uint>> LightPass::trace(DeviceTeam& team, const Work& work, const std::function<bool()>& isToStop,
                                                  const std::function<bool()>& abandon) {
    const size_t bytes = halves_ * sizeof(uint);
    for (;;) {
        const size_t devices = team.size();
        const auto traced = work.onlyFirst ? std::vector{team.first()} : team.devices();
        for (const RenderDevice& d : traced) splats_[d.tracer];   // no insertion while threads look them up
        LightBatches batches(whole_, work.samples, work.mostPaths);
        std::atomic<bool> isStopped = false;
        const auto next = [&]() -> std::optional<Batch> {
            if (isToStop()) isStopped = true;
            return isStopped ? std::nullopt : batches.next();
        };
        const auto traceOn = [&](const RenderDevice& d) {
            Buffer& splats = splats_.at(d.tracer);
            if (!splats.size()) splats = Buffer(*d.context, bytes, "splats");
            splats.clear(*d.context, 0, bytes);
            d.tracer->traceLights({next, [](const Batch&) {}, whole_.x1, whole_.y1}, splats, part_);
        };
        if (work.onlyFirst ? team.runFirst(abandon, traceOn) : team.run(abandon, traceOn)) isStopped = true;
        if (isStopped) return {};
        if (team.size() < devices) continue;

        std::vector<uint> sum(halves_), more(halves_);
        for (const RenderDevice& d : traced) {
            splats_.at(d.tracer).read(*d.context, more.data(), bytes);
            SplatSums::join(sum, more, part_);
        }
        return sum;
    }
}

}  // namespace eikonal
