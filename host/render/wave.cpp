#include "render/wave.h"

namespace eikonal {

Wave::Wave(const Context& context, const DeviceScene& tables, const PackedScene& scene, Stages& stages, const StageShape& shape,
           Profile& profile, PageSize queuePages)
    : context_(context), stopFlag_(tables.stopFlag()), stages_(stages), shape_(shape), splitting_(RaySplitting::of(scene)),
      size_(shape, splitting_),
      queues_(context, stages.features(), scene.constants, size_, queuePages), cache_(context, scene),
      vertices_(context, scene), counter_(context, profile),
      batches_(context, queues_, size_, splitting_),
      launcher_(context, {tables.bindings(), queues_.bindings(), counter_.bindings(), cache_.bindings(), vertices_.bindings()},
                shape_, profile) {}

unsigned Wave::mostStoredPasses() const {
    return std::min(cache_.mostPasses() - 1u, vertices_.mostPasses() - 1u) + 1u;   // 0, no limit, is the largest less 1
}

void Wave::warmUp(bool isShared) {
    counter_.clear();
    /* PoCL 3.1 keeps what it has loaded of a kernel by the widest launch so far, and confuses such entries when devices of one kind launch
       it with several widths: an assertion fails. A first launch that no other is wider than leaves one entry */
    launcher_.warmUp(stages_, batches_.noPaths(), isShared ? size_.capacity : 0);
}

/// The wavefront loop. `stream` supplies the batches of paths, and is told of each that has ended (traced). `rays`: slots of the ray queue
/// that may hold a ray.
void Wave::trace(const BatchStream& stream) {
    counter_.begin();
    unsigned rays = generate(each_sample, 0, stream);   // pixels -> ray, path
    while (!batches_.empty()) {
        const WaveCounts counts = intersect(rays, each_intersection, stream);   // ray -> intersection -> hit | scatter | ... | next ray
        rays = shade(counts);                           // miss, emission -> path;  hit, scatter -> next ray, shadow;  shadow -> path
        queues_.swapRays();                             // next ray -> ray
        if (isInterrupted()) break;
        if (!goesOn(counts, rays, stream)) rays = 0;    // only pilot paths (pilot.cpp) stop here
        batches_.finish(counts, stream);                // batches without rays: stream.traced, which calls resolve (path -> film)
        rays = generate(each_sample, rays, stream);     // pixels -> ray, path
    }
    counter_.end();
}

/// The same for light paths, which have no path states: what they find goes to the splats, their hits to the cache if paths connect, and
/// their vertices to a grid if paths merge.
void Wave::traceLights(const BatchStream& stream, const Buffer& splat, const PixelRect& part) {
    Bindings splats;
    splats.set("splat", splat);
    const std::pair<const char*, int> numbers[] = {
        {"splat_x", part.x0}, {"splat_y", part.y0}, {"splat_width", part.width()}, {"splat_height", part.height()}};
    for (const auto& [name, number] : numbers) splats.set(name, static_cast<unsigned>(number));
    cache_.clear();
    vertices_.clear();
    counter_.begin();
    unsigned rays = generate(each_light_sample, 0, stream);           // pixels -> ray
    while (!batches_.empty()) {
        const WaveCounts counts = intersect(rays, each_light_intersection, stream);   // ray -> intersection -> hit
        rays = shadeLights(counts, splats);                           // hit -> next ray, shadow, cached, vertex;  shadow -> splat
        queues_.swapRays();
        if (isInterrupted()) break;
        batches_.finish(counts, stream);
        rays = generate(each_light_sample, rays, stream);
    }
    if (cache_.mostPasses() && !stopFlag_.isRaised()) cache_.check();
    if (vertices_.mostPasses() && !stopFlag_.isRaised()) vertices_.build(stages_, launcher_);   // vertex -> grid
    counter_.end();
}

/// Whether the render is interrupted. Then all paths in flight are dropped.
bool Wave::isInterrupted() {
    if (!stopFlag_.isRaised()) return false;
    context_.finish();
    batches_.abandon();
    return true;
}

/// Begins as many paths as fit behind the first `slots` slots, by the stage over `over`. Returns the number of slots in use.
unsigned Wave::generate(uint over, unsigned slots, const BatchStream& stream) {
    for (unsigned left = size_.room(slots); left > 0;) {
        const auto paths = batches_.begin(left, stream);
        if (!paths) break;
        for (const Stage& stage : stages_.over(over)) launcher_.launch(stage, {slots, paths->count}, paths->arguments);
        const unsigned taken = shape_.padded(paths->count);
        slots += taken;
        left -= std::min(left, taken);
    }
    return slots;
}

/// Intersects all rays and routes them to the next queues, by the stage over `routed`: each_intersection or each_light_intersection.
/// Returns the number of items in each queue.
WaveCounts Wave::intersect(unsigned slots, uint routed, const BatchStream& stream) {
    traced_ = slots;
    if (!slots) return {};
    counter_.clear();
    for (const Stage& stage : stages_.over(each_ray)) launcher_.launch(stage, {0, slots});
    counter_.startReading();   // routing runs meanwhile
    for (const Stage& stage : stages_.over(routed)) launcher_.launch(stage, {0, slots});
    return counter_.wait(stream.meanwhile);
}

/// Shades the items of all queues, and traces the shadow rays. Returns the slots of the next ray queue that may hold a ray.
unsigned Wave::shade(const WaveCounts& counts) {
    for (const Stage& stage : stages_.over(next_miss, next_emission)) launcher_.launch(stage, {0, counts[stage.over]});
    const Segments segments(counts, shape_.group());
    /* One pass, or one for each ray that a hit may split into; each binds its slots of the next ray queue */
    for (const Bindings& pass : splitting_.passes(segments.slots(), queues_.rays())) {
        for (const Stage& stage : stages_.over(Segments::first, Segments::last)) launcher_.launch(stage, segments[stage.over], pass);
        for (const Stage& stage : stages_.over(each_shadow)) launcher_.launch(stage, {0, segments.slots()});
    }
    connect(segments);
    return segments.slots() * splitting_.raysPerHit;
}

/// Connects hits with those of light paths, and traces the shadow rays in between: hit, cached -> connection, shadow;  shadow -> path.
void Wave::connect(const Segments& segments) {
    if (!cache_.mostPasses()) return;
    for (const Stage& stage : stages_.over(connecting_hits + Segments::first, connecting_hits + Segments::last))
        launcher_.launch(stage, segments[stage.over - connecting_hits]);
    for (const Stage& stage : stages_.over(connected_hits + Segments::first, connected_hits + Segments::last))
        launcher_.launch(stage, {0, segments.slots()});
    for (const Stage& stage : stages_.over(each_shadow)) launcher_.launch(stage, {0, segments.slots()});
}

/// Scatters light paths, and splats what they send to the camera. Returns the slots of the next ray queue that may hold a ray.
unsigned Wave::shadeLights(const WaveCounts& counts, const Bindings& splat) {
    const Segments segments(counts, shape_.group());
    for (const Stage& stage : stages_.over(light_hits + Segments::first, light_hits + Segments::last))
        launcher_.launch(stage, segments[stage.over - light_hits]);
    for (const Stage& stage : stages_.over(each_splat)) launcher_.launch(stage, {0, segments.slots()}, splat);
    return segments.slots();
}

/// Whether to trace the next bounce. Always, unless the stream watches the rays and declines (BatchStream::watch; in pilot.cpp).
bool Wave::goesOn(const WaveCounts& counts, unsigned rays, const BatchStream& stream) const {
    if (!stream.watch || !raysOf(counts)) return true;
    const unsigned hits = rays / splitting_.raysPerHit;
    return stream.watch({queues_.tracedRays(traced_), queues_.items(Queue::intersection, 0, traced_),
                         queues_.items(Queue::shadow, 0, hits), queues_.items(Queue::hit, 0, hits), queues_.items(Queue::ray, 0, rays),
                         batches_.oldestPaths()});
}

/// Adds the paths of the finished batch, which is the oldest in flight, to its pixels: path -> film.
void Wave::resolve(const Batch& batch, const Buffer& film) {
    Bindings arguments = batches_.oldestArguments();
    arguments.set("film", film);
    for (const Stage& stage : stages_.over(each_pixel)) launcher_.launch(stage, {0, batch.pixels()}, arguments);
}

}  // namespace eikonal
