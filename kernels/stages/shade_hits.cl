/* hit -> ray, shadow, walk, slot i to slot i; path.  Scatters each path at a surface: one shadow ray to one light, and one scattered ray.
   With ray splitting the stage runs in passes: pass r makes the r-th scattered ray, in slot i + r * pass_slots, and the shadow ray to the
   r-th light. Built once per BSDF (the macro BSDF), over that BSDF's segment of the hit queue. Straight-line unless the BSDF loops; if the
   slots take the random walks of a layered BSDF in step (BSDF_walks), each step is straight-line. */
#include "shade/scatter.clh"
#include "shade/ray_splitting.clh"
#include "stages/stage.clh"

#ifndef JOIN
#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)
#define BSDF_BOUND    JOIN(BSDF, _bound)
#define LOAD_BSDF     JOIN(load_, BSDF)
#define EVAL_BSDF     JOIN(eval_, BSDF)
#define PDF_BSDF      JOIN(pdf_, BSDF)
#define ALBEDO_BSDF   JOIN(albedo_, BSDF)
#define SAMPLE_BSDF   JOIN(sample_, BSDF)
#define BSDF_IS_DELTA JOIN(BSDF, _is_delta)
#define BSDF_LOOPS    JOIN(BSDF, _loops)
#define BSDF_IS_MATTE JOIN(BSDF, _is_matte)
#define SPLIT_BSDF    JOIN(split_, BSDF)
#define SPLIT_RAY_OF     JOIN(split_ray_, BSDF)
#endif

/* Scattered ray number `which`, with ray splitting. */
FN split_ray SPLIT_RAY_OF(__global const settings *frame, hit_item h, BSDF_BOUND b, vec3 wo, uint which, float lobe, vec2 u) {
#if BSDF_IS_DELTA
    return split_delta(frame, h, SPLIT_BSDF(b, wo), which, lobe, u);
#elif BSDF_IS_MATTE
    return no_split_ray();
#else
    return split_rough(frame, h, which, lobe, u);
#endif
}

/* A uniform direction, independent of the BSDF. */
FN bsdf_sample JOIN(scatter_uniformly_, BSDF)(BSDF_BOUND b, vec3 wo, vec2 u) {
    bsdf_sample s = absorbed_sample();
    s.wi = warp_sphere(u);
    s.weight = mul(EVAL_BSDF(b, wo, s.wi), fabs(s.wi.z) * (4.0f * PI));
    s.pdf = INV_4PI;
    return s;
}

FN scattering JOIN(shade_, BSDF)(light_tables lights, color_tables colors, __global const settings *frame, hit_item h, BSDF_BOUND b, uint shading_pass, int alive) {
    frame3 shading = HAS_ANISOTROPY ? make_frame(h.ns, h.tangent) : make_frame(h.ns);
    vec3 wo = to_local(shading, h.wo);
    float lobe = sample_1d(h.seed, h.sample, bounce_dimension_of(h.depth, dimension_lobe));
    vec2 u = sample_2d(h.seed, h.sample, bounce_dimension_of(h.depth, dimension_direction));
    split_ray way = no_split_ray();
    if (HAS_TREE) { way = SPLIT_RAY_OF(frame, h, b, wo, shading_pass, lobe, u); lobe = way.lobe; u = way.u; }
    scattering out;

    /* Next-event estimation */
    light_sample l = no_light();
    if (!BSDF_IS_DELTA && HAS_LIGHTS) {
        LIGHT_CHOICE_OF(h, alive, found)
        vec3 seen_from = light_origin(h);
        sampled_wavelengths wavelengths = path_wavelengths(colors, h.seed, h.sample);
        l = HAS_TREE ? sample_tree_light(lights, wavelengths, frame, h, seen_from, found, shading_pass)
                     : sample_light_at(lights, wavelengths, frame, h.seed, h.sample, h.depth, seen_from, found);
        vec3 wi = to_local(shading, l.wi);
        spectrum f = mul(EVAL_BSDF(b, wo, wi), fabs(wi.z));
        float pdf = HAS_UNIFORM_DIRECTIONS ? INV_4PI : PDF_BSDF(b, wo, wi);
        /* Without a scattered ray, only light sampling finds the light */
        if (HAS_TREE) pdf = way.spreads ? pdf : 0.0f;
        out.shadow = light_from_surface(h, seen_from, l, f, pdf, alive);
    } else out.shadow = no_shadow(h.path);

    /* Sample the BSDF */
    bsdf_sample s = HAS_UNIFORM_DIRECTIONS ? JOIN(scatter_uniformly_, BSDF)(b, wo, u) : SAMPLE_BSDF(b, wo, lobe, u);
    if (HAS_TREE) s.weight = mul(s.weight, way.weight);
    out.ray = ray_from_surface(frame, h, from_local(shading, s.wi), s, alive);
    if (HAS_TREE) out.ray = follow_split_ray(frame, out.ray, way);
    if (BSDF_IS_DELTA) out.ray.has_nonspecular_vertex = h.has_nonspecular_vertex;
    return out;
}

