/* ray, flight -> flight, in place.  Which queue each flight goes to next, and how many go to each: route_flights needs the totals
   to know where each queue's segment begins. And how many rays each batch in flight still has. Tracing: counts are added up within a run, one
   atomic for each. */
#include "stages/queue.clh"
#include "trace/route.clh"
#include "stages/stage.clh"

#define CLASSIFY_FLIGHTS(TABLE, ARGUMENT) \
    GEOMETRY_TABLES(TABLE) TEXTURE_TABLES(TABLE) MATERIAL_TABLES(TABLE) \
    ARGUMENT(__global const settings *, frame) ARGUMENT(__global const uint *, ray) ARGUMENT(__global uint *, flight) \
    ARGUMENT(uint, log2_batch_paths) ARGUMENT(__global uint *, counts)
TRACING_STAGE(classify_flights, CLASSIFY_FLIGHTS) {
    geometry g = BIND_GEOMETRY;
    texture_tables tables = BIND_TEXTURES;
    material_tables material_set = BIND_MATERIALS;
    uint found[wave_counts];
    for (int c = 0; c < wave_counts; ++c) found[c] = 0;
    for (size_t i = run_start; i < RUN_END; ++i) {
        flight_item f = load_flight(flight, capacity, i);
        if (f.t < 0.0f) continue;
        ray_item r = load_ray(ray, capacity, i);
        next_hop next = classify_flight(g, tables, material_set, frame, r, f);
        ++found[count_of_batches + (r.path >> log2_batch_paths)];
        STORE_FIELD(flight, uint, hop, flight, capacity, i, next.hop);
        STORE_FIELD(flight, uint, material, flight, capacity, i, next.material);
        if (next.hop < hops) ++found[next.hop];
        if (HAS_EMITTERS) {
            STORE_FIELD(flight, uint, emits, flight, capacity, i, (uint)next.emits);
            found[hop_emission] += (uint)next.emits;
        }
    }
    for (int c = 0; c < wave_counts; ++c)
        if (found[c]) atomic_add(counts + c, found[c]);
}
