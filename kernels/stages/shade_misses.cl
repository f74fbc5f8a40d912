/* miss -> path.  Adds the radiance of the environments along rays that left the scene. Straight-line; the number of environments is a
   build-time constant. */
#include "light/light.clh"
#include "shade/emission.clh"
#include "stages/stage.clh"

FN spectrum shade_miss(light_tables lights, color_tables color_set, miss_item m) {
    sampled_wavelengths colors = path_wavelengths(color_set, m.seed, m.sample);
    spectrum sum = uniform_spectrum(0.0f);
    _Pragma("unroll")
    for (int e = 0; e < ENVIRONMENTS; ++e) {
        light l = fetch(lights.lights + lights.environments[e]);
        spectrum L = eval_color(colors, l.L), Le = uniform_spectrum(0.0f);
        float pdf = 0.0f;
        if (HAS_LIGHT_CONSTANT_ENVIRONMENT) {
            int matches = l.kind == kind_constant_environment;
            Le = choose(matches, eval_constant_environment(L), Le);
            float density = HAS_ENVIRONMENT_GUIDE ? pdf_guided_environment(lights, m.guide, m.d) : pdf_constant_environment();
            pdf = matches ? density : pdf;
        }
        if (HAS_LIGHT_IMAGE_ENVIRONMENT) {
            int matches = l.kind == kind_image_environment;
            spectrum texel = eval_image_environment(lights, colors, l, L, m.d);
            float density = pdf_image_environment(lights, l, m.d);
            Le = choose(matches, texel, Le);
            pdf = matches ? density : pdf;
        }
        if (HAS_LIGHT_PORTAL_ENVIRONMENT && HAS_PORTALS) {
            int matches = l.kind == kind_portal_environment;
            portal_light seen = eval_portal_environment(lights, colors, l, L, m.o, m.d);
            float density = seen.pdf;
            Le = choose(matches, seen.Le, Le);
            pdf = matches ? density : pdf;
        }
        sum = add(sum, weigh_emission(m.beta, Le, m.r_u, m.r_l, m.pdf, pdf * l.pmf));
    }
    return sum;
}

#ifndef AS_LIBRARY
#define SHADE_MISSES(TABLE, ARGUMENT) \
    LIGHT_TABLES(TABLE) COLOR_TABLES(TABLE) \
    ARGUMENT(__global const uint *, miss) ARGUMENT(__global uint *, path)
STAGE(shade_misses, SHADE_MISSES) {
    light_tables light_set = BIND_LIGHTS;
    color_tables color_set = BIND_COLORS;
    FOR_EACH_SLOT(i, count) {
        miss_item m = load_miss(miss, capacity, i);
        m.guide = i < count ? m.guide : 0u;
        spectrum L = shade_miss(light_set, color_set, m);
        add_radiance(path, path_capacity, i < count ? m.path : NOBODYS_PATH(i), L);
    }
}
#endif
