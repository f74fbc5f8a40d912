/* ray -> intersection, slot i to slot i.  Finds the nearest hit of each ray. A tracing stage; dead slots are skipped. */
#include "stages/queue.clh"
#include "trace/bvh.clh"
#include "eikonal/stages.h"
#include "stages/stage.clh"

FN intersection_item intersect_ray(geometry g, texture_tables tables, ray_item r) {
    nearest_hit best;
    best.t_max = r.t_max;
    walk_bvh(g, tables, r.o, r.d, r.time, walk_nearest, &best);
    intersection_item f = new_intersection();
    f.t = best.t_max;
    f.element = best.element;
    f.instance = best.instance;
    f.u = best.u;
    f.v = best.v;
    return f;
}

#ifndef AS_LIBRARY
#define INTERSECT_RAYS(TABLE, ARGUMENT) \
    GEOMETRY_TABLES(TABLE) TEXTURE_TABLES(TABLE) \
    ARGUMENT(__global const uint *, ray) ARGUMENT(__global uint *, intersection)
TRACING_STAGE(intersect_rays, INTERSECT_RAYS) {
    geometry g = BIND_GEOMETRY;
    texture_tables tables = BIND_TEXTURES;
    for (size_t i = first_slot; i < SLOTS_END; ++i) {
        if (LOAD_FIELD(ray, float, t_max, ray, capacity, i) < 0.0f) {
            STORE_FIELD(intersection, float, t, intersection, capacity, i, -1.0f);
            continue;
        }
        intersection_item f = intersect_ray(g, tables, load_ray(ray, capacity, i));
        f.next_queue = next_none; f.material = NONE; f.emits = 0u;
        store_intersection(intersection, capacity, i, f);
    }
}
#endif
