/* hit -> ray, shadow, slot i to slot i; path.  Scatters each path at a surface: a shadow ray to one light, and a ray on.
   Built once for each BSDF (the macro BSDF), over that BSDF's own segment of the hit queue. Straight-line, unless the BSDF loops. */
#include "scatter.clh"

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
#endif

/* A direction that knows nothing of the BSDF. */
FN bsdf_sample JOIN(scatter_uniformly_, BSDF)(BSDF_BOUND b, vec3 wo, vec2 u) {
    bsdf_sample s = absorbed_sample();
    s.wi = warp_sphere(u);
    s.weight = mul(EVAL_BSDF(b, wo, s.wi), fabs(s.wi.z) * (4.0f * PI));
    s.pdf = INV_4PI;
    return s;
}

FN scattering JOIN(shade_, BSDF)(light_tables lights, color_tables colors, __global const settings *frame, hit_item h, BSDF_BOUND b, int alive) {
    frame3 shading = HAS_ANISOTROPY ? make_frame(h.ns, h.tangent) : make_frame(h.ns);
    vec3 wo = to_local(shading, h.wo);
    scattering out;

    /* Light from one light, seen by the BSDF */
    light_sample l = no_light();
    if (!BSDF_IS_DELTA && HAS_LIGHTS) {
        vec3 seen_from = light_origin(h);
        l = sample_light_at(lights, path_palette(colors, h.seed, h.sample), frame, h.seed, h.sample, h.depth, seen_from);
        vec3 wi = to_local(shading, l.wi);
        spectrum f = mul(EVAL_BSDF(b, wo, wi), fabs(wi.z));
        out.shadow = light_from_surface(h, seen_from, l, f, HAS_UNIFORM_DIRECTIONS ? INV_4PI : PDF_BSDF(b, wo, wi), alive);
    } else out.shadow = no_shadow(h.path);

    /* On along the BSDF */
    float lobe = sample_1d(h.seed, h.sample, bounce_dimension_of(h.depth, dimension_lobe));
    vec2 u = sample_2d(h.seed, h.sample, bounce_dimension_of(h.depth, dimension_direction));
    bsdf_sample s = HAS_UNIFORM_DIRECTIONS ? JOIN(scatter_uniformly_, BSDF)(b, wo, u) : SAMPLE_BSDF(b, wo, lobe, u);
    out.ray = ray_from_surface(h, from_local(shading, s.wi), s, alive);
    if (BSDF_IS_DELTA) out.ray.seen = h.seen;
    return out;
}

#ifndef AS_LIBRARY
STAGE shade_hits(LIGHT_ARGUMENTS BSDF_ARGUMENTS COLOR_ARGUMENTS
                 __global const settings *frame, __global const uint *hit, __global uint *next_ray, __global uint *shadow, __global uint *path,
                 uint capacity, uint first, uint count) {
    light_tables light_set = BIND_LIGHTS;
    bsdf_tables bsdf_set = BIND_BSDFS;
    color_tables color_set = BIND_COLORS;
    FOR_EACH_SLOT(at, count) {
        size_t i = first + at;
        int alive = at < count;
        if (BSDF_LOOPS && !alive) {
            /* Nobody knows what such a slot would have it do */
            STORE_FIELD(ray, float, t_max, next_ray, capacity, i, -1.0f);
            STORE_FIELD(shadow, float, t_max, shadow, capacity, i, -1.0f);
            continue;
        }
        hit_item h = load_hit(hit, capacity, i);
        BSDF_BOUND b = bind_tables(LOAD_BSDF(hit, capacity, i), bsdf_set, path_palette(color_set, h.seed, h.sample));
        scattering out = JOIN(shade_, BSDF)(light_set, color_set, frame, h, b, alive);
        store_ray(next_ray, capacity, i, out.ray);
        if (!BSDF_IS_DELTA && HAS_LIGHTS) store_shadow(shadow, capacity, i, out.shadow);
        else STORE_FIELD(shadow, float, t_max, shadow, capacity, i, -1.0f);
        if (HAS_AOVS && !BSDF_IS_DELTA && alive && !h.seen) STORE_FIELD(path, spectrum, albedo, path, capacity, h.path, seen_albedo(h, ALBEDO_BSDF(b)));
    }
}
#endif
