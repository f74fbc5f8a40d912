/* Fields of queues that a single feature needs, and the queue that shading keeps to itself: parts of the lists in queues.h, which says what
   the columns are. */
#ifndef EIKONAL_FEATURE_FIELDS_H
#define EIKONAL_FEATURE_FIELDS_H

/* Several features that need the same field. */
#define HAS_PORTALS_OR_ENVIRONMENT_GUIDE_OR_LIGHT_PATHS (HAS_PORTALS || HAS_ENVIRONMENT_GUIDE || HAS_LIGHT_PATHS)
#define HAS_MEDIA_OR_LIGHT_PATTERN_OR_LIGHT_PATHS (HAS_MEDIA || HAS_LIGHT_PATTERN || HAS_LIGHT_PATHS)
#define HAS_MEDIA_OR_LIGHT_PATHS (HAS_MEDIA || HAS_LIGHT_PATHS)
#define HAS_MERGING_OR_CONNECTIONS (HAS_MERGING || HAS_CONNECTIONS)
#define HAS_LIGHT_TREE_OR_PATH_GUIDE (HAS_LIGHT_TREE || HAS_PATH_GUIDE)

/* The element of an area light that a shadow ray is aimed at. */
#define LIGHT_ELEMENT_FIELDS(F, q) \
    F(q, uint,     element,    EMITTERS)     /* NONE: the light is no area */ \
    F(q, float,    element_t,  EMITTERS)     /* hits of `element` from this distance on are the sampled point itself: no blockers */ \
    F(q, float,    distance,   LIGHT_PATTERN) /* to the sampled point, if its light has an image or alpha, which Ld lacks; else 0 */

/* The light to sample at a vertex. Chosen by route_intersections, since choosing needs a loop and shading has none. */
#define LIGHT_CHOICE_FIELDS(F, q) \
    F(q, uint,     light,      LIGHT_TREE)   /* index in `lights` */ \
    F(q, float,    light_pmf,  LIGHT_TREE)   /* its probability; 0: none */ \
    F(q, uint,     guide,      ENVIRONMENT_GUIDE) /* which map of the environment guide applies at this point */ \
    F(q, vec3,     light_wi,   PORTALS)      /* for a light with a portal: a direction through the portal */ \
    F(q, float,    light_density, PORTALS)   /* density of light_wi over solid angle; 0: none */ \
    F(q, uint,     light_texel, PORTALS)     /* the texel seen along light_wi */

/* Path guiding */
#define PATH_GUIDE_HIT_FIELDS(F, q) \
    F(q, uint,     path_map,   PATH_GUIDE)   /* which map of the path guide applies at this point; 0: none does */

/* Ray splitting */
#define SPLITTING_TRAVEL_FIELDS(F, q) \
    F(q, uint,     splits,     RAY_SPLITTING) /* how often the ray may still split in two; it owns 2^splits path states from `path` on */

/* What multiple importance sampling must know of the vertices behind a path, from the camera or from a light (Georgiev 2012, "Implementing
   Vertex Connection and Merging"). In a ray: without what depends on where the ray ends. */
#define LIGHT_PATH_TRAVEL_FIELDS(F, q) \
    F(q, float,    d_vcm,      LIGHT_PATHS)  /* 1 / density of the last vertex, if a path from the other side may begin or end at the \
                                                one before (for CONNECTIONS: times CONNECTING_SHARE); else 0 */ \
    F(q, float,    d_vc,       LIGHT_PATHS)  /* the same of all earlier vertices together, per density of the way back to them */ \
    F(q, uint,     number,     MERGING_OR_CONNECTIONS) /* of the pixel that it began for: y * width + x */ \
    F(q, uint,     pass,       MERGING_OR_CONNECTIONS) /* which sample of that pixel it is */
#define LIGHT_PATH_HIT_FIELDS(F, q) \
    F(q, float,    merging,    MERGING)      /* density of merging here, per density of arriving from either side; 0: none merge */ \
    F(q, float,    merging_chance, MERGING)  /* probability that a path that comes here has a hit that merges (merging_chance.clh) */
#define LIGHT_PATH_MISS_FIELDS(F, q) \
    F(q, float,    d_vc,       LIGHT_PATHS)  /* as in ray */
#define LIGHT_PATH_EMISSION_FIELDS(F, q) \
    F(q, float,    by_light_paths, LIGHT_PATHS) /* density of all light paths that lead here, over that of this path */
#define LIGHT_PATH_SHADOW_FIELDS(F, q) \
    F(q, vec2,     raster,     LIGHT_PATHS)  /* of a light path: where it arrives in the image, pixels */

