/* Every stage of a wave, in the order in which they run: a kernel that reads queues and writes queues.
     S(stage, (what it reads), (what it may write), what it runs over, its form, FEATURE that makes it exist)
   A wave is the paths in flight; the stages take each of them one bounce further. Paths come in batches: samples of some blocks of the
   image. A stage runs over what the fourth column says: the items of one next_queue, or one of enum stage_items. Besides queues (queues.h)
   there are
     next_ray   the ray queue of the next bounce
     pixels     blocks of the image
     film       the sums of their samples
     splat      sums of what light paths add to pixels
     cached     hits of light paths that are kept, path by path
     vertex     stored vertices of light paths
     grid       the hash grid that finds them
     counts     how many items go to each next_queue, and how many rays each batch has (enum wave_count)
   FEATURE is one of features.h (HAS_x in kernels), ALWAYS, or ENVIRONMENTS: at least one infinite light (host/pack/scene_constants.h).

   Stages have three forms (kernels/stages/stage.clh):
     straight_line   has no loop or branch that depends on data: the compiler vectorises it over slots, so it runs on to the end of the
                     last work-group, over dead slots
     tracing         loops and branches: it stops at the last item and skips dead slots
     counting        a tracing stage that adds to counters of all work-items, or puts items side by side. A work-item has the slots of
                     COUNTING_GROUPS work-groups of other stages, so that threads seldom wait for a cache line that another has written

   A stage called x is kernels/stages/x.cl, whose head repeats both lists (tests/unit/stages_test.cpp compares them with its arguments).
   Its profiler row and its test are called x too. */
#ifndef EIKONAL_STAGES_H
#define EIKONAL_STAGES_H
#include "eikonal/batch.h"
#include "eikonal/bsdfs.h"
#include "eikonal/portable.h"
CONTRACT_BEGIN /* namespace eikonal, in C++ */

#define COUNTING_GROUPS 16

#define STAGES(S) \
    /* A camera ray for each sample */ \
    S(generate_rays, (pixels), (ray, path), each_sample, straight_line, ALWAYS) \
    /* The nearest intersection of each ray; where paths leave subsurface bodies; absorption, scattering and emission in media */ \
    S(intersect_rays, (ray), (intersection), each_ray, tracing, ALWAYS) \
    S(trace_probes, (ray, probe), (intersection, exit_point), each_ray, tracing, DIFFUSION) \
    S(extinguish_rays, (intersection, ray), (ray, intersection, path), each_ray, tracing, MEDIA) \
    /* Choose the next queue of each intersection and count its items; then build the items */ \
    S(classify_intersections, (intersection, ray), (intersection, counts), each_ray, counting, ALWAYS) \
    S(route_intersections, (intersection, ray, counts, exit_point), (hit, scatter, miss, emission, next_ray, shadow, path, probe), \
      each_intersection, counting, ALWAYS) \
    /* Add the light of infinite lights and of surfaces that emit */ \
    S(shade_misses, (miss), (path), next_miss, straight_line, ENVIRONMENTS) \
    S(shade_emitters, (emission), (path), next_emission, straight_line, EMITTERS) \
    /* Scatter: one shadow ray to a light, and the next ray. `walk` is memory that shade_hits uses for itself */ \
    S(shade_hits, (hit), (next_ray, shadow, path, walk), each_bsdf, straight_line, ALWAYS) \
    S(shade_occlusions, (hit), (next_ray, shadow, path), next_occlusion, straight_line, AMBIENT_OCCLUSION) \
    S(shade_scatters, (scatter), (next_ray, shadow), next_scatter, straight_line, MEDIA) \
    /* Add the light of shadow rays that nothing blocks */ \
    S(test_shadows, (shadow), (path), each_shadow, tracing, ALWAYS) \
    /* Once the paths of a batch have ended: add them to their pixels */ \
    S(resolve_film, (path), (film), each_pixel, tracing, ALWAYS) \
    /* A wave of light paths: it begins with these rays, intersects and classifies them as above, and goes on here */ \
    S(generate_light_rays, (pixels), (ray), each_light_sample, tracing, LIGHT_PATHS) \
    S(route_light_paths, (intersection, ray, counts), (hit, next_ray, shadow), each_light_intersection, counting, LIGHT_PATHS) \
    S(shade_light_hits, (hit), (next_ray, shadow), each_light_bsdf, straight_line, LIGHT_PATHS) \
    S(splat_shadows, (shadow), (splat), each_splat, tracing, LIGHT_PATHS) \
    /* Keep their hits; then paths from the camera connect with them: first what the hit of such a path knows, then what the other does */ \
    S(cache_hits, (hit), (cached), each_light_bsdf, counting, CONNECTIONS) \
    S(connect_hits, (hit, cached), (connection, shadow), each_connecting_bsdf, tracing, CONNECTIONS) \
    S(shade_connections, (connection, hit, cached, shadow), (shadow), each_connected_bsdf, tracing, CONNECTIONS) \
    /* Keep their vertices, and sort them into a hash grid; then paths from the camera merge with them */ \
    S(store_vertices, (hit), (vertex), each_light_bsdf, counting, MERGING) \
    S(count_vertices, (vertex), (grid), each_vertex, tracing, MERGING) \
    S(place_vertices, (vertex), (grid), each_vertex, tracing, MERGING) \
    S(order_vertices, (grid), (grid), each_bucket, tracing, MERGING) \
    S(merge_vertices, (hit, vertex, grid), (path), each_bsdf, tracing, MERGING)

