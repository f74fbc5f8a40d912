/* hit, cached -> connection, shadow, slot i to slot i.  Chooses a hit of a light path for each hit of a path from the camera, and aims a
   shadow ray at it (shade/connect_hit.clh). A tracing stage, built once per BSDF, over that BSDF's segment of the hit queue. */
#include "stages/stage.clh"
#include "bsdf/bsdf_names.clh"
#include "shade/connect_hit.clh"

#define CONNECT_HITS(TABLE, ARGUMENT) \
    BSDF_TABLES(TABLE) COLOR_TABLES(TABLE) \
    ARGUMENT(__global const settings *, frame) ARGUMENT(__global const uint *, hit) ARGUMENT(__global const uint *, cached) \
    ARGUMENT(__global const uint *, cached_last) ARGUMENT(uint, cached_pass_mask) ARGUMENT(__global uint *, connection) \
    ARGUMENT(__global uint *, shadow) ARGUMENT(uint, first)
TRACING_STAGE(connect_hits, CONNECT_HITS) {
    if (BSDF_IS_DELTA) return;
    bsdf_tables bsdf_set = BIND_BSDFS;
    color_tables color_set = BIND_COLORS;
    for (size_t at = first_slot; at < SLOTS_END; ++at) {
        size_t i = first + at;
        STORE_FIELD(shadow, float, t_max, shadow, capacity, i, -1.0f);
        hit_item h = load_hit(hit, capacity, i);
        if (counted_events(h) + 2u > frame->max_depth || is_deep_in_body(h) || !(max_component(h.beta) > 0.0f)) continue;
        chosen_hit other = choose_cached_hit(frame, h, cached, cached_last, cached_pass_mask);
        if (other.record == NONE) continue;
        BSDF_BOUND b = BIND_BSDF(h, LOAD_BSDF(hit, capacity, i), bsdf_set, color_set);
        aimed_connection c = AIM_AT_HIT_BSDF(h, b, other);
        store_connection(connection, capacity, i, c.connection);
        store_shadow(shadow, capacity, i, c.shadow);
    }
}
