/* connection, hit, cached, shadow -> shadow, slot i to slot i.  Gives each connection whose other end has this BSDF the light that comes
   from there (shade/shade_connection.clh). A tracing stage, built once per BSDF, over all slots. */
#include "eikonal/stages.h"
#include "stages/stage.clh"
#include "bsdf/bsdf_names.clh"
#include "shade/shade_connection.clh"

#define SHADE_CONNECTIONS(TABLE, ARGUMENT) \
    BSDF_TABLES(TABLE) COLOR_TABLES(TABLE) \
    ARGUMENT(__global const uint *, connection) ARGUMENT(__global const uint *, hit) ARGUMENT(__global const uint *, cached) \
    ARGUMENT(__global const uint *, cached_hit) ARGUMENT(uint, cached_hit_size) ARGUMENT(__global uint *, shadow)
TRACING_STAGE(shade_connections, SHADE_CONNECTIONS) {
    if (BSDF_IS_DELTA) return;
    bsdf_tables bsdf_set = BIND_BSDFS;
    color_tables color_set = BIND_COLORS;
    for (size_t i = first_slot; i < SLOTS_END; ++i) {
        if (LOAD_FIELD(shadow, float, t_max, shadow, capacity, i) < 0.0f) continue;
        connection_item c = load_connection(connection, capacity, i);
        if (LOAD_FIELD(cached, uint, bsdf, cached, 1, (size_t)c.cached * CACHED_STRIDE) != JOIN(next_, BSDF)) continue;
        size_t of_light = cached_hit_at(cached_hit_size, c.cached);
        hit_item h = load_hit(cached_hit, 1, of_light);
        BSDF_BOUND b = BIND_BSDF(h, LOAD_BSDF(cached_hit, 1, of_light), bsdf_set, color_set);
        spectrum sent = SEND_ALONG_BSDF(h, b, LOAD_FIELD(hit, vec3, p, hit, capacity, i), c);
        spectrum L = mul(LOAD_FIELD(shadow, spectrum, Ld, shadow, capacity, i), sent);
        if (HAS_MEDIA) {
            /* As joined_density: test_shadows divides by the mean of r_l */
            spectrum r_l = LOAD_FIELD(shadow, spectrum, r_l, shadow, capacity, i);
            STORE_FIELD(shadow, spectrum, r_l, shadow, capacity, i,
                        HAS_SPECTRAL ? mul(r_l, h.r_u) : mul(r_l, max1(mean_component(h.r_u), 1e-30f)));
        }
        STORE_FIELD(shadow, spectrum, Ld, shadow, capacity, i, L);
        if (!(max_component(L) > 0.0f)) STORE_FIELD(shadow, float, t_max, shadow, capacity, i, -1.0f);
    }
}