/* Kernels that run before the first wave, over no queue (host/render/survey.cpp).   S(kernel, FEATURE that makes it exist; the first also
   for another) */
#define SURVEYS(S) \
    S(survey_vertices,        ENVIRONMENT_GUIDE_OR_MERGING) \
    S(survey_exits,           ENVIRONMENT_GUIDE) \
    S(survey_environment,     ENVIRONMENT_GUIDE)

/* Which queue an intersection goes to next. Those before next_miss share one range of slots: a segment of whole work-groups for
   each, in this order; slots behind its last item are dead. Slot i there is a slot of hit (of scatter, of neither for a crossing), and also
   slot i of shadow and of next_ray. */
#define NEXT_OF_BSDF(name, FEATURE, PARAMETERS) next_##name,
enum next_queue {
    next_crossing,            /* straight on: an interface between media. Has no shadow ray */
    next_scatter,             /* shade_scatters; with light paths, none: NEXT_IN_MEDIUM */
    next_occlusion,           /* shade_occlusions */
    BSDFS(NEXT_OF_BSDF)       /* next_diffuse, ..., next_subsurface_exit (where a path leaves a body): shade_hits, built for that BSDF */
    next_miss,                /* shade_misses */
    next_emission,            /* shade_emitters; besides another queue */
    next_queues,
    next_mix,                 /* of a material that is a mix: one of the above, chosen at random. No queue */
    next_absorbed,            /* ended in a medium or a body */
    next_none,                /* before classify_intersections: not decided yet; after it: the path ends, at max_depth or in nothing */
    next_values               /* how many values there are */
};

/* Where paths go on that scatter in a medium. With light paths that is a hit like others, whose BSDF is the phase function. */
#define NEXT_IN_MEDIUM (HAS_LIGHT_PATHS ? (uint)next_henyey_greenstein : (uint)next_scatter)

/* What a stage runs over, unless it is the items of one next_queue; no value is one of next_queue. */
enum stage_items {
    each_sample = next_values, /* samples of a batch: the paths that begin */
    each_ray,                  /* every slot of the ray queue, dead ones included */
    each_intersection,         /* the same slots, once the items of each next_queue are counted */
    each_bsdf,                 /* the items of next_x, for every BSDF x of the scene: the stage is built once for each */
    each_shadow,               /* every slot of the shadow queue, dead ones included */
    each_pixel,                /* pixels of a batch */
    each_light_sample,         /* samples of a batch of light paths: those that begin */
    each_light_intersection,   /* as each_intersection, for light paths */
    each_light_bsdf,           /* as each_bsdf, for light paths: the stage for BSDF x runs over light_hits + next_x */
    each_connecting_bsdf,      /* as each_bsdf, once the shadow rays of those hits are tested: over connecting_hits + next_x */
    each_connected_bsdf,       /* every slot of the shadow queue, once for each BSDF x at its other end: over connected_hits + next_x */
    each_splat,                /* every slot of the shadow queue, where it holds connections of light paths to the camera */
    each_vertex,               /* stored vertices */
    each_bucket,               /* buckets of the grid */
    no_queue,                  /* of a kernel of SURVEYS */
    light_hits,
    connecting_hits = light_hits + next_values,
    connected_hits = connecting_hits + next_values
};

/* Indices of `counts`. At each next_queue: how many items go there. At count_of_batches + b: how many rays of batch b were live. */
enum wave_count { count_of_batches = next_queues, wave_counts = count_of_batches + MOST_BATCHES };

CONTRACT_END
#endif