/* A vertex of a light path, which camera paths of the same pass merge with: filled by store_vertices, read by merge_vertices. A record of
   VERTEX_FIELDS words for each, one after the other. */
#define VERTEX_FIELDS(F, q) \
    F(q, vec3,     p,          ALWAYS) \
    F(q, vec3,     ng,         ALWAYS)       /* this and what follows as in hit */ \
    F(q, vec3,     wo,         ALWAYS) \
    F(q, spectrum, beta,       ALWAYS)       /* power, of one light path */ \
    F(q, spectrum, r_u,        MEDIA) \
    F(q, float,    d_vcm,      ALWAYS) \
    F(q, float,    d_vc,       ALWAYS) \
    F(q, uint,     secondary_terminated, DISPERSION) \
    F(q, uint,     render_pass, RENDER_PASSES) \
    F(q, uint,     number,     ALWAYS) \
    F(q, uint,     pass,       ALWAYS) \
    F(q, uint,     depth,      ALWAYS)

/* An entry of the hash grid of these vertices: those of a bucket one after the other, in the order of pass, number and depth. */
#define GRID_FIELDS(F, q) \
    F(q, vec3,     p,          ALWAYS)       /* of the vertex */ \
    F(q, uint,     vertex,     ALWAYS)       /* its record */ \
    F(q, uint,     pass,       ALWAYS)       /* of the vertex, like the next two */ \
    F(q, uint,     number,     ALWAYS) \
    F(q, uint,     depth,      ALWAYS)

/* A hit of a light path, which camera paths of the same pass connect with: filled by cache_hits. These fields are what is looked at to
   choose one of many: a record of CACHED_STRIDE words for each, one after the other. The item of hit and the parameters of its
   BSDF are apart. */
#define CACHED_FIELDS(F, q) \
    F(q, vec3,     p,          ALWAYS) \
    F(q, vec3,     ng,         ALWAYS)       /* this and the next on the side of wo */ \
    F(q, vec3,     ns,         ALWAYS) \
    F(q, float,    offset,     ALWAYS)       /* as in hit */ \
    F(q, float,    power,      ALWAYS)       /* largest component of beta */ \
    F(q, float,    by_camera_paths, ALWAYS)  /* found_from_other_side (light_paths.clh), if the hit scatters equally in all directions */ \
    F(q, uint,     secondary_terminated, DISPERSION) \
    F(q, uint,     depth,      ALWAYS) \
    F(q, uint,     bsdf,       ALWAYS)       /* enum next_queue */ \
    F(q, uint,     before,     ALWAYS)       /* the record of the hit before it on its path, from 1; 0: there is none */
#define CACHED_STRIDE 16                     /* a line of a processor's cache */

/* A connection of a hit with a hit of a light path, as far as the first of them knows it: the shadow ray between both has the light. Filled
   by connect_hits, drained by shade_connections. Slot i belongs to slot i of hit and shadow; only where the shadow ray is not dead. */
#define CONNECTION_FIELDS(F, q) \
    F(q, uint,     cached,     ALWAYS)       /* the record of the other hit */ \
    F(q, float,    by_light_paths, ALWAYS)   /* density of paths that arrive here from the light, per density of leaving the other hit */ \
    F(q, float,    arrival,    ALWAYS)       /* density, over area, with which this path goes on to the other hit by itself */

/* Where a path is in a subsurface body. */
#define SUBSURFACE_TRAVEL_FIELDS(F, q) \
    F(q, uint,     within,     SUBSURFACE)   /* number of subsurface bodies around; in a hit: on the side of ng, and << 16 on the other */ \
    F(q, uint,     uncounted,  SUBSURFACE)   /* scattering events inside the body; not counted against maxdepth */ \
    F(q, uint,     around,     SUBSURFACE)   /* media around the two outermost of them, 16 bits each (shade/bodies.clh) */ \
    F(q, uint,     around_second, SUBSURFACE) /* around the next two */ \
    F(q, uint,     around_third,  SUBSURFACE) /* around the two in those */

/* A line along which to look for points where a path may leave a subsurface body with a diffusion profile. Filled by route_intersections
   for each hit on such a body, drained by trace_probes if the path enters the body there. Slot i belongs to slot i of hit. */
