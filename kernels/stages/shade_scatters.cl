/* scatter -> ray, shadow, slot i to slot i.  Scatters each path at a point in a medium: one shadow ray to one light, and one scattered ray.
   Straight-line. */
#include "shade/scatter.clh"
#include "medium/phase.clh"
#include "stages/stage.clh"

FN scattering shade_scatter(light_tables lights, color_tables colors, __global const settings *frame, scatter_item s, int alive) {
    scattering out;

    /* Next-event estimation with the phase function. Off inside subsurface bodies: their dielectric interface would block the shadow ray */
    int lit = HAS_SUBSURFACE ? alive & (s.within == 0u) : alive;
    shadow_item shadow = no_shadow(s.path);
    if (HAS_LIGHTS) {
        LIGHT_CHOICE_OF(s, alive, found)
        light_sample l = sample_light_at(lights, path_wavelengths(colors, s.seed, s.sample), frame, s.seed, s.sample, s.depth, s.p, found);
        float phase = eval_phase(s.g, s.wo, l.wi);
        shadow.seed = s.seed; shadow.sample = s.sample; shadow.depth = s.depth;
        shadow.time = s.time;
        shadow.o = s.p;
        shadow.medium = s.medium;
        shadow = light_contribution(shadow, s.beta, s.r_u, l, uniform_spectrum(phase), phase, lit);
    }
    out.shadow = shadow;

    /* Sample the phase function, whose pdf equals its value */
    vec2 u = sample_2d(s.seed, s.sample, bounce_dimension_of(s.depth, dimension_direction));
    vec3 wi = sample_phase(s.g, s.wo, u);
    float roll = sample_1d(s.seed, s.sample, bounce_dimension_of(s.depth, dimension_roulette));
    roulette game = play_roulette(frame, s.beta, s.r_u, HAS_TRANSMISSION ? s.eta_scale : 1.0f, s.depth, roll);
    ray_item r = new_ray(s);
    r.depth += 1;
    r.has_nonspecular_vertex = 1u;
    r.regularized = 1u;
    r.beta = game.beta;
    r.o = s.p;
    r.d = wi;
    r.t_max = alive & game.survives ? FAR_AWAY : -1.0f;
    float pdf = eval_phase(s.g, s.wo, wi);
    r.pdf = HAS_SUBSURFACE && s.within ? 0.0f : pdf;
    r.traveled = 0.0f;
    r.passed = 0u;
    r.guide = s.guide;
    r.n = make_vec3(0.0f, 0.0f, 0.0f);
    r.medium = s.medium;
    r.body = NONE;
    r.r_l = mul(s.r_u, 1.0f / max1(pdf, 1e-30f));
    out.ray = r;
    return out;
}

#ifndef AS_LIBRARY
#define SHADE_SCATTERS(TABLE, ARGUMENT) \
    LIGHT_TABLES(TABLE) COLOR_TABLES(TABLE) \
    ARGUMENT(__global const settings *, frame) ARGUMENT(__global const uint *, scatter) ARGUMENT(__global uint *, next_ray) \
    ARGUMENT(__global uint *, shadow) ARGUMENT(uint, first)
STAGE(shade_scatters, SHADE_SCATTERS) {
    light_tables light_set = BIND_LIGHTS;
    color_tables color_set = BIND_COLORS;
    FOR_EACH_SLOT(at, count) {
        size_t i = first + at;
        scattering out = shade_scatter(light_set, color_set, frame, load_scatter(scatter, capacity, i), at < count);
        store_ray(next_ray, capacity, i, out.ray);
        if (HAS_LIGHTS) store_shadow(shadow, capacity, i, out.shadow);
        else STORE_FIELD(shadow, float, t_max, shadow, capacity, i, -1.0f);
    }
}
#endif
