#include "render/wave.h"

#include <chrono>

namespace eikonal {

Wave::Wave(const Context& context, const DeviceScene& scene, Stages& stages, const StageShape& shape, const Features& features, Profile& profile,
           PageSize queuePages)
    : context_(context), scene_(scene.bindings()), stages_(stages), shape_(shape), profile_(profile), splitting_(scene.splitting()), size_(shape, splitting_) {
    for (const PlannedQueue& queue : queuesFor(features, stages.find("shade_misses"), size_)) {
        addQueue(queue.layout, queue.items, queue.name, queuePages);
        if (queue.name == "ray") { rays_[0] = &buffers_.back(); rayLayout_ = queue.layout; }
        if (queue.name == "next_ray") rays_[1] = &buffers_.back();
        if (queue.name == "path") { paths_ = &buffers_.back(); pathLayout_ = queue.layout; }
    }
    for (unsigned place = 0; place < size_.batches; ++place) tables_.emplace_back(context);
    counts_ = Buffer(context, sizeof(Counts), "counts");
    cursors_ = Buffer(context, sizeof(Counts), "cursors");
    shadowCount_ = Buffer(context, sizeof(cl_uint), "shadow rays");
    bindings_.set("counts", counts_);
    bindings_.set("cursors", cursors_);
    bindings_.set("shadow_count", shadowCount_);
    bindings_.set("capacity", size_.capacity);
    bindings_.set("path_capacity", size_.pathCapacity);
    bindings_.set("log2_batch_paths", size_.log2BatchPaths + splitting_.splits);
}

void Wave::addQueue(const QueueLayout& layout, size_t items, const std::string& name, PageSize pages) {
    buffers_.emplace_back(context_, items * static_cast<size_t>(layout.words) * sizeof(cl_uint), "queue " + name, pages);
    bindings_.set(name, buffers_.back());
    bytes_ += buffers_.back().size();
}

void Wave::run(const Stage* stage, unsigned items, const Bindings& extra) {
    if (!stage) return;
    /* Scene tables, then queues, then what this launch has of its own */
    profile_.add(stage->name, items, stage->kernel.launch(context_, {&scene_, &bindings_, &extra}, items, shape_.group()));
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
    run(stages_.find("classify_intersections"), rays, segment(0, rays));
    Counts counts;
    cl_uint shadowRays = 0;
    cl_event done = nullptr;
    check(clEnqueueReadBuffer(context_.queue(), shadowCount_.handle(), CL_FALSE, 0, sizeof shadowRays, &shadowRays, 0, nullptr, nullptr), "reading how many shadow rays there were");
    check(clEnqueueReadBuffer(context_.queue(), counts_.handle(), CL_FALSE, 0, sizeof counts, counts.data(), 0, nullptr, &done), "reading the counts");
    const Owned<cl_event, clReleaseEvent> owner(done);
    /* While the counts travel, the device routes */
    run(stages_.find("route_intersections"), rays, segment(0, rays));
    context_.flush();
    check(clWaitForEvents(1, &done), "waiting for the counts");
    countShadowRays(shadowRays);
    return counts;
}

/// Everything that scatters: the `pass`-th ray on from each point, and light from one light, or with trees of rays from the `pass`-th. (Where there
/// are trees there are no media, and so no rays that pass an interface.)
void Wave::shadingPass(const Counts& counts, unsigned pass, unsigned slots) {
    unsigned first = 0;
    for (uint next_queue = 0; next_queue < next_miss; ++next_queue) {
        const Stage* stage = next_queue == next_scatter ? stages_.find("shade_scatters") : next_queue == next_occlusion ? stages_.find("shade_occlusions") : stages_.shading(next_queue);
        Bindings own = segment(first, counts[next_queue]);
        own.set("shading_pass", pass);
        own.set("pass_slots", slots);
        /* More lights than rays: what is written as rays on must not be read */
        if (pass >= splitting_.raysPerHit) { own.set("pass_slots", 0); own.set("next_ray", *rays_[0]); }
        if (counts[next_queue]) run(stage, counts[next_queue], own);
        first += shape_.padded(counts[next_queue]);
    }
    run(slots ? stages_.find("test_shadows") : nullptr, slots, segment(0, slots));
}

/// Returns how many slots of the queue of rays may hold one.
unsigned Wave::shade(const Counts& counts) {
    run(counts[next_miss] ? stages_.find("shade_misses") : nullptr, counts[next_miss], segment(0, counts[next_miss]));
    run(counts[next_emission] ? stages_.find("shade_emitters") : nullptr, counts[next_emission], segment(0, counts[next_emission]));
    unsigned slots = 0;
    for (uint next_queue = 0; next_queue < next_miss; ++next_queue) slots += shape_.padded(counts[next_queue]);
    for (unsigned pass = 0; pass < splitting_.shadingPasses; ++pass) shadingPass(counts, pass, slots);
    return slots * splitting_.raysPerHit;
}

void Wave::bindRays() {
    bindings_.set("ray", *rays_[0]);
    bindings_.set("next_ray", *rays_[1]);
}

void Wave::countShadowRays(cl_uint now) {
    profile_.shadowRays += now - shadowRays_;
    shadowRays_ = now;
}

/// Every ray goes to where it ends, and from there on. Of `slots` of the queue that may hold one; afterwards it is those of the next.
Wave::Counts Wave::bounce(unsigned& slots) {
    if (!slots) return {};
    run(stages_.find("intersect_rays"), slots, segment(0, slots));     // ray -> intersection
    run(stages_.find("extinguish_rays"), slots, segment(0, slots));    // intersection -> intersection, if there are media
    const Counts counts = countAndRoute(slots);                        // intersection -> hit, scatter, miss, emission, next ray
    slots = shade(counts);                                             // -> path, next ray, shadow -> path
    std::swap(rays_[0], rays_[1]);
    bindRays();
    for (unsigned place = 0; place < tables_.size(); ++place) profile_.rays += counts[count_of_batches + place];
    return counts;
}

/// For how many new rays there is room, or none where it is not worth a launch. With trees of rays nobody knows how many those in flight become.
unsigned Wave::room(unsigned slots) const {
    if (splitting_.splits) return slots ? 0 : size_.paths;
    const unsigned most = shape_.padded(size_.paths), left = most - std::min(slots, most);
    return left < most / 16 ? 0 : left;
}

/// Takes on another batch, if there is one and a place for it.
bool Wave::admit(const BatchStream& stream) {
    if (flying_.size() == tables_.size()) return false;
    std::optional<Batch> batch = stream.next();
    if (!batch) return false;
    tables_[nextPlace_].write(context_, *batch, stream.endX, stream.endY);
    flying_.push_back({std::move(*batch), nextPlace_});
    nextPlace_ = (nextPlace_ + 1) % static_cast<unsigned>(tables_.size());
    if (splitting_.splits) paths_->clear(context_, 0, paths_->size());
    return true;
}

/// Begins paths in the slots after `slots`, which are taken. Returns how many are taken then.
unsigned Wave::refill(unsigned slots, const BatchStream& stream) {
    for (unsigned left = room(slots); left > 0;) {
        if ((flying_.empty() || flying_.back().isBegun()) && !admit(stream)) break;
        Flying& last = flying_.back();
        const unsigned count = std::min(left, last.batch.paths() - last.begun), taken = shape_.padded(count);
        Bindings own = tables_[last.place].bindings();
        own.set("begun", last.begun);
        own.set("first_path", firstPath(last.place));
        own.set("first", slots);
        own.set("count", count);
        run(stages_.find("generate_rays"), count, own);
        last.begun += count;
        slots += taken;
        left -= std::min(left, taken);
    }
    return slots;
}

void Wave::trace(const BatchStream& stream) {
    bindRays();
    shadowCount_.clear(context_, 0, sizeof shadowRays_);
    shadowRays_ = 0;
    unsigned slots = refill(0, stream);
    while (!flying_.empty()) {
        const bool moves = slots > 0;
        const Counts counts = bounce(slots);
        if (moves && stream.bounced && !stream.bounced({*rays_[0], rayLayout_, size_.capacity, 0, slots}, pathsOf(flying_.front()))) slots = 0;
        /* Batches that had no ray at this bounce are done */
        while (!flying_.empty() && flying_.front().isBegun() && !counts[count_of_batches + flying_.front().place]) {
            stream.traced(flying_.front().batch);
            flying_.pop_front();
        }
        slots = refill(slots, stream);
    }
    cl_uint shadowRays = 0;
    shadowCount_.read(context_, &shadowRays, sizeof shadowRays);
    countShadowRays(shadowRays);
}

void Wave::resolve(const Batch& batch, const Buffer& film) {
    const Flying& done = flying_.front();
    Bindings own = tables_[done.place].bindings();
    own.set("first_path", firstPath(done.place));
    own.set("film", film);
    own.set("count", batch.pixels());
    run(stages_.find("resolve_film"), batch.pixels(), own);
}

void Wave::warmUp() {
    const Buffer film(context_, 1024, "film");
    Bindings nothing = tables_.front().bindings();
    for (const char* name : {"first", "count", "shading_pass", "pass_slots", "begun", "first_path", "representatives"}) nothing.set(name, 0u);
    nothing.set("film", film);
    for (const char* name : {"survey_points", "survey_normals", "survey_weights"}) nothing.set(name, film);
    bindRays();
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
