/* ray, flight -> flight, in place.  Which queue each flight goes to next, and how many go to each: route_flights needs the totals
   to know where each queue's segment begins. Tracing: counts are added up within a run, one atomic for each queue. */
#include "queue.clh"
#include "route.clh"

TRACING_STAGE classify_flights(GEOMETRY_ARGUMENTS TEXTURE_ARGUMENTS MATERIAL_ARGUMENTS
                       __global const settings *frame, __global const uint *ray, __global uint *flight, uint capacity, uint count,
                       __global uint *counts, __global uint *tally) {
    geometry g = BIND_GEOMETRY;
    texture_tables tables = BIND_TEXTURES;
    material_tables material_set = BIND_MATERIALS;
    uint found[hops];
    uint rays = 0;
    for (int h = 0; h < hops; ++h) found[h] = 0;
    size_t first = get_global_id(0) * RUN, last = min(first + RUN, (size_t)count);
    for (size_t i = first; i < last; ++i) {
        flight_item f = load_flight(flight, capacity, i);
        if (f.t < 0.0f) continue;
        ++rays;
        next_hop next = classify_flight(g, tables, material_set, frame, load_ray(ray, capacity, i), f);
        STORE_FIELD(flight, uint, hop, flight, capacity, i, next.hop);
        STORE_FIELD(flight, uint, material, flight, capacity, i, next.material);
        if (next.hop < hops) ++found[next.hop];
        if (HAS_EMITTERS && next.emits) ++found[hop_emission];
    }
    for (int h = 0; h < hops; ++h)
        if (found[h]) atomic_add(counts + h, found[h]);
    if (rays) atomic_add(tally + tally_rays, rays);
}
