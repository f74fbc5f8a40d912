/* ray, intersection, counts -> hit, scatter, miss, emission, next ray, shadow, path.  Builds the item for each intersection's next stage, in that
   stage's dense segment. A tracing stage; each work-item reserves space once for all its slots. */
#include "stages/queue.clh"
#include "trace/route.clh"
#include "trace/route_items.clh"
#include "stages/stage.clh"

/* Rays that pass a null interface, and probe rays, have no shadow ray. Slots between the last of them and the end of the group are dead. */
FN void store_crossing(__global uint *next_ray, __global uint *shadow, uint capacity, uint slot, ray_item r) {
    store_ray(next_ray, capacity, slot, r);
    STORE_FIELD(shadow, float, t_max, shadow, capacity, slot, -1.0f);
}
FN void end_crossings(__global uint *next_ray, __global uint *shadow, uint capacity, uint count) {
    for (uint slot = count; slot % GROUP_SLOTS != 0; ++slot) {
        STORE_FIELD(ray, float, t_max, next_ray, capacity, slot, -1.0f);
        STORE_FIELD(shadow, float, t_max, shadow, capacity, slot, -1.0f);
    }
}

/* Segments of the hit queue start at multiples of GROUP_SLOTS, so shading needs no bounds check (stages.h has their order). */
FN uint segment_start(__global const uint *counts, uint next_queue) {
    uint start = 0;
    for (uint h = 0; h < next_queue; ++h) start += (counts[h] + GROUP_SLOTS - 1u) & ~(GROUP_SLOTS - 1u);
    return start;
}

#define ROUTE_INTERSECTIONS(TABLE, ARGUMENT) \
    GEOMETRY_TABLES(TABLE) TEXTURE_TABLES(TABLE) MATERIAL_TABLES(TABLE) LIGHT_TABLES(TABLE) MEDIUM_TABLES(TABLE) COLOR_TABLES(TABLE) \
    ARGUMENT(__global const settings *, frame) ARGUMENT(__global const uint *, ray) ARGUMENT(__global const uint *, intersection) \
    ARGUMENT(__global const uint *, counts) ARGUMENT(__global uint *, cursors) ARGUMENT(__global uint *, hit) \
    ARGUMENT(__global uint *, scatter) ARGUMENT(__global uint *, miss) ARGUMENT(__global uint *, emission) \
    ARGUMENT(__global uint *, next_ray) ARGUMENT(__global uint *, shadow) ARGUMENT(__global uint *, path)
TRACING_STAGE(route_intersections, ROUTE_INTERSECTIONS) {
    geometry g = BIND_GEOMETRY;
    texture_tables tables = BIND_TEXTURES;
    material_tables material_set = BIND_MATERIALS;
    light_tables light_set = BIND_LIGHTS;
    medium_tables medium_set = BIND_MEDIA;
    color_tables color_set = BIND_COLORS;

    /* Count the items that this work-item adds to each queue, and reserve space for them */
    uint at[next_queues];
    for (int h = 0; h < next_queues; ++h) at[h] = 0;
    for (size_t i = first_slot; i < SLOTS_END; ++i) {
        if (LOAD_FIELD(intersection, float, t, intersection, capacity, i) < 0.0f) continue;
        uint next_queue = LOAD_FIELD(intersection, uint, next_queue, intersection, capacity, i);
        if (next_queue < next_queues) ++at[next_queue];
        if (HAS_EMITTERS && LOAD_FIELD(intersection, uint, emits, intersection, capacity, i)) ++at[next_emission];
    }
    for (uint h = 0; h < next_queues; ++h) {
        if (!at[h]) continue;
        uint start = h == next_miss || h == next_emission ? 0 : segment_start(counts, h);
        at[h] = start + atomic_add(cursors + h, at[h]);
    }

    /* Fill the reserved space */
    if (HAS_CROSSINGS && first_slot == 0) end_crossings(next_ray, shadow, capacity, counts[next_crossing]);
    for (size_t i = first_slot; i < SLOTS_END; ++i) {
        if (LOAD_FIELD(intersection, float, t, intersection, capacity, i) < 0.0f) continue;
        intersection_item f = load_intersection(intersection, capacity, i);
        int emits = HAS_EMITTERS && f.emits;
        if (f.next_queue >= next_queues && !emits) continue;
        ray_item r = load_ray(ray, capacity, i);
        if (ENVIRONMENTS && f.next_queue == next_miss) { store_miss(miss, capacity, at[next_miss]++, make_miss(r)); continue; }
        if (HAS_MEDIA && f.next_queue == next_scatter) {
            store_scatter(scatter, capacity, at[next_scatter]++, choose_scatters_light(light_set, frame, make_scatter(medium_set, r, f)));
            continue;
        }
        if (HAS_DIFFUSION && r.body != NONE && f.element == NONE) {
            exit_vertex w = make_exit_vertex(material_set, color_set, r);
            w.hit = choose_hits_light(light_set, frame, w.hit, 0);
            store_exit_vertex(hit, capacity, at[f.next_queue]++, tables, color_set, material_set, material_set.materials[f.material], w);
            continue;
        }
        surface s = intersection_surface(g, tables, r, f);
        if (emits) store_emission(emission, capacity, at[next_emission]++, make_emission(g, tables, light_set, color_set, r, f, s));
        if (HAS_DIFFUSION && r.body != NONE) store_crossing(next_ray, shadow, capacity, at[next_crossing]++, make_probe(g, tables, material_set, r, f, s));
        else if (HAS_INTERFACE && f.next_queue == next_crossing) store_crossing(next_ray, shadow, capacity, at[next_crossing]++, make_crossing(g, r, f, s));
        else if (f.next_queue < next_miss) {
            uint slot = at[f.next_queue]++;
            material m = material_set.materials[f.material];
            s = perturb_normal(tables, m, s);
            hit_item h = choose_hits_light(light_set, frame, make_hit(g, r, f, s, m), (int)m.transmits);
            if (HAS_DIFFUSION) h = place_probe(tables, material_set, color_set, m, h, s);
            store_shading(hit, capacity, slot, tables, color_set, material_set, m, h, s);
            if (HAS_AOVS && r.depth == 0) store_first_surface(g, frame, path, path_capacity, r, f, s);
        }
    }
}
