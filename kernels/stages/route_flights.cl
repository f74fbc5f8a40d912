/* ray, flight -> hit, scatter, miss, emission, next ray, shadow, path.  Makes the item that each flight's next stage wants, in that stage's
   dense segment. Tracing: space is reserved once for a run, not once for an item. */
#include "stages/queue.clh"
#include "trace/route.clh"
#include "trace/route_items.clh"
#include "stages/stage.clh"

/* Rays that pass an interface, and probes, have no shadow ray, and nothing lives in the slots after the last of them. */
FN void store_passage(__global uint *next_ray, __global uint *shadow, uint capacity, uint slot, ray_item r) {
    store_ray(next_ray, capacity, slot, r);
    STORE_FIELD(shadow, float, t_max, shadow, capacity, slot, -1.0f);
}
FN void end_passages(__global uint *next_ray, __global uint *shadow, uint capacity, uint count) {
    for (uint slot = count; slot % GROUP_SLOTS != 0; ++slot) {
        STORE_FIELD(ray, float, t_max, next_ray, capacity, slot, -1.0f);
        STORE_FIELD(shadow, float, t_max, shadow, capacity, slot, -1.0f);
    }
}

/* Segments of the hit queue begin at multiples of a group's slots, so that shading needs no guard (stages.h has the order). */
FN uint segment_start(__global const uint *counts, uint hop) {
    uint start = 0;
    for (uint h = 0; h < hop; ++h) start += (counts[h] + GROUP_SLOTS - 1u) & ~(GROUP_SLOTS - 1u);
    return start;
}

#define ROUTE_FLIGHTS(TABLE, ARGUMENT) \
    GEOMETRY_TABLES(TABLE) TEXTURE_TABLES(TABLE) MATERIAL_TABLES(TABLE) LIGHT_TABLES(TABLE) MEDIUM_TABLES(TABLE) COLOR_TABLES(TABLE) \
    ARGUMENT(__global const settings *, frame) ARGUMENT(__global const uint *, ray) ARGUMENT(__global const uint *, flight) \
    ARGUMENT(__global const uint *, counts) ARGUMENT(__global uint *, cursors) ARGUMENT(__global uint *, hit) \
    ARGUMENT(__global uint *, scatter) ARGUMENT(__global uint *, miss) ARGUMENT(__global uint *, emission) \
    ARGUMENT(__global uint *, next_ray) ARGUMENT(__global uint *, shadow) ARGUMENT(__global uint *, path)
TRACING_STAGE(route_flights, ROUTE_FLIGHTS) {
    geometry g = BIND_GEOMETRY;
    texture_tables tables = BIND_TEXTURES;
    material_tables material_set = BIND_MATERIALS;
    light_tables light_set = BIND_LIGHTS;
    medium_tables medium_set = BIND_MEDIA;
    color_tables color_set = BIND_COLORS;

    /* Count what this run sends to each queue, and reserve it */
    uint at[hops];
    for (int h = 0; h < hops; ++h) at[h] = 0;
    for (size_t i = run_start; i < RUN_END; ++i) {
        if (LOAD_FIELD(flight, float, t, flight, capacity, i) < 0.0f) continue;
        uint hop = LOAD_FIELD(flight, uint, hop, flight, capacity, i);
        if (hop < hops) ++at[hop];
        if (HAS_EMITTERS && LOAD_FIELD(flight, uint, emits, flight, capacity, i)) ++at[hop_emission];
    }
    for (uint h = 0; h < hops; ++h) {
        if (!at[h]) continue;
        uint start = h == hop_miss || h == hop_emission ? 0 : segment_start(counts, h);
        at[h] = start + atomic_add(cursors + h, at[h]);
    }

    /* Fill it */
    if (HAS_PASSAGES && run_start == 0) end_passages(next_ray, shadow, capacity, counts[hop_passage]);
    for (size_t i = run_start; i < RUN_END; ++i) {
        if (LOAD_FIELD(flight, float, t, flight, capacity, i) < 0.0f) continue;
        flight_item f = load_flight(flight, capacity, i);
        int emits = HAS_EMITTERS && f.emits;
        if (f.hop >= hops && !emits) continue;
        ray_item r = load_ray(ray, capacity, i);
        if (ENVIRONMENTS && f.hop == hop_miss) { store_miss(miss, capacity, at[hop_miss]++, make_miss(r)); continue; }
        if (HAS_MEDIA && f.hop == hop_scatter) {
            store_scatter(scatter, capacity, at[hop_scatter]++, choose_scatters_light(light_set, frame, make_scatter(medium_set, r, f)));
            continue;
        }
        if (HAS_DIFFUSION && r.body != NONE && f.element == NONE) {
            way_out w = make_way_out(material_set, color_set, r);
            w.hit = choose_hits_light(light_set, frame, w.hit, 0);
            store_way_out(hit, capacity, at[f.hop]++, tables, color_set, material_set, material_set.materials[f.material], w);
            continue;
        }
        surface s = flight_surface(g, tables, r, f);
        if (emits) store_emission(emission, capacity, at[hop_emission]++, make_emission(g, tables, light_set, color_set, r, f, s));
        if (HAS_DIFFUSION && r.body != NONE) store_passage(next_ray, shadow, capacity, at[hop_passage]++, make_probe(g, tables, material_set, r, f, s));
        else if (HAS_INTERFACE && f.hop == hop_passage) store_passage(next_ray, shadow, capacity, at[hop_passage]++, make_passage(g, r, f, s));
        else if (f.hop < hop_miss) {
            uint slot = at[f.hop]++;
            material m = material_set.materials[f.material];
            s = relieve_surface(tables, m, s);
            hit_item h = choose_hits_light(light_set, frame, make_hit(g, r, f, s, m), (int)m.transmits);
            if (HAS_DIFFUSION) h = place_probe(tables, material_set, color_set, m, h, s);
            store_shading(hit, capacity, slot, tables, color_set, material_set, m, h, s);
            if (HAS_AOVS && r.depth == 0) store_first_surface(g, frame, path, path_capacity, r, f, s);
        }
    }
}
