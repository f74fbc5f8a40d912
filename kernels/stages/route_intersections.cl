/* ray, intersection, counts, exit_point -> hit, scatter, miss, emission, next_ray, shadow, path, probe.  Builds the item for each
   intersection's next stage, in that stage's dense segment. A counting stage; each work-item reserves space once for all its slots. */
#include "eikonal/stages.h"
#include "stages/queue.clh"
#include "stages/stage.clh"

#include "trace/segments.clh"

/* Where this work-item puts its items: at[q] is the next slot for next_queue q. */
typedef struct {
    __global uint *hit, *scatter, *miss, *emission, *next_ray, *shadow, *path, *probe;
    uint capacity, path_capacity;
    uint *at;
} destinations;

FN uint reserve_hit(destinations *to, uint next_queue) { return to->at[next_queue]++; }
FN void send_hit(scene_tables scene, destinations *to, uint next_queue, uint slot, hit_item h) {}
FN void send_probe(destinations *to, uint slot, probe_item p) { store_probe(to->probe, to->capacity, slot, p); }
FN void send_miss(scene_tables scene, destinations *to, miss_item m) { store_miss(to->miss, to->capacity, to->at[next_miss]++, m); }
FN void send_scatter(scene_tables scene, destinations *to, scatter_item s) {
    store_scatter(to->scatter, to->capacity, to->at[next_scatter]++, s);
}
FN void send_emission(destinations *to, emission_item e) { store_emission(to->emission, to->capacity, to->at[next_emission]++, e); }
FN void send_ray(destinations *to, ray_item r) { store_crossing(to->next_ray, to->shadow, to->capacity, to->at[next_crossing]++, r); }

#include "trace/route_intersection.clh"

#define ROUTE_INTERSECTIONS(TABLE, ARGUMENT) \
    GEOMETRY_TABLES(TABLE) TEXTURE_TABLES(TABLE) MATERIAL_TABLES(TABLE) LIGHT_TABLES(TABLE) MEDIUM_TABLES(TABLE) COLOR_TABLES(TABLE) \
    ARGUMENT(__global const settings *, frame) ARGUMENT(__global const uint *, ray) ARGUMENT(__global const uint *, intersection) \
    ARGUMENT(__global const uint *, counts) ARGUMENT(__global const uint *, exit_point) ARGUMENT(__global uint *, cursors) \
    ARGUMENT(__global uint *, hit) ARGUMENT(__global uint *, scatter) ARGUMENT(__global uint *, miss) ARGUMENT(__global uint *, emission) \
    ARGUMENT(__global uint *, next_ray) ARGUMENT(__global uint *, shadow) ARGUMENT(__global uint *, path) ARGUMENT(__global uint *, probe)
COUNTING_STAGE(route_intersections, ROUTE_INTERSECTIONS) {
    scene_tables scene = BIND_SCENE;

    /* Count the items that this work-item adds to each queue, and reserve space for them */
    uint at[next_queues];
    for (int h = 0; h < next_queues; ++h) at[h] = 0;
    for (size_t i = first_slot; i < COUNTING_SLOTS_END; ++i) {
        if (LOAD_FIELD(intersection, float, t, intersection, capacity, i) < 0.0f) continue;
        uint next_queue = LOAD_FIELD(intersection, uint, next_queue, intersection, capacity, i);
        if (next_queue < next_queues) ++at[next_queue];
        if (HAS_EMITTERS && LOAD_FIELD(intersection, uint, emits, intersection, capacity, i)) ++at[next_emission];
    }
    for (uint h = 0; h < next_queues; ++h) {
        if (!at[h]) continue;
        uint start = h == next_miss || h == next_emission ? 0 : segment_start(counts, h);
        at[h] = start + atomic_add(cursors + h, at[h]);
    }

    /* Fill the reserved space */
    destinations to = {hit, scatter, miss, emission, next_ray, shadow, path, probe, capacity, path_capacity, at};
    if (HAS_INTERFACE && first_slot == 0) end_crossings(next_ray, shadow, capacity, counts[next_crossing]);
    for (size_t i = first_slot; i < COUNTING_SLOTS_END; ++i) {
        if (LOAD_FIELD(intersection, float, t, intersection, capacity, i) < 0.0f) continue;
        intersection_item f = load_intersection(intersection, capacity, i);
        if (f.next_queue >= next_queues && !(HAS_EMITTERS && f.emits)) continue;
        exit_point_item exit = new_exit_point();
        if (HAS_DIFFUSION && f.next_queue == next_subsurface_exit) exit = load_exit_point(exit_point, capacity, i);
        route_intersection(scene, &to, load_ray(ray, capacity, i), f, exit);
    }
}
