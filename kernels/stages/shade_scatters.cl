/* scatter -> next_ray, shadow, slot i to slot i.  Scatters each path at a point in a medium: one shadow ray to one light, and one
   scattered ray. Straight-line. */
#include "shade/shade_scatter.clh"
#include "stages/stage.clh"

#define SHADE_SCATTERS(TABLE, ARGUMENT) \
    LIGHT_TABLES(TABLE) COLOR_TABLES(TABLE) \
    ARGUMENT(__global const settings *, frame) ARGUMENT(__global const uint *, scatter) ARGUMENT(__global uint *, next_ray) \
    ARGUMENT(__global uint *, shadow) ARGUMENT(uint, first)
STAGE(shade_scatters, SHADE_SCATTERS) {
    light_tables light_set = BIND_LIGHTS;
    color_tables color_set = BIND_COLORS;
    FOR_EACH_SLOT_OF_GROUP(at, count) {
        size_t i = first + at;
        scattering out = shade_scatter(light_set, color_set, frame, load_scatter(scatter, capacity, i), at < count);
        store_ray(next_ray, capacity, i, out.ray);
        if (HAS_LIGHTS) store_shadow(shadow, capacity, i, out.shadow);
        else STORE_FIELD(shadow, float, t_max, shadow, capacity, i, -1.0f);
    }
}
