/* Every stage of a wave, in the order in which they run: a kernel that reads queues and writes queues.
     S(stage, (what it reads), (what it may write), what it runs over, FEATURE that makes it exist)
   It drains the first queue that it reads. Besides queues (queues.h) there are `next_ray`, the ray queue of the next bounce, `pixels`,
   blocks of the image, `film`, their sums, and `counts`, how many items there are (enum wave_count). What a stage runs over is one of enum
   stage_items, or the next_queue whose items it handles. FEATURE is one of features.h, ALWAYS, or ENVIRONMENTS: at least one infinite light
   (host/pack/scene_constants.h). A stage called x is kernels/stages/x.cl, whose head repeats both lists (tests/unit/stages_test.cpp compares
   them with its arguments). Its profiler row and its test are called x too. */
#ifndef EIKONAL_STAGES_H
#define EIKONAL_STAGES_H
#include "eikonal/batch.h"
#include "eikonal/bsdfs.h"
#include "eikonal/portable.h"
CONTRACT_BEGIN

#define STAGES(S) \
    S(generate_rays,          (pixels),                    (ray, path),                     each_sample,    ALWAYS) \
    S(intersect_rays,         (ray),                       (intersection),                  each_ray,       ALWAYS) \
    S(trace_probes,           (ray, probe),                (intersection, exit_point),      each_ray,       DIFFUSION) \
    S(extinguish_rays,        (intersection, ray),         (ray, intersection, path),       each_ray,       MEDIA) \
    S(classify_intersections, (intersection, ray),         (intersection, counts),          each_ray,       ALWAYS) \
    S(route_intersections,    (intersection, ray, counts, exit_point), \
                              (hit, scatter, miss, emission, next_ray, shadow, path, probe), each_ray,      ALWAYS) \
    S(shade_misses,           (miss),                      (path),                          next_miss,      ENVIRONMENTS) \
    S(shade_emitters,         (emission),                  (path),                          next_emission,  EMITTERS) \
    S(shade_hits,             (hit),                       (next_ray, shadow, path, walk),  each_bsdf,      ALWAYS) \
    S(shade_occlusions,       (hit),                       (next_ray, shadow, path),        next_occlusion, AMBIENT_OCCLUSION) \
    S(shade_scatters,         (scatter),                   (next_ray, shadow),              next_scatter,   MEDIA) \
    S(test_shadows,           (shadow),                    (path),                          each_shadow,    ALWAYS) \
    S(resolve_film,           (path),                      (film),                          each_pixel,     ALWAYS)

/* Kernels that run before the first wave, over no queue (host/render/survey.cpp).   S(kernel, FEATURE that makes it exist) */
#define SURVEYS(S) \
    S(survey_vertices,        ENVIRONMENT_GUIDE) \
    S(survey_environment,     ENVIRONMENT_GUIDE)

/* Which queue an intersection goes to next. One segment of the hit queue for each, in this order. */
#define NEXT_OF_BSDF(name, FEATURE, PARAMETERS) next_##name,
enum next_queue {
    next_crossing,             /* straight on: an interface between media */
    next_scatter,             /* shade_scatters */
    next_occlusion,           /* shade_occlusions */
    BSDFS(NEXT_OF_BSDF)       /* shade_hits, built for that BSDF */
    next_miss,                /* shade_misses */
    next_emission,            /* shade_emitters; besides another queue */
    next_queues,
    next_mix,                 /* a material to be resolved to one of the above; no queue */
    next_absorbed,            /* ended in a medium or a body */
    next_none,                /* the path ends, or goes where its element says */
    next_values               /* how many values there are */
};

/* What a stage runs over, unless it is the items of one next_queue; no value is one of next_queue. */
enum stage_items {
    each_sample = next_values, /* samples of a batch: the paths that begin */
    each_ray,                  /* every slot of the ray queue, dead ones included */
    each_bsdf,                 /* the items of next_x, for every BSDF x of the scene: the stage is built once for each */
    each_shadow,               /* every slot of the shadow queue, dead ones included */
    each_pixel,                /* pixels of a batch */
    no_queue                   /* of a kernel of SURVEYS */
};

/* What a wave counts at each next_queue, real rays only: how many go to each queue, and how many each batch in flight has. */
enum wave_count { count_of_batches = next_queues, wave_counts = count_of_batches + MOST_BATCHES };

CONTRACT_END
#endif
