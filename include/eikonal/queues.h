/* Every queue, field by field: what a path carries from the stage that fills the queue to the stage that
   drains it. This is the only place; the structs, slot numbers, loads and stores of both languages are made from it.

   A queue is one buffer of 32-bit words, slot-major: word[slot * capacity + i] holds word `slot` of item i, so that
   neighbouring work-items touch neighbouring words.   F(queue, type, name, FEATURE that makes it exist)

   Spaces: everything is in scene space (docs/tour.md) unless a comment says otherwise; directions have unit length. */
#ifndef EIKONAL_QUEUES_H
#define EIKONAL_QUEUES_H
#include "eikonal/portable.h"

#define HAS_ALWAYS 1

/* What a path carries from bounce to bounce, in whichever queue it is. */
#define TRAVEL_FIELDS(F, q) \
    F(q, uint,     path,       ALWAYS)       /* index of its path state */ \
    F(q, uint,     seed,       ALWAYS)       /* hash of its pixel: which random sequence */ \
    F(q, uint,     sample,     ALWAYS)       /* index in that sequence */ \
    F(q, uint,     depth,      ALWAYS)       /* scattering events so far; interfaces do not count. With TREE: dimension.clh */ \
    F(q, spectrum, beta,       ALWAYS)       /* throughput: contribution of the path so far over its density */ \
    F(q, float,    time,       MOTION)       /* in [0, 1]: between the start and the end of all motion */ \
    F(q, uint,     has_nonspecular_vertex, AOVS) /* 1 from where something other than mirrors and clear glass was met */ \
    F(q, uint,     regularized, REGULARIZE)  /* whether it has been scattered by anything but delta distributions */ \
    F(q, uint,     secondary_terminated,   DISPERSION)   /* 1: only the first wavelength is left, and stands for all */ \
    F(q, uint,     splits,     TREE)         /* how often it may still split in two: it owns 2^splits path states, from `path` on */ \
    F(q, float,    eta_scale,  TRANSMISSION) /* product of squared relative indices, undone for Russian roulette */ \
    F(q, spectrum, r_u,        MEDIA)        /* density of this path under its own strategy, per channel, relative */ \
    F(q, uint,     within,     SUBSURFACE)   /* 1: inside of a body that light wanders in; of a hit: bit 0 on the side of ng, bit 1 on the other */ \
    F(q, uint,     uncounted,  SUBSURFACE)   /* how many of the scattering events were there: they use up no depth */ \
    F(q, uint,     around,     SUBSURFACE)   /* the medium around the last such body that was entered, or NONE */

/* The light that is sampled at a vertex, as far as finding it takes a walk: chosen where items are made, for shading has no loops. */
#define LIGHT_CHOICE_FIELDS(F, q) \
    F(q, uint,     light,      LIGHT_TREE)   /* which */ \
    F(q, float,    light_pmf,  LIGHT_TREE)   /* probability of that; 0: none */ \
    F(q, uint,     guide,      ENVIRONMENT_GUIDE) /* the map of the environment guide for this point */ \
    F(q, vec3,     light_wi,   PORTALS)      /* if it has a portal: a direction through it, */ \
    F(q, float,    light_density, PORTALS)   /*   its density over solid angle (0: none), */ \
    F(q, uint,     light_texel, PORTALS)     /*   and the texel that is seen */

/* A ray on its way: filled by generate_rays and shading, drained by intersect_rays. Sparse. */
#define RAY_FIELDS(F, q) \
    TRAVEL_FIELDS(F, q) \
    F(q, vec3,     o,          ALWAYS)       /* origin, already moved off its surface */ \
    F(q, vec3,     d,          ALWAYS) \
    F(q, float,    t_max,      ALWAYS)       /* < 0: this slot is dead */ \
    F(q, float,    pdf,        ALWAYS)       /* density over solid angle with which d was sampled; 0: no light could sample it */ \
    F(q, float,    traveled,   INTERFACE)    /* from where d was sampled to o: interfaces passed on the way */ \
    F(q, uint,     passed,     CROSSINGS)     /* how many surfaces it has passed since d was sampled */ \
    F(q, uint,     guide,      ENVIRONMENT_GUIDE) /* as in hit, of where d was sampled */ \
    F(q, vec3,     n,          LIGHT_TREE)   /* shading normal where d was sampled, on the side of wo; zero: not on a surface */ \
    F(q, spectrum, r_l,        MEDIA)        /* density of this path had a light been sampled instead, but for the light's own */ \
    F(q, uint,     medium,     MEDIA)        /* which fills the space at o, or NONE */ \
    F(q, uint,     body,       DIFFUSION)    /* in `profiles`: it is a probe, which looks for points of this body's surface up to t_max; NONE: it is light */ \
    F(q, uint,     found,      DIFFUSION)    /* of a probe: how many points it has met */ \
    F(q, vec3,     entry,      DIFFUSION)    /* of a probe: where the path went below the surface, */ \
    F(q, vec3,     entry_n,    DIFFUSION)    /* and the shading normal there */ \
    F(q, vec3,     exit_p,     DIFFUSION)    /* of a probe that has found one: the point where the path comes up, as in hit */ \
    F(q, float,    exit_offset, DIFFUSION) \
    F(q, vec3,     exit_ng,    DIFFUSION) \
    F(q, vec3,     exit_ns,    DIFFUSION) \
    F(q, spectrum, body_albedo, BODY_TEXTURES) /* of a probe: what is said of the body at `entry`, as in hit */ \
    F(q, spectrum, body_length, BODY_TEXTURES)

