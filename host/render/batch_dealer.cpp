#include "render/batch_dealer.h"

#include <algorithm>
#include <set>

namespace eikonal {

static unsigned long layersOf(const Pass& pass) {
    unsigned long sum = 0;
    for (const Block& b : pass.blocks) sum += b.samples;
    return sum;
}

std::optional<Batch> BatchDealer::deal(const Tracer* device) {
    std::deque<Dealt>& held = held_[device];
    if (!lost_.empty()) {
        held.push_back(std::move(lost_.begin()->second));
        lost_.erase(lost_.begin());
        held.back().number = deals_++;
        return held.back().batch;
    }
    while (!batches_ || batches_->empty()) {
        const std::optional<Pass> pass = nextPass_();
        if (!pass) return {};
        batches_.emplace(pass->size, pass->blocks, mostPaths_);
        traced_.push_back({pass->samples, layersOf(*pass)});
    }
    held.push_back({batches_->next(), donePasses_ + traced_.size() - 1, dealtBatches_++, deals_++});
    return held.back().batch;
}

/// Whether pixels have the samples before those of a batch, some of whose blocks may follow one another.
static bool hasEarlierSamples(const Film& film, const Batch& batch) {
    const PixelRect& rect = film.pixels();
    std::set<std::pair<int, int>> seen;
    return std::ranges::all_of(batch.blocks, [&](const Block& b) {
        if (!seen.emplace(b.x, b.y).second) return true;
        const PixelRect part = b.within(rect, batch.size);
        for (int y = part.y0; y < part.y1; ++y) {
            const auto row = film.taken().subspan(static_cast<size_t>(y - rect.y0) * static_cast<size_t>(rect.width()) +
                                                      static_cast<size_t>(part.x0 - rect.x0),
                                                  static_cast<size_t>(part.width()));
            if (std::ranges::any_of(row, [&](unsigned end) { return end != b.firstSample; })) return false;
        }
        return true;
    });
}

BatchDealer::State BatchDealer::stateOf(const Tracer* device) const {
    const Dealt& oldest = held_.at(device).front();
    const auto isEarlier = [&](const Dealt& d) { return d.number < oldest.number; };
    /* Alone, a device brings its batches in order, unless some were lost */
    if (hasEarlierSamples(film_, oldest.batch)) return State::ready;
    const bool mayCome = std::ranges::any_of(held_, [&](const auto& of) { return std::ranges::any_of(of.second, isEarlier); });
    return mayCome ? State::waiting : State::stuck;
}

unsigned BatchDealer::keep(const Tracer* device) {
    std::deque<Dealt>& held = held_.at(device);
    traced_[held.front().pass - donePasses_].layers -= held.front().batch.layers();
    held.pop_front();
    unsigned samples = 0;
    for (; !traced_.empty() && !traced_.front().layers; traced_.pop_front(), ++donePasses_) samples += traced_.front().samples;
    return samples;
}

void BatchDealer::lose(const Tracer* device) {
    std::deque<Dealt>& held = held_.at(device);
    const size_t place = held.front().place;
    lost_.emplace(place, std::move(held.front()));
    held.pop_front();
}

void BatchDealer::loseAll(const Tracer* device) {
    while (!held_[device].empty()) lose(device);
}

}  // namespace eikonal
