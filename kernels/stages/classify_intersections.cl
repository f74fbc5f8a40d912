/* ray, intersection -> intersection, in place; counts.  Chooses the next queue of each intersection, and counts the entries of each
   queue: route_intersections needs the totals to place each queue's segment. Also counts the live rays of each batch in flight. A counting
   stage; each work-item sums its counts, then does one atomic per count. */
#include "stages/queue.clh"
#include "trace/route.clh"
#include "stages/stage.clh"

#define CLASSIFY_INTERSECTIONS(TABLE, ARGUMENT) \
    GEOMETRY_TABLES(TABLE) TEXTURE_TABLES(TABLE) MATERIAL_TABLES(TABLE) \
    ARGUMENT(__global const settings *, frame) ARGUMENT(__global const uint *, ray) ARGUMENT(__global uint *, intersection) \
    ARGUMENT(uint, log2_batch_paths) ARGUMENT(__global uint *, counts)
COUNTING_STAGE(classify_intersections, CLASSIFY_INTERSECTIONS) {
    geometry g = BIND_GEOMETRY;
    texture_tables tables = BIND_TEXTURES;
    material_tables material_set = BIND_MATERIALS;
    uint found[wave_counts];
    for (int c = 0; c < wave_counts; ++c) found[c] = 0;
    for (size_t i = first_slot; i < COUNTING_SLOTS_END; ++i) {
        intersection_item f = load_intersection(intersection, capacity, i);
        if (f.t < 0.0f) continue;
        ray_item r = load_ray(ray, capacity, i);
        next_step next = classify_intersection(g, tables, material_set, frame, r, f);
        ++found[count_of_batches + (r.path >> log2_batch_paths)];
        STORE_FIELD(intersection, uint, next_queue, intersection, capacity, i, next.next_queue);
        STORE_FIELD(intersection, uint, material, intersection, capacity, i, next.material);
        if (next.next_queue < next_queues) ++found[next.next_queue];
        if (HAS_EMITTERS) {
            STORE_FIELD(intersection, uint, emits, intersection, capacity, i, (uint)next.emits);
            found[next_emission] += (uint)next.emits;
        }
    }
    for (int c = 0; c < wave_counts; ++c)
        if (found[c]) atomic_add(counts + c, found[c]);
}
