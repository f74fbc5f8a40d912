/* pixels -> path.  The stages' functions in a plain loop over each path: a reference that the wavefront must match bit by bit, and a
   baseline for performance (docs/performance.md). Each work-item has several paths. Its program includes shade_hit.clh for
   each BSDF of the scene, and lists them: SCENE_BSDFS(B) calls B(name) for each. */
#include "camera/start_path.clh"
#include "trace/intersect_ray.clh"
#include "medium/extinguish_ray.clh"
#include "trace/route.clh"
#include "shade/shade_miss.clh"
#include "shade/shade_occlusion.clh"
#include "shade/shade_scatter.clh"
#include "trace/test_shadow.clh"
#include "stages/stage.clh"

#define SHADE_CASE(name) \
    if (next_queue == next_##name) \
        return shade_##name(lights, colors, frame, h, bind_##name(h, load_##name(hit, capacity, slot), tables, colors), pass, 1);
FN scattering shade_any(light_tables lights, bsdf_tables tables, color_tables colors, __global const settings *frame,
                        __global const uint *hit, uint capacity, uint slot, uint next_queue, hit_item h, uint pass) {
    SCENE_BSDFS(SHADE_CASE)
    scattering nothing;
    nothing.ray.t_max = -1.0f;
    nothing.shadow = no_shadow(h.path);
    return nothing;
}

/* The albedo to store for denoisers, if the BSDF has one. */
typedef struct { spectrum albedo; int found; } kept_albedo;
#define ALBEDO_CASE(name) \
    if (next_queue == next_##name && !JOIN(SHADED(name), _is_delta)) { \
        k.albedo = JOIN(albedo_, SHADED(name))(bind_##name(h, load_##name(hit, capacity, slot), tables, colors)); \
        k.found = 1; \
    }
FN kept_albedo albedo_any(bsdf_tables tables, color_tables colors, __global const uint *hit, uint capacity, uint slot, uint next_queue,
                          hit_item h) {
    kept_albedo k = {uniform_spectrum(0.0f), 0};
    SCENE_BSDFS(ALBEDO_CASE)
    return k;
}

/* A path on its way: where its hit is stored, what left its last vertex, and rays still to follow, several with ray splitting. */
typedef struct {
    bsdf_tables bsdfs;
    __global uint *hit, *path;
    uint capacity, path_capacity, slot, shading_passes;
    scattering out;
    probe_item probe;
    ray_item waiting[MOST_WAITING_RAYS];
    uint rays;
} destinations;

FN void meet_light(scene_tables scene, destinations *to, shadow_item s) {
    if (s.t_max < 0.0f) return;
    spectrum L = test_shadow(scene.geometry, scene.tables, scene.media, scene.colors, s);
    if (is_black(L)) return;
    add_radiance(to->path, to->path_capacity, s.path, L, s.render_pass);
    add_to_group(to->path, to->path_capacity, s.path, L, s.group);
}

/* The shading stages, at once (trace/route_intersection.clh) */
FN uint reserve_hit(destinations *to, uint next_queue) { return to->slot; }
FN void send_probe(destinations *to, uint slot, probe_item p) { to->probe = p; }
FN void send_ray(destinations *to, ray_item r) { to->out.ray = r; }
FN void send_miss(scene_tables scene, destinations *to, miss_item m) {
    add_radiance(to->path, to->path_capacity, m.path, shade_miss(scene.lights, scene.colors, m), m.render_pass);
    add_to_groups(scene.lights, scene.colors, m, to->path, to->path_capacity, m.path);
}
FN void send_scatter(scene_tables scene, destinations *to, scatter_item s) {
    to->out = shade_scatter(scene.lights, scene.colors, scene.frame, s, 1);
}
FN void send_emission(destinations *to, emission_item e) {
    add_radiance(to->path, to->path_capacity, e.path, shade_emission(e), e.render_pass);
    add_to_group(to->path, to->path_capacity, e.path, shade_emission(e), e.group);
}
FN scattering shade_pass(scene_tables scene, destinations *to, uint next_queue, hit_item h, uint pass) {
    scattering out = shade_any(scene.lights, to->bsdfs, scene.colors, scene.frame, to->hit, to->capacity, to->slot, next_queue, h, pass);
    if (!may_scatter(scene.frame->max_depth, h.depth, h.within, h.uncounted)) out.ray.t_max = out.shadow.t_max = -1.0f;
    return out;
}
FN void send_hit(scene_tables scene, destinations *to, uint next_queue, uint slot, hit_item h) {
    kept_albedo k = {uniform_spectrum(1.0f), 1};
    if (HAS_AMBIENT_OCCLUSION && next_queue == next_occlusion)
        to->out.shadow = shade_occlusion(scene.colors, scene.frame, h, 1);
    else {
        to->out = shade_pass(scene, to, next_queue, h, 0u);
        if (HAS_AOVS) {
            k = albedo_any(to->bsdfs, scene.colors, to->hit, to->capacity, slot, next_queue, h);
            k.found &= !h.has_nonspecular_vertex;
        }
    }
    if (HAS_AOVS && k.found) store_albedo(to->path, to->path_capacity, h, k.albedo);
    meet_light(scene, to, to->out.shadow);
    to->out.shadow.t_max = -1.0f;
    for (uint pass = 1; pass < to->shading_passes; ++pass) {
        scattering more = shade_pass(scene, to, next_queue, h, pass);
        if (more.ray.t_max >= 0.0f) to->waiting[to->rays++] = more.ray;
        meet_light(scene, to, more.shadow);
    }
}

#include "trace/route_intersection.clh"

#define LOOP(TABLE, ARGUMENT) \
    GEOMETRY_TABLES(TABLE) TEXTURE_TABLES(TABLE) MATERIAL_TABLES(TABLE) LIGHT_TABLES(TABLE) BSDF_TABLES(TABLE) MEDIUM_TABLES(TABLE) \
    COLOR_TABLES(TABLE) CAMERA_TABLES(TABLE) \
    ARGUMENT(__global const settings *, frame) ARGUMENT(__global uint *, hit) ARGUMENT(__global uint *, path) BATCH_ARGUMENTS(ARGUMENT) \
    ARGUMENT(uint, shading_passes)
TRACING_STAGE(loop, LOOP) {
    scene_tables scene = BIND_SCENE;
    bsdf_tables bsdf_set = BIND_BSDFS;
    camera_tables camera_set = BIND_CAMERA;
    for (uint slot = (uint)first_slot; slot < SLOTS_END; ++slot) {
        destinations to;
        to.bsdfs = bsdf_set;
        to.hit = hit; to.path = path;
        to.capacity = capacity; to.path_capacity = path_capacity; to.slot = slot; to.shading_passes = shading_passes;

        pixel_sample at = LOCATE_PATH(slot);
        camera_path started = start_path(camera_set, wavelengths, frame, at.x, at.y, at.sample, slot, at.in_image);
        store_path(path, path_capacity, started.ray.path, started.path);
        clear_groups(path, path_capacity, started.ray.path);
        to.rays = 1;
        to.waiting[0] = started.ray;
        while (to.rays > 0) {
            ray_item r = to.waiting[--to.rays];
            while (r.t_max >= 0.0f && !is_interrupted(stop)) {
                /* Where the ray ends */
                intersection_item f = intersect_ray(scene.geometry, scene.tables, r);
                exit_point_item exit = new_exit_point();
                if (HAS_DIFFUSION && r.probe != NONE) {
                    traced_probe found = trace_probe(scene.geometry, scene.tables, scene.materials, scene.colors, r, to.probe);
                    f = found.intersection;
                    exit = found.exit;
                }
                if (HAS_MEDIA && r.medium != NONE) {
                    extinguished e = extinguish_ray(scene.media, scene.colors, r, f);
                    r = e.ray;
                    f = e.intersection;
                    if (!is_black(e.L)) {
                        add_radiance(path, path_capacity, r.path, e.L, pass_of_medium(r.render_pass));
                        add_to_group(path, path_capacity, r.path, e.L, DEFAULT_GROUP);
                    }
                }
                next_step next = classify_intersection(scene.geometry, scene.tables, scene.materials, frame, r, f);
                f.next_queue = next.next_queue;
                f.material = next.material;
                f.emits = (uint)next.emits;

                /* What is there, the light that it adds, and the ray that goes on */
                to.out.ray.t_max = -1.0f;
                to.out.shadow = no_shadow(r.path);
                if (f.next_queue < next_queues || f.emits) route_intersection(scene, &to, r, f, exit);
                meet_light(scene, &to, to.out.shadow);
                r = to.out.ray;
            }
        }
    }
}
