/* ray -> intersection, slot i to slot i.  Finds the nearest hit of each ray. A tracing stage: each work-item handles the slots from
   `first_slot` to SLOTS_END, and skips dead ones. All rays are dead once the render is interrupted.
   LOAD_FIELD(queue, type, field, its buffer, capacity, slot) */
#include "trace/intersect_ray.clh"
#include "trace/interleaved.clh"
#include "stages/stage.clh"

/* Dead rays hit nothing. */
FN int begin_ray(traversal *w, __global const uint *ray, __global uint *intersection, uint capacity, __global const uint *stop, uint i) {
    if (LOAD_FIELD(ray, float, t_max, ray, capacity, i) < 0.0f || is_interrupted(stop)) {
        STORE_FIELD(intersection, float, t, intersection, capacity, i, -1.0f);
        return 0;
    }
    ray_item r = load_ray(ray, capacity, i);
    begin_traversal(w, r.o, r.d, r.time, r.t_max, no_aim());
    return 1;
}

#define BEGIN_RAY(w, i) begin_ray(w, ray, intersection, capacity, stop, i)
#define END_RAY(w) store_intersection(intersection, capacity, (w)->slot, intersection_of(&(w)->best))

#define INTERSECT_RAYS(TABLE, ARGUMENT) \
    GEOMETRY_TABLES(TABLE) TEXTURE_TABLES(TABLE) INTERRUPT_TABLES(TABLE) \
    ARGUMENT(__global const uint *, ray) ARGUMENT(__global uint *, intersection)
TRACING_STAGE(intersect_rays, INTERSECT_RAYS) {
    geometry g = BIND_GEOMETRY;
    texture_tables tables = BIND_TEXTURES;
    TRAVERSE_INTERLEAVED(g, tables, traversal_nearest, SLOTS_END, BEGIN_RAY, END_RAY);
}
