/* Every queue, field by field: what a path carries from the stage that fills the queue to the stage that drains it.
   This list is the only declaration. Both languages derive structs, offsets, loads and stores from it. The queues walk, probe,
   exit_point and connection and some more lists of fields, which single features need, are in feature_fields.h.

   F(queue, type, name, FEATURE that makes it exist): FEATURE is one of features.h, HAS_FEATURE in kernels. Without it, an item's struct has
   the field, but it is not stored or loaded. A queue is one SoA buffer of 32-bit words: word w of slot i is word[w * capacity + i].

   Spaces: everything is in scene space (docs/tour.md) unless a comment says otherwise; directions have unit length. */
#ifndef EIKONAL_QUEUES_H
#define EIKONAL_QUEUES_H
#include "eikonal/feature_fields.h"
#include "eikonal/portable.h"
#define HAS_ALWAYS 1

/* What a path carries from bounce to bounce, in every queue that continues it. */
#define TRAVEL_FIELDS(F, q) \
    F(q, uint,     path,       ALWAYS)       /* index of its path state */ \
    F(q, uint,     seed,       ALWAYS)       /* hash of its pixel: selects the random sequence */ \
    F(q, uint,     sample,     ALWAYS)       /* index in that sequence */ \
    F(q, float,    wavelength, SPECTRAL)     /* in [0, 1): its wavelengths follow from it (sample_wavelengths) */ \
    F(q, uint,     depth,      ALWAYS)       /* scattering events so far (no null interfaces); where rays split, in its lower half */ \
    F(q, spectrum, beta,       ALWAYS)       /* throughput: contribution of the path so far over its density */ \
    F(q, float,    time,       MOTION)       /* in [0, 1], from start to end of all motion */ \
    F(q, uint,     has_nonspecular_vertex, AOVS) /* 1 once the path has met anything but mirrors and clear glass */ \
    F(q, uint,     has_nondelta_sample, REGULARIZE)  /* 1 once the path has been scattered by anything but delta distributions */ \
    F(q, uint,     secondary_terminated,   DISPERSION)   /* 1: only the first wavelength is left, and counts for all */ \
    SPLITTING_TRAVEL_FIELDS(F, q) ONE_PASS_FIELD(F, q) \
    F(q, float,    eta_scale,  TRANSMISSION) /* product of squared relative indices; Russian roulette multiplies by it */ \
    F(q, spectrum, r_u,        MEDIA)        /* rescaled path probability of unidirectional sampling, per channel (pbrt-v4's r_u) */ \
    LIGHT_PATH_TRAVEL_FIELDS(F, q) SUBSURFACE_TRAVEL_FIELDS(F, q)

/* A ray to trace: filled by generate_rays, shading and route_intersections, traced by intersect_rays, read up to route_intersections.
   Sparse: slots may be dead. Slot i comes from slot i of hit or scatter (ray splitting: see shade_hits.cl); camera rays follow. */
#define RAY_FIELDS(F, q) \
    TRAVEL_FIELDS(F, q) \
    F(q, vec3,     o,          ALWAYS)       /* origin, already offset from the surface */ \
    F(q, vec3,     d,          ALWAYS) \
    F(q, float,    t_max,      ALWAYS)       /* < 0: dead slot; 0: enters a subsurface body, and goes on where its probe finds an exit */ \
    F(q, float,    pdf,        ALWAYS)       /* density over solid angle with which d was sampled; 0: light sampling cannot produce d */ \
    F(q, vec3,     vertex,     STRIPS)       /* where d was sampled; o is a width away from it on a curve */ \
    F(q, float,    traveled,   INTERFACE)    /* distance from where d was sampled to o; > 0 behind null interfaces */ \
    F(q, uint,     passed,     INTERFACE)    /* number of null interfaces passed since d was sampled */ \
    F(q, uint,     guide,      ENVIRONMENT_GUIDE) /* which map of the environment guide applies where d was sampled */ \
    F(q, vec3,     n,          LIGHT_TREE_OR_PATH_GUIDE) /* shading normal where d was sampled, towards wo; zero: not on a surface */ \
    F(q, spectrum, r_l,        MEDIA)        /* rescaled path probability of light sampling (pbrt-v4's r_l), without the light's pdf */ \
    F(q, uint,     medium,     MEDIA)        /* medium at o, or NONE */ \
    F(q, uint,     probe,      DIFFUSION)    /* slot of the probe that finds where the path leaves a subsurface body; or NONE */

/* Where a ray ends: slot i belongs to ray i. Filled by intersect_rays, refined by extinguish_rays and classify_intersections. */
#define INTERSECTION_FIELDS(F, q) \
    F(q, float,    t,          ALWAYS)       /* distance to the end; < 0: dead slot */ \
    F(q, uint,     element,    ALWAYS)       /* the element hit (a triangle, a patch, a sphere, ...), or NONE */ \
    F(q, uint,     instance,   INSTANCES)    /* the instance hit, or NONE */ \
    F(q, float,    u,          ALWAYS)       /* parameters of the point on the element */ \
    F(q, float,    v,          ALWAYS) \
    F(q, uint,     next_queue,        ALWAYS)       /* enum next_queue */ \
    F(q, uint,     material,   ALWAYS)       /* of a hit, mixes resolved */ \
    F(q, uint,     emits,      EMITTERS)     /* 1: the surface emits; the intersection also goes to shade_emitters */

/* A surface point to shade, or with LIGHT_PATHS a point in a medium: filled by route_intersections, drained by shade_hits or
   shade_occlusions. Dense, one segment for each BSDF, which appends its own parameters (bsdfs.h). */