#define PROBE_FIELDS(F, q) \
    F(q, uint,     body,       ALWAYS)       /* in `profiles` */ \
    F(q, vec3,     o,          ALWAYS) \
    F(q, vec3,     d,          ALWAYS) \
    F(q, float,    length,     ALWAYS) \
    F(q, vec3,     entry,      ALWAYS)       /* where the path enters the body */ \
    F(q, vec3,     entry_n,    ALWAYS)       /* the shading normal there */ \
    F(q, spectrum, albedo,     BODY_TEXTURES) /* of the body there: fraction of the light that leaves again */ \
    F(q, spectrum, profile_length, BODY_TEXTURES) /* of the body there: d of its profile */

/* Where a path leaves a subsurface body. Filled by trace_probes, drained by route_intersections. Slot i belongs to slot i of ray. */
#define EXIT_POINT_FIELDS(F, q) \
    F(q, vec3,     p,          ALWAYS)       /* this and the next three as in hit */ \
    F(q, float,    offset,     ALWAYS) \
    F(q, vec3,     ng,         ALWAYS) \
    F(q, vec3,     ns,         ALWAYS) \
    F(q, uint,     around,     ALWAYS)       /* medium around the body, or NONE */ \
    F(q, spectrum, weight,     ALWAYS)       /* albedo and profile over the density of the exit point */ \
    F(q, spectrum, albedo,     BODY_TEXTURES) /* of the body */

/* The render pass (enum render_pass) of the light that a ray meets next, or that a hit or scatter brings; of a shadow ray's light; of what
   an item finds, otherwise. A light path's is that of what it adds to the image. */
#define ONE_PASS_FIELD(F, q) F(q, uint, render_pass, RENDER_PASSES)
/* The light group of an item's light. */
#define LIGHT_GROUP_FIELD(F, q) F(q, uint, group, LIGHT_GROUPS)
/* The radiance so far of each render pass, in the order of enum render_pass: they sum to L. */
#define RENDER_PASS_FIELDS(F, q) \
    F(q, spectrum, L_emission, RENDER_PASSES) \
    F(q, spectrum, L_direct,   RENDER_PASSES) \
    F(q, spectrum, L_indirect, RENDER_PASSES) \
    F(q, spectrum, L_volume,   RENDER_PASSES)

/* What the auxiliary channels of the image show, of the first surface of a path. */
#define FIRST_SURFACE_FIELDS(F, q) \
    F(q, spectrum, albedo,     AOVS)         /* of the first surface other than mirrors and clear glass, times the throughput before it */ \
    F(q, vec3,     normal,     AOVS)         /* of the first surface: shading normal */ \
    F(q, vec3,     ng,         AOVS)         /* of the first surface: geometric normal, on the same side */ \
    F(q, vec3,     position,   AOVS)         /* of the first surface: the point hit */ \
    F(q, vec2,     uv,         AOVS)         /* of the first surface: texture coordinates there */ \
    F(q, vec3,     opening,    MOTION_VECTORS) /* of the first surface: where that point is at shutter open */ \
    F(q, vec3,     closing,    MOTION_VECTORS) /* and at shutter close */ \
    F(q, uint,     object,     AOVS)         /* of the first surface: id of its object, from 1; 0: none */ \
    F(q, uint,     material,   AOVS)         /* of the first surface: its material, from 1; 0: none */ \
    F(q, float,    distance,   AOVS)         /* to the first surface, scene units; FAR_AWAY: none */

/* A random walk between the layers of a coated surface, seen from above: used inside shade_hits only, slot i belongs to slot i of hit. */
#define WALK_FIELDS(F, q) \
    F(q, uint,     state,      ALWAYS)       /* walk_goes_on, walk_left or walk_ended (kernels/bsdf/layer_walk.clh) */ \
    F(q, uint,     key,        ALWAYS)       /* of its random numbers */ \
    F(q, vec3,     w,          ALWAYS)       /* direction of travel, in the shading frame, as all directions here */ \
    F(q, spectrum, beta,       ALWAYS) \
    F(q, uint,     spread,     ALWAYS)       /* 1: scattered by anything but mirrors since it entered the coat */ \
    F(q, float,    z,          LAYER_MEDIUM) /* height above the base */ \
    F(q, vec3,     wi,         ALWAYS)       /* eval: direction the light comes from */ \
    F(q, spectrum, f,          ALWAYS)       /* eval: sum found so far */ \
    F(q, vec3,     exit_w,     ALWAYS)       /* eval: direction below the coat, sampled by refracting wi */ \
    F(q, float,    exit_weight, ALWAYS)      /* eval: its weight */ \
    F(q, float,    exit_pdf,   ALWAYS)       /* eval: its density */

#endif
