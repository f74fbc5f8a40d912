/* intersection, ray, counts -> hit, next_ray, shadow.  Builds the hits of light paths, in the dense segments of their BSDFs, as
   route_intersections does for paths from the camera. Light paths end where they leave the scene, and add nothing where they meet other
   lights. A counting stage; each work-item reserves space once for all its slots. */
#include "eikonal/stages.h"
#include "light/emission.clh"
#include "stages/queue.clh"
#include "stages/stage.clh"
#include "trace/merging_chance.clh"
#include "trace/route_items.clh"
#include "trace/segments.clh"

/* At its first hit, a light path learns how densely paths from the camera go the other way, at last. */
FN hit_item arrive_from_light(scene_tables scene, __global const alias_entry *emission_aliases, hit_item h, ray_item r, float distance) {
    sampled_wavelengths colors = path_wavelengths(scene.colors, r.wavelength);
    emission e = sample_emission(scene.lights, emission_aliases, colors, scene.frame->emission_count, r.seed, r.sample);
    uint guide = HAS_ENVIRONMENT_GUIDE ? guide_map(scene.lights, h.p, choice_normal(h)) : 0u;
    float direct = direct_density(scene.lights, colors, e, h.p, h.wo, distance, guide);
    float away = e.place == place_POINT ? distance * distance : 1.0f;
    float inverse = away / max1(e.arrival * area_cosine(h.ng, h.wo), 1e-30f);
    int can_be_hit = (e.place == place_AREA && !e.l.invisible) || e.place == place_INFINITE;
    h.d_vcm = direct * inverse;
    h.d_vc = can_be_hit ? inverse : 0.0f;
    return h;
}

/* Light paths aim at no lights, and enter no bodies. */
FN hit_item aim_nowhere(hit_item h) {
    h.light = h.guide = h.light_texel = 0u;
    h.light_pmf = h.light_density = 0.0f;
    h.light_wi = h.ns;
    h.probe = NONE;
    return h;
}

#define ROUTE_LIGHT_PATHS(TABLE, ARGUMENT) \
    GEOMETRY_TABLES(TABLE) TEXTURE_TABLES(TABLE) MATERIAL_TABLES(TABLE) LIGHT_TABLES(TABLE) EMISSION_TABLES(TABLE) MEDIUM_TABLES(TABLE) \
    COLOR_TABLES(TABLE) \
    ARGUMENT(__global const settings *, frame) ARGUMENT(__global const uint *, ray) ARGUMENT(__global const uint *, intersection) \
    ARGUMENT(__global const uint *, counts) ARGUMENT(__global uint *, cursors) ARGUMENT(__global uint *, hit) \
    ARGUMENT(__global uint *, next_ray) ARGUMENT(__global uint *, shadow)
COUNTING_STAGE(route_light_paths, ROUTE_LIGHT_PATHS) {
    scene_tables scene = BIND_SCENE;
    uint at[next_miss];
    for (int q = 0; q < next_miss; ++q) at[q] = 0;
    for (size_t i = first_slot; i < COUNTING_SLOTS_END; ++i) {
        if (LOAD_FIELD(intersection, float, t, intersection, capacity, i) < 0.0f) continue;
        uint next_queue = LOAD_FIELD(intersection, uint, next_queue, intersection, capacity, i);
        if (next_queue < next_miss) ++at[next_queue];
    }
    for (uint q = 0; q < next_miss; ++q)
        if (at[q]) at[q] = segment_start(counts, q) + atomic_add(cursors + q, at[q]);
    if (HAS_INTERFACE && first_slot == 0) end_crossings(next_ray, shadow, capacity, counts[next_crossing]);
    for (size_t i = first_slot; i < COUNTING_SLOTS_END; ++i) {
        if (LOAD_FIELD(intersection, float, t, intersection, capacity, i) < 0.0f) continue;
        intersection_item f = load_intersection(intersection, capacity, i);
        if (f.next_queue >= next_miss) continue;
        ray_item r = load_ray(ray, capacity, i);
        uint slot = at[f.next_queue]++;
        float distance = f.t + (HAS_INTERFACE ? r.traveled : 0.0f);
        if (HAS_MEDIA && f.next_queue == NEXT_IN_MEDIUM) {
            hit_item h = arrive_in_volume(scene.frame, aim_nowhere(make_volume_hit(r, f)), r, f);
            h.render_pass = pass_volume;
            if (r.depth == 0u) h = arrive_from_light(scene, emission_aliases, h, r, distance);
            store_volume_hit(hit, capacity, slot, scene.media, h);
            continue;
        }
        surface s = intersection_surface(scene.geometry, scene.tables, r, f);
        if (HAS_INTERFACE && f.next_queue == next_crossing) {
            store_crossing(next_ray, shadow, capacity, slot, make_crossing(scene.geometry, r, f, s));
            continue;
        }
        material m = scene.materials.materials[f.material];
        float chance = HAS_MERGING ? merging_chance(scene.geometry, scene.tables, scene.materials, r, f, s) : 1.0f;
        s = perturb_normal(scene.tables, m, s);
        hit_item h = aim_nowhere(make_hit(scene.geometry, r, f, s, m));
        h.render_pass = pass_of_light_path(r.depth);
        /* Where nothing from the camera is comparable, the path ends: its hit has no throughput */
        h = arrive(frame, scene.geometry, h, r, f, m);
        h.merging_chance = chance;
        if (ends_light_paths(scene.geometry, f, m)) h.beta = uniform_spectrum(0.0f);
        else if (r.depth == 0u) h = arrive_from_light(scene, emission_aliases, h, r, distance);
        store_hit_and_bsdf(hit, capacity, slot, scene.tables, scene.colors, scene.materials, m, h, s);
    }
}