#define HIT_FIELDS(F, q) \
    TRAVEL_FIELDS(F, q) \
    F(q, vec3,     p,          ALWAYS) \
    F(q, float,    offset,     ALWAYS)       /* distance along ng by which new rays are offset to avoid self-intersection */ \
    F(q, vec3,     ng,         ALWAYS)       /* geometric normal, on the side of ns; 0: in a medium */ \
    F(q, vec3,     ns,         ALWAYS) \
    F(q, vec3,     tangent,    ANISOTROPY)   /* along dp/du, perpendicular to ns */ \
    F(q, vec3,     wo,         ALWAYS)       /* towards the previous vertex */ \
    F(q, uint,     inside,     MEDIA)        /* medium on the side away from ng */ \
    F(q, uint,     outside,    MEDIA)        /* medium on the side of ng */ \
    F(q, uint,     probe,      DIFFUSION)    /* slot of the probe for the subsurface body below the surface; NONE: no such body */ \
    PATH_GUIDE_HIT_FIELDS(F, q) LIGHT_PATH_HIT_FIELDS(F, q) LIGHT_CHOICE_FIELDS(F, q)

/* A scattering point in a medium: filled by route_intersections, drained by shade_scatters. Dense. */
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
    F(q, float,    wavelength, SPECTRAL)     /* as in ray */ \
    F(q, uint,     depth,      ALWAYS) \
    F(q, spectrum, beta,       ALWAYS) \
    F(q, spectrum, r_u,        MEDIA) \
    F(q, spectrum, r_l,        MEDIA)        /* as in ray */ \
    F(q, vec3,     d,          ALWAYS) \
    F(q, float,    pdf,        ALWAYS)       /* as in ray */    LIGHT_PATH_MISS_FIELDS(F, q) ONE_PASS_FIELD(F, q) \
    F(q, uint,     guide,      ENVIRONMENT_GUIDE) /* as in ray */ \
    F(q, vec3,     o,          PORTALS_OR_ENVIRONMENT_GUIDE_OR_LIGHT_PATHS) /* where d was sampled */

/* A hit on a surface that emits: filled by route_intersections, drained by shade_emitters. Dense. */
#define EMISSION_FIELDS(F, q) \
    F(q, uint,     path,       ALWAYS) \
    F(q, spectrum, beta,       ALWAYS) \
    F(q, spectrum, r_u,        MEDIA) \
    F(q, spectrum, r_l,        MEDIA)        /* as in ray */ \
    F(q, spectrum, Le,         ALWAYS)       /* radiance towards the path */ \
    F(q, float,    pdf,        ALWAYS)       /* as in ray */ LIGHT_PATH_EMISSION_FIELDS(F, q) ONE_PASS_FIELD(F, q) LIGHT_GROUP_FIELD(F, q) \
    F(q, float,    pdf_light,  ALWAYS)       /* density over solid angle with which light sampling produces this point */

/* A shadow ray and the light it carries: filled by shading, drained by test_shadows. Sparse: slot i belongs to slot i of hit or scatter. */
#define SHADOW_FIELDS(F, q) \
    F(q, uint,     path,       ALWAYS) \
    F(q, vec3,     o,          ALWAYS) \
    F(q, vec3,     d,          ALWAYS) \
    F(q, float,    t_max,      ALWAYS)       /* < 0: dead slot; ends before the light by what rounding may hide of it */ \
    LIGHT_ELEMENT_FIELDS(F, q) LIGHT_PATH_SHADOW_FIELDS(F, q) ONE_PASS_FIELD(F, q) LIGHT_GROUP_FIELD(F, q) \
    F(q, float,    time,       MOTION)       /* as in ray */ \
    F(q, spectrum, Ld,         ALWAYS)       /* contribution, all weights included; with MEDIA not yet divided by mean(r_u + r_l) */ \
    F(q, uint,     medium,     MEDIA) \
    F(q, spectrum, r_u,        MEDIA)        /* rescaled path probability if the BSDF or phase function had sampled d */ \
    F(q, spectrum, r_l,        MEDIA)        /* rescaled path probability of light sampling */ \
    F(q, uint,     seed,       MEDIA_OR_LIGHT_PATTERN_OR_LIGHT_PATHS) \
    F(q, uint,     sample,     MEDIA_OR_LIGHT_PATTERN_OR_LIGHT_PATHS) \
    F(q, uint,     depth,      MEDIA_OR_LIGHT_PATHS)

/* What persists from camera to film, by path index. A path has one item in a queue (where rays
   split, each has a state of its own), so stages add to L without atomics. LIGHT_GROUPS: the light of each group follows. */
#define PATH_FIELDS(F, q) \
    F(q, float,    wavelength, SPECTRAL)     /* as in ray */ \
    F(q, spectrum, L,          ALWAYS)       /* radiance so far */    RENDER_PASS_FIELDS(F, q) \
    F(q, float,    weight,     ALWAYS)       /* filter weight of this sample; 0: outside the image */ \
    F(q, float,    importance, IMPORTANCE)   /* film response to a radiance of 1 */ \
    FIRST_SURFACE_FIELDS(F, q)               /* auxiliary channels of the image */

/* Q(queue, FIELDS, where its items are, FEATURE that makes it exist: as above, or ENVIRONMENTS: at least one infinite light)
     sparse    slot i belongs to slot i of the queue that its comment names, and may be dead
     dense     side by side, as route_intersections puts them; slots from the last item to the end of its work-group are dead
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
    Q(probe,        PROBE_FIELDS,        sparse,  DIFFUSION) \
    Q(connection,   CONNECTION_FIELDS,   sparse,  CONNECTIONS) \
    Q(exit_point,   EXIT_POINT_FIELDS,   sparse,  DIFFUSION) \
    Q(path,         PATH_FIELDS,         by_path, ALWAYS)
#endif
