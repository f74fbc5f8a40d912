/* ray, intersection -> ray, intersection, path, slot i to slot i.  Applies media along each ray: absorption, scattering before the ray's
   end, transmittance and emission. A tracing stage; slots in vacuum are skipped. */
#include "stages/queue.clh"
#include "math/dimension.clh"
#include "medium/medium.clh"
#include "eikonal/stages.h"
#include "stages/stage.clh"

typedef struct { ray_item ray; intersection_item intersection; spectrum L; } extinguished;

FN extinguished extinguish_ray(medium_tables media, color_tables colors, ray_item r, intersection_item f) {
    tracked_path path = {hero_channel(r.seed, r.sample), r.beta, r.r_u, r.r_l, uniform_spectrum(0.0f)};
    /* Behind a null interface, continue with different random numbers, which depend on the distance travelled */
    random_stream more = make_stream(r.seed, r.sample, bounce_dimension_of(r.depth, dimension_distance));
    float first = sample_1d(r.seed, r.sample, bounce_dimension_of(r.depth, dimension_distance));
    if (HAS_INTERFACE && r.traveled > 0.0f) {
        more.key = hash_uint(more.key, as_uint(r.traveled));
        first = next_random(&more);
    }
    track end = sample_medium(media, path_wavelengths(colors, r.seed, r.sample), r.medium, r.o, r.d, f.t, first, &more, &path);
    r.beta = path.beta; r.r_u = path.r_u; r.r_l = path.r_l;
    if (end.end != track_passes) {
        f.next_queue = end.end == track_scattered ? next_scatter : next_absorbed;
        f.t = end.t;
        f.element = NONE;
    }
    extinguished out = {r, f, path.L};
    return out;
}

#ifndef AS_LIBRARY
#define EXTINGUISH_RAYS(TABLE, ARGUMENT) \
    MEDIUM_TABLES(TABLE) COLOR_TABLES(TABLE) \
    ARGUMENT(__global uint *, ray) ARGUMENT(__global uint *, intersection) ARGUMENT(__global uint *, path)
TRACING_STAGE(extinguish_rays, EXTINGUISH_RAYS) {
    medium_tables medium_set = BIND_MEDIA;
    color_tables color_set = BIND_COLORS;
    for (size_t i = first_slot; i < SLOTS_END; ++i) {
        if (LOAD_FIELD(ray, float, t_max, ray, capacity, i) < 0.0f) continue;
        if (LOAD_FIELD(ray, uint, medium, ray, capacity, i) == NONE) continue;
        extinguished e = extinguish_ray(medium_set, color_set, load_ray(ray, capacity, i), load_intersection(intersection, capacity, i));
        store_ray(ray, capacity, i, e.ray);
        store_intersection(intersection, capacity, i, e.intersection);
        if (!is_black(e.L)) add_radiance(path, path_capacity, e.ray.path, e.L);
    }
}
#endif
