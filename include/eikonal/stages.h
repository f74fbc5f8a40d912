/* Every stage: one kernel from queues to queues. S(stage, queues it reads, queues it may write, FEATURE that makes it exist).
   It runs over the slots of the first that it reads, and drains it.
   A stage called x is kernels/x.cl, whose head repeats both lists (tests/unit/stages_test.cpp holds them to its arguments); its profiler row
   and its test are called x too. */
#ifndef EIKONAL_STAGES_H
#define EIKONAL_STAGES_H
#include "eikonal/batch.h"
#include "eikonal/bsdfs.h"
#include "eikonal/portable.h"
CONTRACT_BEGIN

#define STAGES(S) \
    S(generate_rays,    "pixels",     "ray path",           ALWAYS) \
    S(intersect_rays,   "ray",        "intersection",             ALWAYS) \
    S(extinguish_rays,  "intersection ray", "ray intersection path",    MEDIA) \
    S(classify_intersections, "intersection ray", "intersection",             ALWAYS) \
    S(route_intersections,    "intersection ray", "hit scatter miss emission ray shadow path", ALWAYS) \
    S(shade_misses,     "miss",       "path",               ALWAYS) \
    S(shade_emitters,   "emission",   "path",               EMITTERS) \
    S(shade_hits,       "hit",        "ray shadow path walk", ALWAYS) \
    S(shade_occlusions, "hit",        "ray shadow path",    AMBIENT_OCCLUSION) \
    S(shade_scatters,   "scatter",    "ray shadow",         MEDIA) \
    S(test_shadows,     "shadow",     "path",               ALWAYS) \
    S(resolve_film,     "path",       "film",               ALWAYS)

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
    next_absorbed,            /* ended in a medium */
    next_none                 /* the path ends, or goes where its element says */
};

/* What a wave counts at each next_queue, real rays only: how many go to each queue, and how many each batch in flight has. */
enum wave_count { count_of_batches = next_queues, wave_counts = count_of_batches + MOST_BATCHES };

CONTRACT_END
#endif
