/* ray -> intersection, slot i to slot i.  Finds the nearest hit of each ray. A tracing stage: each work-item handles the slots from
   `first_slot` to SLOTS_END, and skips dead ones. All rays are dead once the render is interrupted.
   LOAD_FIELD(queue, type, field, its buffer, capacity, slot) */
#include "trace/intersect_ray.clh"
#include "stages/stage.clh"

#define INTERSECT_RAYS(TABLE, ARGUMENT) \
    GEOMETRY_TABLES(TABLE) TEXTURE_TABLES(TABLE) INTERRUPT_TABLES(TABLE) \
    ARGUMENT(__global const uint *, ray) ARGUMENT(__global uint *, intersection)
TRACING_STAGE(intersect_rays, INTERSECT_RAYS) {
    geometry g = BIND_GEOMETRY;
    texture_tables tables = BIND_TEXTURES;
    for (size_t i = first_slot; i < SLOTS_END; ++i) {
        if (LOAD_FIELD(ray, float, t_max, ray, capacity, i) < 0.0f || is_interrupted(stop)) {
            STORE_FIELD(intersection, float, t, intersection, capacity, i, -1.0f);
            continue;
        }
        store_intersection(intersection, capacity, i, intersect_ray(g, tables, load_ray(ray, capacity, i)));
    }
}
