/* shadow -> path.  Adds the light that nothing is in the way of. Tracing: a run of slots for each work-item. */
#include "queue.clh"
#include "bvh.clh"
#include "eikonal/stages.h"

FN spectrum test_shadow(geometry g, texture_tables tables, shadow_item s) {
    nearest_hit any;
    any.t_max = s.t_max;
    if (walk_bvh(g, tables, s.o, s.d, 1, &any)) return uniform_spectrum(0.0f);
    return s.Ld;
}

#ifndef AS_LIBRARY
STAGE test_shadows(GEOMETRY_ARGUMENTS TEXTURE_ARGUMENTS
                   __global const uint *shadow, __global uint *path, uint capacity, uint count, __global uint *tally) {
    geometry g = BIND_GEOMETRY;
    texture_tables tables = BIND_TEXTURES;
    size_t first = get_global_id(0) * RUN, last = min(first + RUN, (size_t)count);
    uint tested = 0;
    for (size_t i = first; i < last; ++i) {
        if (LOAD_FIELD(shadow, float, t_max, shadow, capacity, i) < 0.0f) continue;
        ++tested;
        shadow_item s = load_shadow(shadow, capacity, i);
        spectrum L = test_shadow(g, tables, s);
        if (!is_black(L)) add_radiance(path, capacity, s.path, L);
    }
    if (tested) atomic_add(tally + tally_shadow_rays, tested);
}
#endif