/* Where a ray ends: slot i belongs to ray i. Filled by intersect_rays, refined by extinguish_rays and classify_intersections. */
#define INTERSECTION_FIELDS(F, q) \
    F(q, float,    t,          ALWAYS)       /* distance to the end; < 0: dead */ \
    F(q, uint,     element,    ALWAYS)       /* which is hit, or NONE */ \
    F(q, uint,     instance,   INSTANCES)    /* in which instance, or NONE */ \
    F(q, float,    u,          ALWAYS)       /* parameters of the point on the element */ \
    F(q, float,    v,          ALWAYS) \
    F(q, uint,     next_queue,        ALWAYS)       /* which queue comes next: enum next_queue */ \
    F(q, uint,     material,   ALWAYS)       /* of a hit, mixes resolved */ \
    F(q, uint,     emits,      EMITTERS)     /* 1: a hit on something that emits, which shade_emitters wants as well */

/* A point on a surface, to be scattered at: filled by route_intersections, drained by shade_hits. Dense, one segment for each
   BSDF, which adds its own parameters (bsdfs.h) after these words. */
#define HIT_FIELDS(F, q) \
    TRAVEL_FIELDS(F, q) \
    F(q, vec3,     p,          ALWAYS) \
    F(q, float,    offset,     ALWAYS)       /* how far along ng a new ray must start not to hit its own surface */ \
    F(q, vec3,     ng,         ALWAYS)       /* geometric normal, on the side of ns */ \
    F(q, vec3,     ns,         ALWAYS)       /* shading normal */ \
    F(q, vec3,     tangent,    ANISOTROPY)   /* along dp/du, perpendicular to ns */ \
    F(q, vec3,     wo,         ALWAYS)       /* towards where the path came from */ \
    F(q, uint,     inside,     MEDIA)        /* medium on the side away from ng */ \
    F(q, uint,     outside,    MEDIA)        /* medium on the side of ng */ \
    F(q, uint,     body,       DIFFUSION)    /* in `profiles`: what is below the surface; NONE: nothing that light is diffused in */ \
    F(q, vec3,     probe_o,    DIFFUSION)    /* where a path that goes below looks for a way out: along this probe */ \
    F(q, vec3,     probe_d,    DIFFUSION) \
    F(q, float,    probe_length, DIFFUSION) \
    F(q, spectrum, body_albedo, BODY_TEXTURES) /* of the body, if light enters it here: share of it that leaves again, */ \
    F(q, spectrum, body_length, BODY_TEXTURES) /*   and d of its profile */ \
    LIGHT_CHOICE_FIELDS(F, q)

/* A point in a medium, to be scattered at: filled by route_intersections, drained by shade_scatters. Dense. */
#define SCATTER_FIELDS(F, q) \
    TRAVEL_FIELDS(F, q) \
    F(q, vec3,     p,          ALWAYS) \
    F(q, vec3,     wo,         ALWAYS) \
    F(q, uint,     medium,     ALWAYS) \
    F(q, float,    g,          ALWAYS)       /* mean cosine of the phase function */ \
    LIGHT_CHOICE_FIELDS(F, q)

/* A ray that left the scene: filled by route_intersections, drained by shade_misses. Dense. */
#define MISS_FIELDS(F, q) \
    F(q, uint,     path,       ALWAYS) \
    F(q, uint,     seed,       SPECTRAL) \
    F(q, uint,     sample,     SPECTRAL) \
    F(q, uint,     depth,      ALWAYS) \
    F(q, spectrum, beta,       ALWAYS) \
    F(q, spectrum, r_u,        MEDIA) \
    F(q, spectrum, r_l,        MEDIA)        /* as in ray */ \
    F(q, vec3,     d,          ALWAYS) \
    F(q, float,    pdf,        ALWAYS)       /* as in ray */ \
    F(q, uint,     guide,      ENVIRONMENT_GUIDE) /* as in ray */ \
    F(q, vec3,     o,          PORTALS)      /* from where d was sampled */

/* A hit on something that emits: filled by route_intersections, drained by shade_emitters. Dense. */
#define EMISSION_FIELDS(F, q) \
    F(q, uint,     path,       ALWAYS) \
    F(q, spectrum, beta,       ALWAYS) \
    F(q, spectrum, r_u,        MEDIA) \
    F(q, spectrum, r_l,        MEDIA)        /* as in ray */ \
    F(q, spectrum, Le,         ALWAYS)       /* radiance towards the path */ \
    F(q, float,    pdf,        ALWAYS)       /* as in ray */ \
    F(q, float,    pdf_light,  ALWAYS)       /* density over solid angle with which light sampling finds this point */

