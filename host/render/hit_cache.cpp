#include "render/hit_cache.h"

#include "eikonal/feature_fields.h"
#include "render/wave_queues.h"

#include <fmt/format.h>

#include <algorithm>

namespace eikonal {

static size_t hitWords(const Features& features) { return static_cast<size_t>(itemLayout(Queue::hit, features).words); }
static size_t bytesOfHits(const HitCachePlan& plan, const Features& features) { return plan.hits * hitWords(features) * sizeof(uint); }
static size_t bytesOfRecords(const HitCachePlan& plan) { return plan.hits * CACHED_STRIDE * sizeof(uint); }

size_t plannedHitCacheBytes(const PackedScene& scene) {
    const HitCachePlan plan = planHitCache(scene);
    return bytesOfRecords(plan) + bytesOfHits(plan, scene.features) + plan.paths * sizeof(uint);
}

HitCache::HitCache(const Context& context, const PackedScene& scene)
    : context_(context),
      plan_(planHitCache(scene)),
      records_(context, std::max(bytesOfRecords(plan_), sizeof(uint)), "records of hits of light paths"),
      hits_(context, std::max(bytesOfHits(plan_, scene.features), sizeof(uint)), "hits of light paths"),
      count_(context, sizeof(uint), "the number of hits of light paths"),
      last_(context, std::max(plan_.paths, size_t{1}) * sizeof(uint), "the last hits of light paths") {
    bindings_.set("cached", records_);
    bindings_.set("cached_hit", hits_);
    bindings_.set("cached_hit_size", static_cast<uint>(hitWords(scene.features)));
    bindings_.set("cached_count", count_);
    bindings_.set("cached_last", last_);
    bindings_.set("cached_capacity", static_cast<uint>(plan_.hits));
    bindings_.set("cached_pass_mask", plan_.passes ? plan_.passes - 1 : 0u);
}

void HitCache::clear() {
    count_.clear(context_, 0, sizeof(uint));
    last_.clear(context_, 0, last_.size());
}

void HitCache::check() const {
    uint kept = 0;
    count_.read(context_, &kept, sizeof kept);
    if (kept > plan_.hits)
        throw DeviceError(fmt::format("light paths have left {} hits, and there is room for {}; a lower \"maxdepth\" leaves fewer", kept,
                                      plan_.hits));
}

}  // namespace eikonal
