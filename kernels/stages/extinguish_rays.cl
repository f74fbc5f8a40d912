/* ray, intersection -> ray, intersection, path, slot i to slot i.  Applies media along each ray: absorption, scattering before the ray's
   end, transmittance and emission. A tracing stage; slots in vacuum are skipped. Light paths have no path states: those
   that they write to are set when paths from the camera begin. */
#include "medium/extinguish_ray.clh"
#include "shade/render_pass.clh"
#include "stages/stage.clh"

#define EXTINGUISH_RAYS(TABLE, ARGUMENT) \
    MEDIUM_TABLES(TABLE) COLOR_TABLES(TABLE) \
    ARGUMENT(__global uint *, ray) ARGUMENT(__global uint *, intersection) ARGUMENT(__global uint *, path)
TRACING_STAGE(extinguish_rays, EXTINGUISH_RAYS) {
    medium_tables medium_set = BIND_MEDIA;
    color_tables color_set = BIND_COLORS;
    for (size_t i = first_slot; i < SLOTS_END; ++i) {
        if (is_interrupted(stop)) return;
        if (LOAD_FIELD(ray, float, t_max, ray, capacity, i) < 0.0f) continue;
        if (LOAD_FIELD(ray, uint, medium, ray, capacity, i) == NONE) continue;
        extinguished e = extinguish_ray(medium_set, color_set, load_ray(ray, capacity, i), load_intersection(intersection, capacity, i));
        store_ray(ray, capacity, i, e.ray);
        store_intersection(intersection, capacity, i, e.intersection);
        if (is_black(e.L)) continue;
        add_radiance(path, path_capacity, e.ray.path, e.L, pass_of_medium(e.ray.render_pass));
        add_to_group(path, path_capacity, e.ray.path, e.L, DEFAULT_GROUP);
    }
}