/* WALKS_IN_STEP: the slots of a work-item take each step of the layered random walk together. With one slot per work-item, each walks
   alone. */
#if JOIN(BSDF, _walks) && ITEMS_PER_WORK_ITEM > 1 && !WIDENS_GROUPS && !HAS_TREE && !HAS_UNIFORM_DIRECTIONS && !defined AS_LIBRARY
#define WALKS_IN_STEP 1
#include "shade/shade_walks.clh"
#else
#define WALKS_IN_STEP 0
#endif

#ifndef AS_LIBRARY
#define SHADE_HITS(TABLE, ARGUMENT) \
    LIGHT_TABLES(TABLE) BSDF_TABLES(TABLE) COLOR_TABLES(TABLE) \
    ARGUMENT(__global const settings *, frame) ARGUMENT(__global const uint *, hit) ARGUMENT(__global uint *, next_ray) \
    ARGUMENT(__global uint *, shadow) ARGUMENT(__global uint *, path) ARGUMENT(__global uint *, walk) ARGUMENT(uint, first) \
    ARGUMENT(uint, shading_pass) ARGUMENT(uint, pass_slots)
STAGE(shade_hits, SHADE_HITS) {
    light_tables light_set = BIND_LIGHTS;
    bsdf_tables bsdf_set = BIND_BSDFS;
    color_tables color_set = BIND_COLORS;
#if WALKS_IN_STEP
    if (count == 0u) return;
    if (HAS_LIGHTS) {
        aim_walks(light_set, color_set, frame, shadow, hit, walk, capacity, first, count, first_slot);
        eval_walks(hit, walk, capacity, first, count, first_slot);
    }
    sample_walks(hit, walk, capacity, first, count, first_slot);
#endif
    FOR_EACH_SLOT(at, count) {
        size_t i = first + at, to = HAS_TREE ? i + shading_pass * pass_slots : i;
        int alive = at < count;
        if (BSDF_LOOPS && !WALKS_IN_STEP && !alive) {
            /* Dead slots hold garbage; skip them where the BSDF loops */
            STORE_FIELD(ray, float, t_max, next_ray, capacity, to, -1.0f);
            STORE_FIELD(shadow, float, t_max, shadow, capacity, i, -1.0f);
            continue;
        }
        hit_item h = load_hit(hit, capacity, i);
        BSDF_BOUND b = bind_tables(LOAD_BSDF(hit, capacity, i), bsdf_set, path_wavelengths(color_set, h.seed, h.sample));
#if WALKS_IN_STEP
        layers between = layers_of(b);
        walked_surface seen = see_surface(h);
        walk_item walked = load_walk(walk, capacity, i);
        store_ray(next_ray, capacity, to, finish_ray(frame, &between, h, seen, walked, alive));
        if (HAS_LIGHTS) finish_light(shadow, capacity, i, &between, seen, walked);
#else
        scattering out = JOIN(shade_, BSDF)(light_set, color_set, frame, h, b, shading_pass, alive);
        store_ray(next_ray, capacity, to, out.ray);
        if (!BSDF_IS_DELTA && HAS_LIGHTS) store_shadow(shadow, capacity, i, out.shadow);
#endif
        if (BSDF_IS_DELTA || !HAS_LIGHTS) STORE_FIELD(shadow, float, t_max, shadow, capacity, i, -1.0f);
        if (HAS_AOVS && !BSDF_IS_DELTA && alive && !h.has_nonspecular_vertex) STORE_FIELD(path, spectrum, albedo, path, path_capacity, h.path, seen_albedo(h, ALBEDO_BSDF(b)));
    }
}
#endif
