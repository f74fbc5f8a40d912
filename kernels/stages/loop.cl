/* pixels -> path.  The stages' functions in a plain loop over each path: a reference that the wavefront must match bit by bit, and a
   baseline for performance (docs/performance.md). Each work-item has several paths. Its program defines AS_LIBRARY, includes shade_hits.cl
   for each BSDF of the scene, and lists them: SCENE_BSDFS(B) calls B(name) for each. */
#include "stages/generate_rays.cl"
#include "stages/intersect_rays.cl"
#include "stages/extinguish_rays.cl"
#include "trace/route.clh"
#include "trace/route_items.clh"
#include "stages/shade_misses.cl"
#include "stages/shade_occlusions.cl"
#include "stages/shade_scatters.cl"
#include "stages/test_shadows.cl"
#include "stages/stage.clh"

#define SHADE_CASE(name) if (next_queue == next_##name) return JOIN(shade_, name)(lights, colors, frame, h, bind_tables(JOIN(load_, name)(hit, capacity, slot), tables, path_wavelengths(colors, h.seed, h.sample)), pass, 1);
FN scattering shade_any(light_tables lights, bsdf_tables tables, color_tables colors, __global const settings *frame, __global const uint *hit, uint capacity, uint slot, uint next_queue, hit_item h, uint pass) {
    SCENE_BSDFS(SHADE_CASE)
    scattering nothing;
    nothing.ray.t_max = -1.0f;
    nothing.shadow = no_shadow(h.path);
    return nothing;
}

/* The albedo to store for denoisers, if the BSDF has one. */
typedef struct { spectrum albedo; int found; } kept_albedo;
#define ALBEDO_CASE(name) if (next_queue == next_##name && !JOIN(name, _is_delta)) { k.albedo = JOIN(albedo_, name)(bind_tables(JOIN(load_, name)(hit, capacity, slot), tables, colors)); k.found = 1; }
FN kept_albedo albedo_any(bsdf_tables tables, sampled_wavelengths colors, __global const uint *hit, uint capacity, uint slot, uint next_queue) {
    kept_albedo k = {uniform_spectrum(0.0f), 0};
    SCENE_BSDFS(ALBEDO_CASE)
    return k;
}

FN void meet_light(geometry g, texture_tables tables, medium_tables media, color_tables colors, __global uint *path, uint path_capacity, shadow_item s) {
    if (s.t_max < 0.0f) return;
    spectrum L = test_shadow(g, tables, media, colors, s);
    if (!is_black(L)) add_radiance(path, path_capacity, s.path, L);
}

#define LOOP(TABLE, ARGUMENT) \
    GEOMETRY_TABLES(TABLE) TEXTURE_TABLES(TABLE) MATERIAL_TABLES(TABLE) LIGHT_TABLES(TABLE) BSDF_TABLES(TABLE) MEDIUM_TABLES(TABLE) \
    COLOR_TABLES(TABLE) CAMERA_TABLES(TABLE) \
    ARGUMENT(__global const settings *, frame) ARGUMENT(__global uint *, hit) ARGUMENT(__global uint *, path) BATCH_ARGUMENTS(ARGUMENT) \
    ARGUMENT(uint, shading_passes)
