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
    S(intersect_rays,   "ray",        "flight",             ALWAYS) \
    S(extinguish_rays,  "flight ray", "ray flight path",    MEDIA) \
    S(classify_flights, "flight ray", "flight",             ALWAYS) \
    S(route_flights,    "flight ray", "hit scatter miss emission ray shadow path", ALWAYS) \
    S(shade_misses,     "miss",       "path",               ALWAYS) \
    S(shade_emitters,   "emission",   "path",               EMITTERS) \
    S(shade_hits,       "hit",        "ray shadow path walk", ALWAYS) \
    S(shade_occlusions, "hit",        "ray shadow path",    AMBIENT_OCCLUSION) \
    S(shade_scatters,   "scatter",    "ray shadow",         MEDIA) \
    S(test_shadows,     "shadow",     "path",               ALWAYS) \
    S(resolve_film,     "path",       "film",               ALWAYS)

/* Where a flight goes next. One segment of the hit queue for each, in this order. */
#define HOP_OF_BSDF(name, FEATURE, PARAMETERS) hop_##name,
enum hop {
    hop_passage,             /* straight on: an interface between media */
    hop_scatter,             /* shade_scatters */
    hop_occlusion,           /* shade_occlusions */
    BSDFS(HOP_OF_BSDF)       /* shade_hits, built for that BSDF */
    hop_miss,                /* shade_misses */
    hop_emission,            /* shade_emitters; besides another hop */
    hops,
    hop_mix,                 /* a material to be resolved to one of the above; no queue */
    hop_absorbed,            /* ended in a medium */
    hop_none                 /* the path ends, or goes where its element says */
};

/* What a wave counts at each hop, real rays only: how many go to each queue, and how many each batch in flight has. */
enum wave_count { count_of_batches = hops, wave_counts = count_of_batches + MOST_BATCHES };

CONTRACT_END
#endif