/* Light that arrives if nothing is in between: filled by shading, drained by test_shadows. Slot i to slot i, sparse. */
#define SHADOW_FIELDS(F, q) \
    F(q, uint,     path,       ALWAYS) \
    F(q, vec3,     o,          ALWAYS) \
    F(q, vec3,     d,          ALWAYS) \
    F(q, float,    t_max,      ALWAYS)       /* < 0: dead */ \
    F(q, float,    time,       MOTION)       /* as in ray */ \
    F(q, spectrum, Ld,         ALWAYS)       /* contribution, weights included (in media: all but the two densities) */ \
    F(q, uint,     element,    LIGHT_PATTERN) /* which is sampled of a light whose pattern Ld leaves out; otherwise NONE */ \
    F(q, uint,     color_seed, LIGHT_PATTERN) /* for the sampled_wavelengths that the pattern is read through */ \
    F(q, uint,     color_sample, LIGHT_PATTERN) \
    F(q, uint,     medium,     MEDIA) \
    F(q, spectrum, r_u,        MEDIA)        /* density of the path had its own direction been sampled, relative */ \
    F(q, spectrum, r_l,        MEDIA)        /* density of the path through the light, relative */ \
    F(q, uint,     seed,       MEDIA) \
    F(q, uint,     sample,     MEDIA) \
    F(q, uint,     depth,      MEDIA)

/* A walk between the layers of a surface that is looked at from above: of shade_hits of coated surfaces alone, slot i to slot i of hit. */
#define WALK_FIELDS(F, q) \
    F(q, uint,     state,      ALWAYS)       /* whether it is still under way, or has left (kernels/bsdf/layer_walk.clh) */ \
    F(q, uint,     key,        ALWAYS)       /* which random numbers */ \
    F(q, vec3,     w,          ALWAYS)       /* where to; in the shading frame, as all directions here */ \
    F(q, spectrum, beta,       ALWAYS)       /* throughput */ \
    F(q, uint,     spread,     ALWAYS)       /* 1: turned by more than mirrors since it entered the coat */ \
    F(q, float,    z,          LAYER_MEDIUM) /* height above the base */ \
    F(q, vec3,     wi,         ALWAYS)       /* of an evaluation: the direction that light comes from, */ \
    F(q, spectrum, f,          ALWAYS)       /*   what is found of it so far, */ \
    F(q, vec3,     exit_w,     ALWAYS)       /*   and a way through the coat that was sampled for it: from wi downwards, */ \
    F(q, float,    exit_weight, ALWAYS)      /*     with its weight, */ \
    F(q, float,    exit_pdf,   ALWAYS)       /*     and its density */

/* What lives from camera to film, by path index: its own radiance, to which only this path adds. */
#define PATH_FIELDS(F, q) \
    F(q, uint,     seed,       SPECTRAL) \
    F(q, uint,     sample,     SPECTRAL) \
    F(q, spectrum, L,          ALWAYS)       /* radiance gathered so far */ \
    F(q, float,    weight,     ALWAYS)       /* of this sample in its pixel; 0: outside of the image */ \
    F(q, float,    importance, IMPORTANCE)   /* what the film receives for a radiance of 1 */ \
    F(q, spectrum, albedo,     AOVS)         /* of the first surface that is not a mirror or clear glass, times what those before it let through */ \
    F(q, vec3,     normal,     AOVS)         /* of the first surface: shading normal */ \
    F(q, vec3,     ng,         AOVS)         /* its geometric normal, on the same side */ \
    F(q, vec3,     position,   AOVS)         /* its point that was hit */ \
    F(q, vec2,     uv,         AOVS)         /* and the texture coordinates there */ \
    F(q, vec3,     opening,    MOTION_VECTORS) /* where that point of the surface is when the shutter opens */ \
    F(q, vec3,     closing,    MOTION_VECTORS) /* and when it closes */ \
    F(q, uint,     object,     AOVS)         /* which object of the scene it is, from 1; 0: none */ \
    F(q, uint,     material,   AOVS)         /* which material it has, from 1; 0: none */ \
    F(q, float,    distance,   AOVS)         /* to the first surface, scene units; FAR_AWAY: none */

/* Q(queue, FIELDS, where its items are, FEATURE that makes it exist: as in STAGES)
     sparse    slot i belongs to slot i of another queue, and may be dead
     dense     side by side, as route_intersections puts them
     by_path   at the index of their path */
#define QUEUES(Q) \
    Q(ray,          RAY_FIELDS,          sparse,  ALWAYS) \
    Q(intersection, INTERSECTION_FIELDS, sparse,  ALWAYS) \
    Q(hit,          HIT_FIELDS,          dense,   ALWAYS) \
    Q(scatter,      SCATTER_FIELDS,      dense,   MEDIA) \
    Q(miss,         MISS_FIELDS,         dense,   ENVIRONMENTS) \
    Q(emission,     EMISSION_FIELDS,     dense,   EMITTERS) \
    Q(shadow,       SHADOW_FIELDS,       sparse,  ALWAYS) \
    Q(walk,         WALK_FIELDS,         sparse,  LAYERS) \
    Q(path,         PATH_FIELDS,         by_path, ALWAYS)

#endif