TRACING_STAGE(loop, LOOP) {
    geometry g = BIND_GEOMETRY;
    texture_tables tables = BIND_TEXTURES;
    material_tables material_set = BIND_MATERIALS;
    light_tables light_set = BIND_LIGHTS;
    bsdf_tables bsdf_set = BIND_BSDFS;
    medium_tables medium_set = BIND_MEDIA;
    color_tables color_set = BIND_COLORS;
    camera_tables camera_set = BIND_CAMERA;
    for (uint slot = (uint)first_slot; slot < SLOTS_END; ++slot) {
        pixel_sample at = LOCATE_PATH(slot);
        camera_path started = start_path(camera_set, frame, at.x, at.y, at.sample, slot, at.in_image);
        store_path(path, path_capacity, started.ray.path, started.path);

        /* Rays still to follow; several with ray splitting */
        ray_item waiting[HAS_TREE ? MOST_TREE_RAYS : 1];
        uint rays = 1;
        waiting[0] = started.ray;
        while (rays > 0) {
            ray_item r = waiting[--rays];
            while (r.t_max >= 0.0f) {
                /* Intersect, sample the medium, classify */
                intersection_item f = intersect_ray(g, tables, r);
                f.next_queue = next_none;
                f.material = NONE;
                if (HAS_MEDIA && r.medium != NONE) {
                    extinguished e = extinguish_ray(medium_set, color_set, r, f);
                    r = e.ray;
                    f = e.intersection;
                    if (!is_black(e.L)) add_radiance(path, path_capacity, r.path, e.L);
                }
                next_step next = classify_intersection(g, tables, material_set, frame, r, f);
                f.next_queue = next.next_queue;
                f.material = next.material;

                scattering out;
                out.ray = r;
                out.ray.t_max = -1.0f;
                out.shadow = no_shadow(r.path);
                if (ENVIRONMENTS && f.next_queue == next_miss) add_radiance(path, path_capacity, r.path, shade_miss(light_set, color_set, make_miss(r)));
                else if (HAS_MEDIA && f.next_queue == next_scatter) out = shade_scatter(light_set, color_set, frame, choose_scatters_light(light_set, frame, make_scatter(medium_set, r, f)), 1);
                else if (HAS_DIFFUSION && r.body != NONE && f.next_queue < next_miss) {
                    if (f.next_queue == next_crossing) out.ray = make_probe(g, tables, material_set, r, f, intersection_surface(g, tables, r, f));
                    else {
                        exit_vertex e = make_exit_vertex(material_set, color_set, r);
                        e.hit = choose_hits_light(light_set, frame, e.hit, 0);
                        store_exit_vertex(hit, capacity, slot, tables, color_set, material_set, material_set.materials[f.material], e);
                        out = shade_any(light_set, bsdf_set, color_set, frame, hit, capacity, slot, f.next_queue, e.hit, 0u);
                        if (HAS_AOVS && !e.hit.has_nonspecular_vertex) {
                            kept_albedo k = albedo_any(bsdf_set, path_wavelengths(color_set, e.hit.seed, e.hit.sample), hit, capacity, slot, f.next_queue);
                            if (k.found) STORE_FIELD(path, spectrum, albedo, path, path_capacity, r.path, seen_albedo(e.hit, k.albedo));
                        }
                    }
                }
                else if (f.element != NONE) {
                    surface s = intersection_surface(g, tables, r, f);
                    if (HAS_EMITTERS && next.emits) {
                        emission_item e = make_emission(g, tables, light_set, color_set, r, f, s);
                        add_radiance(path, path_capacity, r.path, weigh_emission(e.beta, e.Le, e.r_u, e.r_l, e.pdf, e.pdf_light));
                    }
                    if (HAS_INTERFACE && f.next_queue == next_crossing) out.ray = make_crossing(g, r, f, s);
                    else if (HAS_AMBIENT_OCCLUSION && f.next_queue == next_occlusion) {
                        hit_item h = make_hit(g, r, f, s, material_set.materials[f.material]);
                        out.shadow = shade_occlusion(color_set, frame, h, 1);
                        if (HAS_AOVS) store_first_surface(g, frame, path, path_capacity, r, f, s);
                        if (HAS_AOVS) STORE_FIELD(path, spectrum, albedo, path, path_capacity, r.path, seen_albedo(h, uniform_spectrum(1.0f)));
                    } else if (f.next_queue < next_miss) {
                        material m = material_set.materials[f.material];
                        s = perturb_normal(tables, m, s);
                        hit_item h = choose_hits_light(light_set, frame, make_hit(g, r, f, s, m), (int)m.transmits);
                        if (HAS_DIFFUSION) h = place_probe(tables, material_set, color_set, m, h, s);
                        store_shading(hit, capacity, slot, tables, color_set, material_set, m, h, s);
                        out = shade_any(light_set, bsdf_set, color_set, frame, hit, capacity, slot, f.next_queue, h, 0u);
                        if (HAS_TREE) { meet_light(g, tables, medium_set, color_set, path, path_capacity, out.shadow); out.shadow.t_max = -1.0f; }
                        for (uint pass = 1; HAS_TREE && pass < shading_passes; ++pass) {
                            scattering more = shade_any(light_set, bsdf_set, color_set, frame, hit, capacity, slot, f.next_queue, h, pass);
                            if (more.ray.t_max >= 0.0f) waiting[rays++] = more.ray;
                            meet_light(g, tables, medium_set, color_set, path, path_capacity, more.shadow);
                        }
                        if (HAS_AOVS && r.depth == 0) store_first_surface(g, frame, path, path_capacity, r, f, s);
                        if (HAS_AOVS && !h.has_nonspecular_vertex) {
                            kept_albedo k = albedo_any(bsdf_set, path_wavelengths(color_set, h.seed, h.sample), hit, capacity, slot, f.next_queue);
                            if (k.found) STORE_FIELD(path, spectrum, albedo, path, path_capacity, r.path, seen_albedo(h, k.albedo));
                        }
                    }
                }

                /* Test the shadow ray, then continue with the scattered ray */
                meet_light(g, tables, medium_set, color_set, path, path_capacity, out.shadow);
                r = out.ray;
            }
        }
    }
}
