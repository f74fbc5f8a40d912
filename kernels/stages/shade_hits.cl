/* hit -> next_ray, shadow, walk, slot i to slot i; path.  Scatters each path at a surface: one shadow ray to one light, and one scattered
   ray (shade/shade_hit.clh). With ray splitting the stage runs in passes: pass r makes the r-th scattered ray, in slot i + r * pass_slots,
   and the shadow ray to the r-th light. Built once per BSDF (the macro BSDF), over that BSDF's segment of the hit queue. */
#include "shade/shade_slot.clh"
#include "stages/stage.clh"

#define SHADE_HITS(TABLE, ARGUMENT) \
    LIGHT_TABLES(TABLE) BSDF_TABLES(TABLE) COLOR_TABLES(TABLE) \
    ARGUMENT(__global const settings *, frame) ARGUMENT(__global const uint *, hit) ARGUMENT(__global uint *, next_ray) \
    ARGUMENT(__global uint *, shadow) ARGUMENT(__global uint *, path) ARGUMENT(__global uint *, walk) ARGUMENT(uint, first) \
    ARGUMENT(uint, shading_pass) ARGUMENT(uint, pass_slots)
STAGE(shade_hits, SHADE_HITS) {
    light_tables light_set = BIND_LIGHTS;
    bsdf_tables bsdf_set = BIND_BSDFS;
    color_tables color_set = BIND_COLORS;
    WALK_LAYERS /* Layered BSDFs: first all slots walk between their layers, in step; shade_slot reads where the walks ended */
    FOR_EACH_SLOT_OF_GROUP(at, count) {
        size_t i = first + at, to = slot_of_next_ray(i, shading_pass, pass_slots);
        int alive = at < count;
        if (SKIPS_DEAD_SLOTS && !alive) { /* where the BSDF loops; elsewhere dead slots run along */
            STORE_FIELD(ray, float, t_max, next_ray, capacity, to, -1.0f);
            STORE_FIELD(shadow, float, t_max, shadow, capacity, i, -1.0f);
            continue;
        }
        hit_item h = load_hit(hit, capacity, i);
        BSDF_BOUND b = BIND_BSDF(h, LOAD_BSDF(hit, capacity, i), bsdf_set, color_set);
        /* Store the rays of SHADE_BSDF; for layered BSDFs, those with which the walks ended */
        shade_slot(light_set, color_set, frame, h, b, shading_pass, alive, next_ray, to, shadow, walk, capacity, i);
        /* At max_depth a hit comes here for its albedo alone (within, uncounted: feature_fields.h) */
        if (HAS_AOVS && !may_scatter(frame->max_depth, h.depth, h.within, h.uncounted)) {
            STORE_FIELD(ray, float, t_max, next_ray, capacity, to, -1.0f);
            STORE_FIELD(shadow, float, t_max, shadow, capacity, i, -1.0f);
        }
        if (HAS_AOVS && !BSDF_IS_DELTA && alive && !h.has_nonspecular_vertex)
            store_albedo(path, path_capacity, h, ALBEDO_BSDF(b));
    }
}
