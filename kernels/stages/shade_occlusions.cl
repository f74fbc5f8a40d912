/* hit -> ray, shadow, slot i to slot i; path.  Ambient occlusion (Zhukov et al. 1998; pbrt-v4's "ambientocclusion"): for every surface, one
   shadow ray of limited length towards constant ambient light; no scattered ray. Straight-line. */
#include "shade/scatter.clh"
#include "stages/stage.clh"

FN shadow_item shade_occlusion(color_tables colors, __global const settings *frame, hit_item h, int alive) {
    /* Directions around the geometric normal, not the shading normal */
    vec3 n = mul(h.ng, dot3(h.ng, h.wo) < 0.0f ? -1.0f : 1.0f);
    vec2 u = sample_2d(h.seed, h.sample, bounce_dimension_of(h.depth, dimension_direction));
    int cosine = frame->ambient_cosine != 0u;
    vec3 by_cosine = warp_cosine_hemisphere(u), uniform = warp_sphere(u);
    uniform.z = fabs(uniform.z);
    vec3 w = choose(cosine, by_cosine, uniform), wi = from_local(make_frame(n), w);

    shadow_item s = new_shadow();
    s.path = h.path; s.seed = h.seed; s.sample = h.sample; s.depth = h.depth;
    s.time = h.time;
    s.o = offset_origin(h.p, h.offset, h.ng, wi);
    s.d = wi;
    s.t_max = alive ? frame->ambient_distance : -1.0f;
    /* cos / pi over the density: an unoccluded point gets 1 */
    s.Ld = mul(mul(h.beta, eval_color(path_wavelengths(colors, h.seed, h.sample), frame->ambient)), cosine ? 1.0f : 2.0f * w.z);
    s.element = NONE; s.color_seed = h.seed; s.color_sample = h.sample;
    s.medium = dot3(h.ng, wi) > 0.0f ? h.outside : h.inside;
    s.r_u = h.r_u;
    s.r_l = uniform_spectrum(0.0f);
    return s;
}

#ifndef AS_LIBRARY
#define SHADE_OCCLUSIONS(TABLE, ARGUMENT) \
    COLOR_TABLES(TABLE) \
    ARGUMENT(__global const settings *, frame) ARGUMENT(__global const uint *, hit) ARGUMENT(__global uint *, next_ray) \
    ARGUMENT(__global uint *, shadow) ARGUMENT(__global uint *, path) ARGUMENT(uint, first)
STAGE(shade_occlusions, SHADE_OCCLUSIONS) {
    color_tables color_set = BIND_COLORS;
    FOR_EACH_SLOT(at, count) {
        size_t i = first + at;
        int alive = at < count;
        hit_item h = load_hit(hit, capacity, i);
        store_shadow(shadow, capacity, i, shade_occlusion(color_set, frame, h, alive));
        STORE_FIELD(ray, float, t_max, next_ray, capacity, i, -1.0f);
        if (HAS_AOVS && alive) STORE_FIELD(path, spectrum, albedo, path, path_capacity, h.path, seen_albedo(h, uniform_spectrum(1.0f)));
    }
}
#endif
