#include "render/wave.h"

#include "render/wave_queues.h"

#include <chrono>

namespace eikonal {

Wave::Wave(const Context& context, const DeviceScene& scene, Stages& stages, const StageShape& shape, const Features& features, Profile& profile)
    : context_(context), scene_(scene.bindings()), stages_(stages), shape_(shape), profile_(profile), branching_(scene.branching()),
      mostPaths_(mostPathsFor(shape, branching_)), capacity_(capacityFor(shape, branching_)), mostHops_(mostHops(scene)), tables_(context) {
    for (const PlannedQueue& queue : queuesFor(features, stages.find("shade_misses"), capacity_)) {
        addQueue(queue.layout, queue.items, queue.name);
        if (queue.name == "ray") rays_[0] = &buffers_.back();
        if (queue.name == "next_ray") rays_[1] = &buffers_.back();
        if (queue.name == "path") paths_ = &buffers_.back();
    }
    counts_ = Buffer(context, sizeof(Counts), "counts");
    cursors_ = Buffer(context, sizeof(Counts), "cursors");
    tally_ = Buffer(context, tallies * sizeof(cl_uint), "tally");
    bindings_.set("counts", counts_);
    bindings_.set("cursors", cursors_);
    bindings_.set("tally", tally_);
    bindings_.set("capacity", capacity_);
}

void Wave::addQueue(const QueueLayout& layout, size_t items, const std::string& name) {
    buffers_.emplace_back(context_, items * static_cast<size_t>(layout.words) * sizeof(cl_uint), "queue " + name);
    bindings_.set(name, buffers_.back());
    bytes_ += buffers_.back().size();
}

void Wave::run(const Stage* stage, unsigned items, const Bindings& extra) {
    if (!stage) return;
    /* Scene tables, then queues, then what this launch has of its own */
    profile_.add(stage->name, items, stage->kernel.launch(context_, {&scene_, &bindings_, &tables_.bindings(), &extra}, items, shape_.group()));
}

static Bindings segment(unsigned first, unsigned count) {
    Bindings b;
    b.set("first", first);
    b.set("count", count);
    return b;
}

Wave::Counts Wave::countAndRoute(unsigned rays) {
    counts_.clear(context_, 0, sizeof(Counts));
    cursors_.clear(context_, 0, sizeof(Counts));
    run(stages_.find("classify_flights"), rays, segment(0, rays));
    Counts counts;
    cl_event done = nullptr;
    check(clEnqueueReadBuffer(context_.queue(), counts_.handle(), CL_FALSE, 0, sizeof counts, counts.data(), 0, nullptr, &done), "reading the counts");
    const Owned<cl_event, clReleaseEvent> owner(done);
    /* While the counts travel, the device routes */
    run(stages_.find("route_flights"), rays, segment(0, rays));
    context_.flush();
    check(clWaitForEvents(1, &done), "waiting for the counts");
    return counts;
}

/// Everything that scatters: the `turn`-th ray on from each point, and light from one light, or with trees of rays from the `turn`-th. (Where there
/// are trees there are no media, and so no rays that pass an interface.)
void Wave::shadeTurn(const Counts& counts, unsigned turn, unsigned slots) {
    unsigned first = 0;
    for (uint hop = 0; hop < hop_miss; ++hop) {
        const Stage* stage = hop == hop_scatter ? stages_.find("shade_scatters") : hop == hop_occlusion ? stages_.find("shade_occlusions") : stages_.shading(hop);
        Bindings own = segment(first, counts[hop]);
        own.set("turn", turn);
        own.set("turn_slots", slots);
        /* More lights than rays: what is written as rays on must not be read */
        if (turn >= branching_.branches) { own.set("turn_slots", 0); own.set("next_ray", *rays_[0]); }
        if (counts[hop]) run(stage, counts[hop], own);
        first += shape_.padded(counts[hop]);
    }
    run(slots ? stages_.find("test_shadows") : nullptr, slots, segment(0, slots));
}

/// Returns how many slots of the queue of rays may hold one.
unsigned Wave::shade(const Counts& counts) {
    run(counts[hop_miss] ? stages_.find("shade_misses") : nullptr, counts[hop_miss], segment(0, counts[hop_miss]));
    run(counts[hop_emission] ? stages_.find("shade_emitters") : nullptr, counts[hop_emission], segment(0, counts[hop_emission]));
    unsigned slots = 0;
    for (uint hop = 0; hop < hop_miss; ++hop) slots += shape_.padded(counts[hop]);
    for (unsigned turn = 0; turn < branching_.turns; ++turn) shadeTurn(counts, turn, slots);
    return slots * branching_.branches;
}

void Wave::trace(const Batch& batch, int endX, int endY) {
    tables_.write(context_, batch, endX, endY);
    bindings_.set("ray", *rays_[0]);
    bindings_.set("next_ray", *rays_[1]);
    tally_.clear(context_, 0, tallies * sizeof(cl_uint));
    if (branching_.forks) paths_->clear(context_, 0, paths_->size());

    unsigned rays = batch.paths();
    run(stages_.find("generate_rays"), rays, segment(0, rays));
    for (unsigned hop = 0; rays > 0 && hop < mostHops_; ++hop) {
        run(stages_.find("intersect_rays"), rays, segment(0, rays));     // ray -> flight
        run(stages_.find("extinguish_rays"), rays, segment(0, rays));    // flight -> flight, if there are media
        const Counts counts = countAndRoute(rays);                       // flight -> hit, scatter, miss, emission, next ray
        rays = shade(counts);                                            // -> path, next ray, shadow -> path
        std::swap(rays_[0], rays_[1]);
        bindings_.set("ray", *rays_[0]);
        bindings_.set("next_ray", *rays_[1]);
    }
    std::array<cl_uint, tallies> tally;
    tally_.read(context_, tally.data(), sizeof tally);
    profile_.rays += tally[tally_rays];
    profile_.shadowRays += tally[tally_shadow_rays];
}

void Wave::resolve(const Batch& batch, const Buffer& film) {
    Bindings own;
    own.set("film", film);
    run(stages_.find("resolve_film"), batch.pixels(), own);
}

void Wave::warmUp() {
    const Buffer film(context_, 1024, "film");
    Bindings nothing = segment(0, 0);
    for (const char* name : {"turn", "turn_slots"}) nothing.set(name, 0u);
    nothing.set("film", film);
    nothing.set("ray", *rays_[0]);
    nothing.set("next_ray", *rays_[1]);
    counts_.clear(context_, 0, sizeof(Counts));
    cursors_.clear(context_, 0, sizeof(Counts));
    for (Stage& stage : stages_.all()) {
        const auto start = std::chrono::steady_clock::now();
        run(&stage, 0, nothing);
        context_.finish();
        stage.firstLaunchSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
    profile_.collect();
    profile_.reset();
}

}  // namespace eikonal
