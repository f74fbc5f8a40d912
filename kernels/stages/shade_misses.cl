/* miss -> path.  Adds the radiance of the environments along rays that left the scene. Straight-line; the number of environments is a
   build-time constant. */
#include "light/light.clh"
#include "shade/emission.clh"
#include "stages/stage.clh"

FN spectrum shade_miss(light_tables lights, color_tables color_set, miss_item m) {
    sampled_wavelengths colors = path_wavelengths(color_set, m.seed, m.sample);
    spectrum sum = uniform_spectrum(0.0f);
    _Pragma("unroll")
    for (int i = 0; i < ENVIRONMENTS; ++i) {
        light l = fetch(lights.lights + lights.environments[i]);
        light_emission e = eval_infinite_light(lights, colors, l, m.o, m.d, m.guide);
        sum = add(sum, weigh_emission(m.beta, e.Le, m.r_u, m.r_l, m.pdf, e.pdf));
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
